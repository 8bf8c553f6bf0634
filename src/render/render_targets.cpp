// RenderTargets as bytes. All pictures are gone through in the one order of forEachPicture, and
// none tells bytes from floats: a pixel is its bytes in memory, NaN and all. (On a machine of the
// other byte order, a kept tile would be another one: it is for the machine that has made it.)
#include "render/renderer.h"

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

}  // namespace

Vec2<int> RenderTargets::size() const {
  Vec2<int> size;
  forEachPicture(*this, [&size](std::uint32_t, const auto& picture, int zoom) {
    size = {picture.Width() / zoom, picture.Height() / zoom};
  });
  return size;
}

std::uint32_t RenderTargets::pictureBits() const {
  std::uint32_t bits = 0;
  forEachPicture(*this, [&bits](std::uint32_t bit, const auto&, int) { bits |= bit; });
  return bits;
}

std::vector<PixelBytes> RenderTargets::rowsOf(const PixelRectangle& area) const {
  std::vector<PixelBytes> rows;
  forEachPicture(*this, [&](std::uint32_t, auto& picture, int zoom) {
    const std::size_t size = sizeof picture.getPixel(0, 0) * std::size_t(area.width() * zoom);
    for (int y = area.bottom * zoom; y < area.top * zoom; ++y) {
      auto* const first = &picture.pixelAt(area.left * zoom, y);
      rows.push_back({reinterpret_cast<std::uint8_t*>(first), size});
    }
  });
  return rows;
}
