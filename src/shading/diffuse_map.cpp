// DiffuseMap: looking up a colour between the pixels of a picture, and making one from noise.
#include "shading/diffuse_map.h"

#include <algorithm>

#include "geometry/object3d.h"

namespace {

/// Two neighbours in a row of pixels, and the share of the second one.
struct Neighbours {
  int first, second;
  double share;
};

/// Around a position in 0..count - 1, to which any other is brought: NaN, for which every
/// comparison is false, becomes 0.
Neighbours neighboursOf(double position, int count) {
  const double inside = std::min(std::max(0.0, position), double(count - 1));
  const int first = int(inside);
  return {first, std::min(first + 1, count - 1), inside - first};
}

Vec3d mixed(const Vec3d& a, const Vec3d& b, double shareOfB) {
  return a * (1 - shareOfB) + b * shareOfB;
}

}  // namespace

Vec3d ImageTexture::colorAt(double u, double v) const {
  const int width = image_.Width(), height = image_.Height();
  const Neighbours columns = neighboursOf(u * width, width);
  const Neighbours rows = neighboursOf((1 - v) * height, height);
  const auto colorOf = [&](int column, int row) {
    const Rgb8 pixel = image_.getPixel(column, height - 1 - row);
    return Vec3d(pixel.r, pixel.g, pixel.b);
  };
  const auto colorIn = [&](int row) {
    return mixed(colorOf(columns.first, row), colorOf(columns.second, row), columns.share);
  };
  return mixed(colorIn(rows.first), colorIn(rows.second), rows.share) / 255;
}

Vec3d ImageTexture::colorAt(const Hit& hit, const Vec3f& plain) const {
  if (!hit.getObject() || !hit.getObject()->hasTextureCoordinates()) return plain;
  const Vec2d uv = hit.getTextureCoordinates();
  return colorAt(uv.x(), uv.y());
}

Vec3d NoiseMap::colorAt(const Hit& hit, const Vec3f& /*plain*/) const {
  const Vec3d& p = hit.getIntersectionPoint();
  return mixed(second_, first_, withinUnit(waves_.shareAt(p.x(), p)));
}
