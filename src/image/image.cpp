// Image: the byte rule, and filling.
#include "image/image.h"

#include <algorithm>
#include <cassert>

std::uint8_t byteFromComponent(float component) {
  const float scaled = component * 255.0f;
  if (!(scaled >= 1.0f)) return 0;  // also NaN, for which every comparison is false
  return scaled >= 255.0f ? std::uint8_t{255} : static_cast<std::uint8_t>(scaled);
}

Rgb8 bytesFromColor(const Vec3f& color) {
  return {byteFromComponent(color.r()), byteFromComponent(color.g()), byteFromComponent(color.b())};
}

Image::Image(int width, int height) : width_(width), height_(height) {
  assert(width >= 1 && height >= 1);
  pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

void Image::setAllPixels(const Vec3f& color) {
  std::fill(pixels_.begin(), pixels_.end(), bytesFromColor(color));
}
