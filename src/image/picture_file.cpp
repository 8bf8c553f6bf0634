// Picture files: which kind, and from there to its reader or writer.
#include "image/picture_file.h"

#include "image/bytes.h"
#include "image/netpbm.h"
#include "image/png.h"
#include "image/tga.h"

namespace {

/// Behind the last dot of the last part of the path, in small letters.
std::string endingOf(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] == '/') return "";
  std::string ending = path.substr(dot + 1);
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

FloatImage floatsOf(const Image& image) {
  FloatImage floats(image.Width(), image.Height());
  for (int y = 0; y < image.Height(); ++y) {
    for (int x = 0; x < image.Width(); ++x) {
      const Rgb8 pixel = image.getPixel(x, y);
      floats.setPixel(x, y, Vec3f(pixel.r / 255.0f, pixel.g / 255.0f, pixel.b / 255.0f));
    }
  }
  return floats;
}

}  // namespace

PictureFormat formatOf(const std::string& path) {
  const std::string ending = endingOf(path);
  if (ending == "png") return PictureFormat::png;
  if (ending == "ppm") return PictureFormat::ppm;
  if (ending == "pfm") return PictureFormat::pfm;
  return PictureFormat::tga;
}

void writePicture(const Image& image, const std::string& path, int threads) {
  switch (formatOf(path)) {
    case PictureFormat::tga:
      return writeTga(image, path);
    case PictureFormat::png:
      return writePng(image, path, threads);
    case PictureFormat::ppm:
      return writePpm(image, path);
    case PictureFormat::pfm:
      return writePfm(floatsOf(image), path);
  }
}

Image readImage(const std::string& path) {
  const Bytes bytes = readBytes(path);
  if (isPng(bytes)) return decodePng(bytes, path);
  if (isNetpbm(bytes)) return decodeNetpbm(bytes, path);
  return decodeTga(bytes, path);
}
