// Fuzz target: the TGA reader. Demands: a picture that was read is one that can be written, and
// reading that gives the same pixels again; an error is one line that prints.
#include "fuzz.h"
#include "image/picture_file.h"

namespace {

bool isSame(const Image& a, const Image& b) {
  if (a.Width() != b.Width() || a.Height() != b.Height()) return false;
  for (int y = 0; y < a.Height(); ++y) {
    for (int x = 0; x < a.Width(); ++x) {
      if (a.getPixel(x, y) != b.getPixel(x, y)) return false;
    }
  }
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Image image = decodeTga(Bytes(data, data + size), "in.tga");
    fuzz::demand(image.Width() >= 1 && image.Height() >= 1, "a picture has pixels");
    fuzz::demand(isSame(decodeTga(encodePicture(image, PictureFormat::tga), "again.tga"), image),
                 "writing and reading again gives the same picture");
  } catch (const ImageError& error) {
    fuzz::demand(fuzz::isPlainLine(error.what()), "an error is one line that prints");
  }
  return 0;
}
