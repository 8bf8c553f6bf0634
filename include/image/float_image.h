// FloatImage: a picture of unclamped colours, three floats a pixel.
// Pixel (0, 0) is the lower left one, as in Image.
#pragma once
#include <cstddef>
#include <vector>

#include "math/vec3.h"

class FloatImage {
 public:
  FloatImage() = default;
  /// Black. width and height are at least 1.
  FloatImage(int width, int height);

  int Width() const { return width_; }
  int Height() const {
    return width_ == 0 ? 0 : static_cast<int>(pixels_.size() / std::size_t(width_));
  }
  const Vec3f& getPixel(int x, int y) const { return pixels_[index(x, y)]; }
  void setPixel(int x, int y, const Vec3f& color) { pixels_[index(x, y)] = color; }

 private:
  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }

  int width_ = 0;
  std::vector<Vec3f> pixels_;
};
