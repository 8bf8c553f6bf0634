// Fuzz target: the TGA reader.
#include "picture_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::readAndReadAgain(Bytes(data, data + size), PictureFormat::tga,
                         [](const Bytes& bytes) { return decodeTga(bytes, "in.tga"); });
  return 0;
}
