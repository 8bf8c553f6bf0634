// The picture of a filter's weights. Colours and places as in the course's own pictures: MIT 6.837,
// "Supersampling and Antialiasing", 2004.
#include "render/filter_picture.h"

#include <cstdlib>

namespace {

constexpr Vec3f kBeyond(0, 0, 0.5f), kLine(0, 0, 1);

}  // namespace

Image drawFilter(const Filter& filter, int width, int height, int zoom) {
  const int reach = filter.getSupportRadius();
  Image image(width * zoom + 1, height * zoom + 1);
  for (int y = 0; y < image.Height(); ++y) {
    const int j = y / zoom - height / 2;  // the pixel's place, counted from the middle one
    for (int x = 0; x < image.Width(); ++x) {
      const int i = x / zoom - width / 2;
      if (x % zoom == 0 || y % zoom == 0) {
        image.setPixel(x, y, kLine);
      } else if (std::abs(i) > reach || std::abs(j) > reach) {
        image.setPixel(x, y, kBeyond);
      } else {
        const auto weight = float(
            filter.getWeight(i + double(x % zoom) / zoom - 0.5, j + double(y % zoom) / zoom - 0.5));
        image.setPixel(x, y, Vec3f(weight, weight, weight));
      }
    }
  }
  return image;
}
