// Tiles as bytes. Every function goes through the pictures in the one order of forEachPicture, and
// none tells bytes from floats: a pixel is its bytes in memory, NaN and all. (On a machine of the
// other byte order, a kept tile would be another one: it is for the machine that has made it.)
#include "render/tile_bytes.h"

#include <cstring>

namespace {

static_assert(sizeof(Rgb8) == 3 && sizeof(Vec3f) == 12, "pixels lie side by side");

/// Calls visit(bit, picture, zoom) for each picture that there is, an Image or a FloatImage. Exact
/// floats have bits of their own, but never come without the picture of the same name.
template <class Visit>
void forEachPicture(const RenderTargets& targets, const Visit& visit) {
  const auto offer = [&visit](int bit, auto* picture, int zoom) {
    if (picture) visit(std::uint32_t(1) << bit, *picture, zoom);
  };
  offer(0, targets.color, 1);
  offer(1, targets.depth, 1);
  offer(2, targets.normals, 1);
  offer(3, targets.samples, targets.samplesZoom);
  offer(4, targets.exactColor, 1);
  offer(5, targets.exactDepth, 1);
  offer(6, targets.exactNormals, 1);
  offer(7, targets.materials, 1);
}

/// Calls visit(picture, x, y, width) for the rows of `area` in all pictures: `width` pixels from
/// (x, y) on.
template <class Visit>
void forEachRow(const RenderTargets& targets, const PixelRectangle& area, const Visit& visit) {
  forEachPicture(targets, [&](std::uint32_t, auto& picture, int zoom) {
    for (int y = area.bottom * zoom; y < area.top * zoom; ++y) {
      visit(picture, area.left * zoom, y, area.width() * zoom);
    }
  });
}

}  // namespace

std::uint32_t pictureBits(const RenderTargets& targets) {
  std::uint32_t bits = 0;
  forEachPicture(targets, [&bits](std::uint32_t bit, const auto&, int) { bits |= bit; });
  return bits;
}

std::size_t tileByteCount(const RenderTargets& targets, const PixelRectangle& area) {
  std::size_t bytes = 0;
  forEachRow(targets, area, [&bytes](const auto& picture, int x, int y, int width) {
    bytes += sizeof picture.getPixel(x, y) * std::size_t(width);
  });
  return bytes;
}

/// A row of a tile lies in one piece. Called while other threads write to other tiles: no pixel
/// outside `area` is read.
Bytes tileBytes(const RenderTargets& targets, const PixelRectangle& area) {
  Bytes bytes(tileByteCount(targets, area));
  std::uint8_t* next = bytes.data();
  forEachRow(targets, area, [&next](const auto& picture, int x, int y, int width) {
    const std::size_t size = sizeof picture.getPixel(x, y) * std::size_t(width);
    std::memcpy(next, &picture.getPixel(x, y), size);
    next += size;
  });
  return bytes;
}

/// Pixel by pixel, as a picture gives nobody its memory to write to.
void setTileBytes(const RenderTargets& targets, const PixelRectangle& area,
                  const std::uint8_t* bytes) {
  forEachRow(targets, area, [&bytes](auto& picture, int x, int y, int width) {
    for (int i = 0; i < width; ++i) {
      auto pixel = picture.getPixel(x + i, y);
      std::memcpy(&pixel, bytes, sizeof pixel);
      picture.setPixel(x + i, y, pixel);
      bytes += sizeof pixel;
    }
  });
}
