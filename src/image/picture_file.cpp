// Picture files: which kind, and from there to its reader or writer.
// A writer's way: a picture becomes the head and the rows of its format, which go to a sink
// piece by piece; the sink appends to an OutputFile, or to bytes in memory. A reader's way: the
// whole file is read, and its first bytes say which decode function it is for; a TGA has none to
// tell by.
#include "image/picture_file.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "image/output_file.h"

namespace {

/// The rows of TGA and BMP have blue first; those of BMP begin at the bottom, each filled up with
/// zeros to a multiple of four bytes.
void encodeRows(const Image& image, PictureFormat format, const Bytes& head, const Sink& sink) {
  const bool isBmp = format == PictureFormat::bmp, isBlueFirst = format != PictureFormat::ppm;
  sink(head);
  for (int k = 0; k < image.Height(); ++k) {
    const std::uint8_t* const rgb = image.rowBytes(isBmp ? k : image.Height() - 1 - k);
    Bytes row(rgb, rgb + 3 * std::size_t(image.Width()));
    for (std::size_t i = 0; isBlueFirst && i < row.size(); i += 3) std::swap(row[i], row[i + 2]);
    row.resize(roundedUp(row.size(), isBmp ? 4 : 1));
    sink(row);
  }
}

/// Of a PFM.
Vec3f colorOf(Rgb8 pixel) { return Vec3f(pixel.r / 255.0f, pixel.g / 255.0f, pixel.b / 255.0f); }

/// The one place that knows all formats of an image.
void encode(const Image& image, PictureFormat format, int threads, const TgaPart& part,
            const Sink& sink) {
  const int width = image.Width(), height = image.Height();
  switch (format) {
    case PictureFormat::tga:
      return encodeRows(image, format, tgaHead(width, height, part), sink);
    case PictureFormat::png:
      return encodePng(image, sink, threads);
    case PictureFormat::bmp:
      return encodeRows(image, format, bmpHead(width, height), sink);
    case PictureFormat::ppm:
      return encodeRows(image, format, ppmHead(width, height), sink);
    case PictureFormat::pfm:
      return encodePfm(
          width, height, [&image](int x, int y) { return colorOf(image.getPixel(x, y)); }, sink);
  }
}

/// What the bytes begin as, where it is a format that others write and this program does not read;
/// null else.
const char* otherFormatOf(const Bytes& bytes) {
  static constexpr std::pair<std::string_view, const char*> kFormats[] = {
      {"\xff\xd8\xff", "a JPEG"}, {"GIF8", "a GIF"},  {{"II*\0", 4}, "a TIFF"},
      {{"MM\0*", 4}, "a TIFF"},   {"RIFF", "a WebP"},
  };
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const auto& [start, name] : kFormats) {
    if (text.substr(0, start.size()) == start) return name;
  }
  return nullptr;
}

/// Writes what encodeTo(sink) gives, in fewer and larger pieces: a row each would be many calls.
template <class EncodeTo>
void write(const std::string& path, const EncodeTo& encodeTo) {
  constexpr std::size_t kPiece = 65536;
  OutputFile file(path);
  Bytes waiting;
  waiting.reserve(2 * kPiece);
  encodeTo([&](const Bytes& piece) {
    waiting.insert(waiting.end(), piece.begin(), piece.end());
    if (waiting.size() < kPiece) return;
    file.write(waiting.data(), waiting.size());
    waiting.clear();
  });
  file.write(waiting.data(), waiting.size());
  file.commit();
}

}  // namespace

std::optional<PictureFormat> formatOf(const std::string& path, PictureFormat unnamed) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] == '/') return unnamed;
  std::string ending = path.substr(dot + 1);
  if (ending.empty()) return unnamed;
  // Of ASCII alone, whatever the locale says of capitals.
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  const auto found = std::find(std::begin(kPictureEndings), std::end(kPictureEndings), ending);
  if (found == std::end(kPictureEndings)) return std::nullopt;
  return PictureFormat(found - std::begin(kPictureEndings));
}

/// TGA has 16 bits for each side.
void checkPictureSize(const std::string& path, PictureFormat format, int width, int height) {
  const std::string size =
      ", this one is " + std::to_string(width) + " x " + std::to_string(height);
  if (format == PictureFormat::tga && std::max(width, height) > 65535) {
    throw OutputError(path, "a TGA image is at most 65535 pixels wide and high" + size);
  }
  if (format == PictureFormat::bmp && double(width) * height > 0x1p30) {
    throw OutputError(path, "a BMP image has at most 2^30 pixels here" + size);
  }
}

/// A size that is too large is told before the file is opened, which stays as it is.
void writePicture(const Image& image, const std::string& path, int threads, const TgaPart& part,
                  PictureFormat unnamed) {
  const PictureFormat format = formatOf(path, unnamed).value_or(PictureFormat::tga);
  checkPictureSize(path, format, image.Width(), image.Height());
  write(path, [&](const Sink& sink) { encode(image, format, threads, part, sink); });
}

void writePicture(const FloatImage& image, const std::string& path) {
  const auto colorAt = [&image](int x, int y) { return image.getPixel(x, y); };
  write(path, [&](const Sink& sink) { encodePfm(image.Width(), image.Height(), colorAt, sink); });
}

void writeTgaRows(int width, int height, const std::function<Bytes(int y)>& row,
                  const std::string& path) {
  write(path, [&](const Sink& sink) {
    sink(tgaHead(width, height, {}));
    for (int y = 0; y < height; ++y) sink(row(y));
  });
}

Bytes encodePicture(const Image& image, PictureFormat format) {
  Bytes all;
  encode(image, format, 1, {},
         [&all](const Bytes& piece) { all.insert(all.end(), piece.begin(), piece.end()); });
  return all;
}

Image readImage(const std::string& path, FloatImage* exact) {
  const Bytes bytes = readBytes(path);
  if (exact) *exact = FloatImage();
  // By content alone: a name may say anything, and a TGA begins with any bytes.
  if (isPng(bytes)) return decodePng(bytes, path, exact);
  if (isNetpbm(bytes)) return decodeNetpbm(bytes, path, exact);
  if (isBmp(bytes)) return decodeBmp(bytes, path);
  if (const char* const other = otherFormatOf(bytes)) {
    throw ImageError(path, std::string(other) + " file: convert it to PNG first");
  }
  return decodeTga(bytes, path);
}
