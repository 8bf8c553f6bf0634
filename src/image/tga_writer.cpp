// TGA writer.
#include <algorithm>
#include <cassert>

#include "image/output_file.h"
#include "image/tga.h"

namespace {

constexpr int kLongestSide = 65535;  // 16 bits in the header
/// Rows are written in pieces of at least so many bytes, so that a picture stands in memory once.
constexpr std::size_t kPiece = 65536;

void setNumber(int number, std::uint8_t* bytes) {
  assert(number >= 0 && number <= kLongestSide);
  bytes[0] = static_cast<std::uint8_t>(number & 255);
  bytes[1] = static_cast<std::uint8_t>(number >> 8);
}

Bytes headerOf(int width, int height, const TgaPlace& place = {}) {
  assert(width >= 1 && height >= 1 && place.id.size() <= 255);
  constexpr std::size_t kHeader = 18;
  Bytes bytes(kHeader + place.id.size());
  bytes[0] = static_cast<std::uint8_t>(place.id.size());
  bytes[2] = 2;  // true colour, not compressed
  setNumber(place.x, &bytes[8]);
  setNumber(place.y, &bytes[10]);
  setNumber(width, &bytes[12]);
  setNumber(height, &bytes[14]);
  bytes[16] = 24;
  bytes[17] = 0x20;  // the top row comes first
  std::copy(place.id.begin(), place.id.end(), bytes.begin() + kHeader);
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

Bytes encodeTga(const Image& image, const TgaPlace& place) {
  Bytes bytes = headerOf(image.Width(), image.Height(), place);
  for (int y = image.Height() - 1; y >= 0; --y) appendRow(image, y, bytes);
  return bytes;
}

void writeTga(const Image& image, const std::string& path, const TgaPlace& place) {
  if (std::max(image.Width(), image.Height()) > kLongestSide) {
    throw OutputError(path, "a TGA image is at most 65535 pixels wide and high, this one is " +
                                std::to_string(image.Width()) + " x " +
                                std::to_string(image.Height()));
  }
  OutputFile file(path);
  Bytes bytes = headerOf(image.Width(), image.Height(), place);
  for (int y = image.Height() - 1; y >= 0; --y) {
    appendRow(image, y, bytes);
    if (bytes.size() < kPiece && y > 0) continue;
    file.write(bytes.data(), bytes.size());
    bytes.clear();
  }
  file.commit();
}

void writeTgaRows(int width, int height, const std::function<const Bytes&(int y)>& row,
                  const std::string& path) {
  OutputFile file(path);
  const Bytes header = headerOf(width, height);
  file.write(header.data(), header.size());
  for (int y = 0; y < height; ++y) {
    const Bytes& bytes = row(y);
    assert(bytes.size() == 3 * static_cast<std::size_t>(width));
    file.write(bytes.data(), bytes.size());
  }
  file.commit();
}
