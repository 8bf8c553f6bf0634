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

/// Calls visit(picture, x, y, width) for the rows of `area` in the pictures that are named: `width`
/// pixels from (x, y) on.
template <class Visit>
void forEachRow(const RenderTargets& targets, std::uint32_t pictures, const PixelRectangle& area,
                const Visit& visit) {
  forEachPicture(targets, [&](std::uint32_t bit, auto& picture, int zoom) {
    if ((pictures & bit) == 0) return;
    for (int y = area.bottom * zoom; y < area.top * zoom; ++y) {
      visit(picture, area.left * zoom, y, area.width() * zoom);
    }
  });
}

/// The pixels that the pictures have, enlarged ones counted as if they were not.
PixelRectangle wholeArea(const RenderTargets& targets) {
  PixelRectangle whole = {0, 0, 0, 0};
  forEachPicture(targets, [&whole](std::uint32_t, const auto& picture, int zoom) {
    whole = {0, 0, picture.Width() / zoom, picture.Height() / zoom};
  });
  return whole;
}

/// How many tiles it takes to hold so many pixels of a row or a column.
std::uint32_t tilesAlong(int pixels) {
  return std::uint32_t((pixels + TileStore::kSide - 1) / TileStore::kSide);
}

}  // namespace

std::uint32_t pictureBits(const RenderTargets& targets) {
  std::uint32_t bits = 0;
  forEachPicture(targets, [&bits](std::uint32_t bit, const auto&, int) { bits |= bit; });
  return bits;
}

std::size_t tileCount(const RenderTargets& targets) {
  const PixelRectangle whole = wholeArea(targets);
  return std::size_t(tilesAlong(whole.right)) * tilesAlong(whole.top);
}

/// The last tile of a row or column may be cut off by the edge of the pictures.
PixelRectangle tileArea(const RenderTargets& targets, std::uint32_t number) {
  const PixelRectangle whole = wholeArea(targets);
  const std::uint32_t columns = tilesAlong(whole.right);
  const int left = int(number % columns) * TileStore::kSide;
  const int bottom = int(number / columns) * TileStore::kSide;
  return {left, bottom, std::min(left + TileStore::kSide, whole.right),
          std::min(bottom + TileStore::kSide, whole.top)};
}

/// An edge within the pictures lies between two tiles; one at their end may lie in the last tile,
/// which tilesAlong counts as a whole one.
std::vector<std::uint32_t> tilesIn(const RenderTargets& targets, const PixelRectangle& area) {
  const std::uint32_t columns = tilesAlong(wholeArea(targets).right);
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t j = tilesAlong(area.bottom); j < tilesAlong(area.top); ++j) {
    for (std::uint32_t i = tilesAlong(area.left); i < tilesAlong(area.right); ++i) {
      numbers.push_back(j * columns + i);
    }
  }
  return numbers;
}

std::size_t tileByteCount(const RenderTargets& targets, std::uint32_t pictures,
                          const PixelRectangle& area) {
  std::size_t bytes = 0;
  forEachRow(targets, pictures, area, [&bytes](const auto& picture, int x, int y, int width) {
    bytes += sizeof picture.getPixel(x, y) * std::size_t(width);
  });
  return bytes;
}

/// A row of a tile lies in one piece. Called while other threads write to other tiles: no pixel
/// outside `area` is read.
Bytes tileBytes(const RenderTargets& targets, std::uint32_t pictures, const PixelRectangle& area) {
  Bytes bytes(tileByteCount(targets, pictures, area));
  std::uint8_t* next = bytes.data();
  forEachRow(targets, pictures, area, [&next](const auto& picture, int x, int y, int width) {
    const std::size_t size = sizeof picture.getPixel(x, y) * std::size_t(width);
    std::memcpy(next, &picture.getPixel(x, y), size);
    next += size;
  });
  return bytes;
}

/// Pixel by pixel, as a picture gives nobody its memory to write to.
void setTileBytes(const RenderTargets& targets, std::uint32_t pictures, const PixelRectangle& area,
                  const std::uint8_t* bytes) {
  forEachRow(targets, pictures, area, [&bytes](auto& picture, int x, int y, int width) {
    for (int i = 0; i < width; ++i) {
      auto pixel = picture.getPixel(x + i, y);
      std::memcpy(&pixel, bytes, sizeof pixel);
      picture.setPixel(x + i, y, pixel);
      bytes += sizeof pixel;
    }
  });
}
