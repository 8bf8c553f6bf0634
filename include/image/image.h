// Image: a picture of 8-bit RGB pixels.
// Pixel (0, 0) is the lower left one: y counts upwards, as the camera's does.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vec3.h"

struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(Rgb8 p, Rgb8 q) { return p.r == q.r && p.g == q.g && p.b == q.b; }
  friend bool operator!=(Rgb8 p, Rgb8 q) { return !(p == q); }
};

/// int(component * 255) clamped to 0..255: truncated, not rounded. NaN becomes 0.
std::uint8_t byteFromComponent(float component);
Rgb8 bytesFromColor(const Vec3f& color);

class Image {
 public:
  Image() = default;
  /// Black. width and height are at least 1.
  Image(int width, int height);

  int Width() const { return width_; }
  int Height() const { return height_; }
  Rgb8 getPixel(int x, int y) const { return pixels_[index(x, y)]; }
  void setPixel(int x, int y, Rgb8 value) { pixels_[index(x, y)] = value; }
  void setPixel(int x, int y, const Vec3f& color) { setPixel(x, y, bytesFromColor(color)); }
  void setAllPixels(const Vec3f& color);

 private:
  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }

  int width_ = 0, height_ = 0;
  std::vector<Rgb8> pixels_;
};
