// The picture of the samples.
#include "render/samples_picture.h"

#include <algorithm>

namespace {

/// The whole number below a coordinate within a pixel, counted in enlarged pixels.
int placeOf(double offset, int zoom) { return std::min(int(offset * zoom), zoom - 1); }

}  // namespace

void drawPixels(Image& picture, int zoom, const PixelRectangle& area) {
  for (int y = area.bottom * zoom; y < area.top * zoom; ++y) {
    for (int x = area.left * zoom; x < area.right * zoom; ++x) {
      const float grey = (x / zoom + y / zoom) % 2 == 0 ? 0.2f : 0.0f;
      picture.setPixel(x, y, Vec3f(grey, grey, grey));
    }
  }
}

void drawSample(Image& picture, int zoom, const Sample& sample, const Vec3f& color) {
  picture.setPixel(sample.at.i * zoom + placeOf(sample.offset.x(), zoom),
                   sample.at.j * zoom + placeOf(sample.offset.y(), zoom), color);
}
