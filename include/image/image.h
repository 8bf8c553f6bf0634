// Image: a picture of 8-bit RGB pixels. FloatImage: a picture of unclamped colours.
// Pixel (0, 0) is the lower left one: x counts to the right and y upwards, as the camera's do. (In
// most files the top row comes first; their readers and writers turn rows round.)
#pragma once
#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vec3.h"
#include "system/memory.h"

struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(Rgb8 p, Rgb8 q) { return p.r == q.r && p.g == q.g && p.b == q.b; }
  friend bool operator!=(Rgb8 p, Rgb8 q) { return !(p == q); }
};

static_assert(sizeof(Rgb8) == 3, "a row of them is a row of bytes");

/// int(component * 255) clamped to 0..255: truncated, not rounded. Below 1/255 (also negative, and
/// -infinity) it is 0, from 1 on (also infinity) 255; NaN is 0.
inline std::uint8_t byteFromComponent(float component) {
  // NaN, for which every comparison is false, is less than nothing here.
  return std::uint8_t(std::min(255.0f, std::max(0.0f, component * 255.0f)));
}
/// sample * 255 / most, rounded to nearest; for sample <= most <= 65535.
inline std::uint8_t byteFromSample(unsigned sample, unsigned most) {
  return std::uint8_t((sample * 255 + most / 2) / most);
}
/// byteFromComponent of red, green and blue, each on its own.
inline Rgb8 bytesFromColor(const Vec3f& color) {
  return {byteFromComponent(color.r()), byteFromComponent(color.g()), byteFromComponent(color.b())};
}

/// Rows of pixels.
template <class Pixel>
class PixelGrid {
 public:
  /// Without pixels; Width() and Height() are 0.
  PixelGrid() = default;
  /// Black. width and height are at least 1. On large pages: gigabytes of small ones take the
  /// system 0.3 s to give back, which a signal that ends the program would wait for; so it is
  /// 0.02 s.
  PixelGrid(int width, int height) : width_(width), height_(height) {
    assert(width >= 1 && height >= 1);
    const std::size_t count = std::size_t(width) * std::size_t(height);
    pixels_.reserve(count);
    preferLargePages(pixels_.data(), count * sizeof(Pixel));
    pixels_.resize(count);
  }

  int Width() const { return width_; }
  int Height() const { return height_; }
  /// 0 <= x < Width() and 0 <= y < Height().
  const Pixel& getPixel(int x, int y) const { return pixels_[index(x, y)]; }
  /// Likewise.
  void setPixel(int x, int y, const Pixel& value) { pixels_[index(x, y)] = value; }
  /// Likewise, to be changed; those to its right in the row lie behind it.
  Pixel& pixelAt(int x, int y) { return pixels_[index(x, y)]; }

 protected:
  std::size_t index(int x, int y) const {
    assert(x >= 0 && x < width_ && y >= 0 && y < height_);
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }

  int width_ = 0, height_ = 0;
  std::vector<Pixel> pixels_;  // the lowest row first, each from the left
};

/// Colours as they were computed, 1 being the brightest a screen shows; nothing is clamped, and
/// infinities and NaN are kept.
using FloatImage = PixelGrid<Vec3f>;

class Image : public PixelGrid<Rgb8> {
 public:
  using PixelGrid::PixelGrid;
  using PixelGrid::setPixel;

  /// Sets the bytes of a colour, see bytesFromColor.
  void setPixel(int x, int y, const Vec3f& color) { setPixel(x, y, bytesFromColor(color)); }
  /// Does that for all pixels.
  void setAllPixels(const Vec3f& color) {
    std::fill(pixels_.begin(), pixels_.end(), bytesFromColor(color));
  }
  /// Red, green and blue of each pixel of row y, from the left: 3 * Width() bytes, owned by this.
  const std::uint8_t* rowBytes(int y) const { return &getPixel(0, y).r; }
};
