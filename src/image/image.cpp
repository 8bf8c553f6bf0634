// Image and FloatImage: making and filling.
#include "image/image.h"

#include <algorithm>

#include "system/memory.h"

/// On large pages: gigabytes of small ones take the system 0.3 s to give back, which a signal that
/// ends the program would wait for; so it is 0.02 s.
template <class Pixel>
PixelGrid<Pixel>::PixelGrid(int width, int height) : width_(width), height_(height) {
  assert(width >= 1 && height >= 1);
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  pixels_.reserve(count);
  preferLargePages(pixels_.data(), count * sizeof(Pixel));
  pixels_.resize(count);
}

template class PixelGrid<Rgb8>;
template class PixelGrid<Vec3f>;

void Image::setAllPixels(const Vec3f& color) {
  std::fill(pixels_.begin(), pixels_.end(), bytesFromColor(color));
}
