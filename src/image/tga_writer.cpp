// TGA writer.
#include <algorithm>
#include <cassert>

#include "image/output_file.h"
#include "image/tga.h"

namespace {

constexpr int kLongestSide = 65535;  // 16 bits in the header
/// Rows are written in pieces of at least so many bytes, so that a picture stands in memory once.
constexpr std::size_t kPiece = 65536;

Bytes headerOf(const Image& image) {
  const auto width = static_cast<unsigned>(image.Width());
  const auto height = static_cast<unsigned>(image.Height());
  assert(width >= 1 && width <= kLongestSide && height >= 1 && height <= kLongestSide);
  Bytes bytes(18);
  bytes[2] = 2;  // true colour, not compressed
  bytes[12] = static_cast<std::uint8_t>(width & 255);
  bytes[13] = static_cast<std::uint8_t>(width >> 8);
  bytes[14] = static_cast<std::uint8_t>(height & 255);
  bytes[15] = static_cast<std::uint8_t>(height >> 8);
  bytes[16] = 24;
  bytes[17] = 0x20;  // the top row comes first
  return bytes;
}

/// Blue comes first in the file. Bytes are stored where they belong: growing the piece pixel by
/// pixel took 1.5 times the instructions.
void appendRow(const Image& image, int y, Bytes& bytes) {
  const std::size_t before = bytes.size();
  bytes.resize(before + 3 * static_cast<std::size_t>(image.Width()));
  std::uint8_t* next = &bytes[before];
  for (int x = 0; x < image.Width(); ++x) {
    const Rgb8 pixel = image.getPixel(x, y);
    *next++ = pixel.b;
    *next++ = pixel.g;
    *next++ = pixel.r;
  }
}

}  // namespace

Bytes encodeTga(const Image& image) {
  Bytes bytes = headerOf(image);
  for (int y = image.Height() - 1; y >= 0; --y) appendRow(image, y, bytes);
  return bytes;
}

void writeTga(const Image& image, const std::string& path) {
  if (std::max(image.Width(), image.Height()) > kLongestSide) {
    throw OutputError(path, "a TGA image is at most 65535 pixels wide and high, this one is " +
                                std::to_string(image.Width()) + " x " +
                                std::to_string(image.Height()));
  }
  OutputFile file(path);
  Bytes bytes = headerOf(image);
  for (int y = image.Height() - 1; y >= 0; --y) {
    appendRow(image, y, bytes);
    if (bytes.size() < kPiece && y > 0) continue;
    file.write(bytes.data(), bytes.size());
    bytes.clear();
  }
  file.commit();
}
