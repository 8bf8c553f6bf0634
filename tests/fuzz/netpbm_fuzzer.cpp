// Fuzz target: the reader of PPM, PGM and PFM. Demands besides: floats are written and read again
// to the last bit, and a picture does not differ from itself, whatever its floats are.
#include <cstring>

#include "picture_reader.h"

namespace {

bool isSame(const FloatImage& a, const FloatImage& b) {
  for (int y = 0; y < a.Height(); ++y) {
    for (int x = 0; x < a.Width(); ++x) {
      const Vec3f p = a.getPixel(x, y), q = b.getPixel(x, y);
      if (std::memcmp(&p, &q, sizeof p) != 0) return false;
    }
  }
  return a.Width() == b.Width() && a.Height() == b.Height();
}

void demandFloats(const Bytes& input) {
  ReadPicture picture;
  picture.image = decodeNetpbm(input, "in.pfm", &picture.exact);
  if (picture.exact.Width() == 0) return;
  Bytes file;
  encodePfm(
      picture.exact.Width(), picture.exact.Height(),
      [&](int x, int y) { return picture.exact.getPixel(x, y); },
      [&](const Bytes& piece) { file.insert(file.end(), piece.begin(), piece.end()); });
  ReadPicture again;
  again.image = decodeNetpbm(file, "again.pfm", &again.exact);
  fuzz::demand(isSame(picture.exact, again.exact), "floats are read again to the last bit");
  fuzz::demand(compare(picture, again, 0).maximum == 0, "a picture does not differ from itself");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes input(data, data + size);
  fuzz::readAndReadAgain(input, PictureFormat::ppm,
                         [](const Bytes& bytes) { return decodeNetpbm(bytes, "in.ppm"); });
  try {
    demandFloats(input);
  } catch (const ImageError&) {  // said above
  }
  return 0;
}
