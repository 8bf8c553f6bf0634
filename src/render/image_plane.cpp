// The order of pixels.
#include "render/image_plane.h"

std::vector<Pixel> pixelsInOrder(const PixelRectangle& area) {
  constexpr int kBlock = 16;
  const auto blockStart = [](int at) { return at - (at % kBlock + kBlock) % kBlock; };
  std::vector<Pixel> pixels;
  pixels.reserve(area.pixelCount());
  for (int j = blockStart(area.bottom); j < area.top; j += kBlock) {
    for (int i = blockStart(area.left); i < area.right; i += kBlock) {
      for (int place = 0; place < kBlock * kBlock; ++place) {
        const Pixel at = {i + evenBits(place), j + evenBits(place >> 1)};
        if (area.contains(at)) pixels.push_back(at);
      }
    }
  }
  return pixels;
}
