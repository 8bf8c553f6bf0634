// Fuzz target: the BMP reader.
#include "picture_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::readAndReadAgain(Bytes(data, data + size), PictureFormat::bmp,
                         [](const Bytes& bytes) { return decodeBmp(bytes, "in.bmp"); });
  return 0;
}
