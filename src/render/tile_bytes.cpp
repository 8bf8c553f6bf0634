// The pixels of a tile as bytes.
#include "render/tile_bytes.h"

#include <array>

namespace {

struct Picture {
  Image* image;  // null where it is not wanted
  int zoom;
};

/// All kinds, in the order of their bits.
std::array<Picture, kPictureKinds> picturesOf(const RenderTargets& targets) {
  return {{{targets.color, 1},
           {targets.depth, 1},
           {targets.normals, 1},
           {targets.samples, targets.samplesZoom}}};
}

/// Calls visit(image, x, y) for all pixels of `area` in their order.
template <class Visit>
void forEachPixel(const RenderTargets& targets, const PixelRectangle& area, const Visit& visit) {
  for (const Picture& picture : picturesOf(targets)) {
    if (!picture.image) continue;
    for (int y = area.bottom * picture.zoom; y < area.top * picture.zoom; ++y) {
      for (int x = area.left * picture.zoom; x < area.right * picture.zoom; ++x) {
        visit(*picture.image, x, y);
      }
    }
  }
}

}  // namespace

unsigned pictureBits(const RenderTargets& targets) {
  unsigned bits = 0, bit = 1;
  for (const Picture& picture : picturesOf(targets)) {
    if (picture.image) bits |= bit;
    bit *= 2;
  }
  return bits;
}

RenderTargets withPictures(const RenderTargets& targets, unsigned bits) {
  RenderTargets some = targets;
  if (!(bits & 1)) some.color = nullptr;
  if (!(bits & 2)) some.depth = nullptr;
  if (!(bits & 4)) some.normals = nullptr;
  if (!(bits & 8)) some.samples = nullptr;
  return some;
}

std::size_t tileByteCount(const RenderTargets& targets, const PixelRectangle& area) {
  std::size_t pixels = 0;
  for (const Picture& picture : picturesOf(targets)) {
    const auto zoom = std::size_t(picture.zoom);
    if (picture.image) pixels += area.pixelCount() * zoom * zoom;
  }
  return 3 * pixels;
}

void appendTileBytes(const RenderTargets& targets, const PixelRectangle& area, Bytes& bytes) {
  bytes.reserve(bytes.size() + tileByteCount(targets, area));
  forEachPixel(targets, area, [&](const Image& image, int x, int y) {
    const Rgb8 pixel = image.getPixel(x, y);
    bytes.insert(bytes.end(), {pixel.r, pixel.g, pixel.b});
  });
}

void setTileBytes(const RenderTargets& targets, const PixelRectangle& area,
                  const std::uint8_t* bytes) {
  forEachPixel(targets, area, [&](Image& image, int x, int y) {
    image.setPixel(x, y, Rgb8{bytes[0], bytes[1], bytes[2]});
    bytes += 3;
  });
}
