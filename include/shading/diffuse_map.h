// DiffuseMap: a diffuse colour that differs from place to place; of its two kinds one looks it up
// in a picture, the other makes waves of noise.
// Sources: MIT 6.837, "Introduction to Computer Graphics", assignments 4 and 5 of 2012.
#pragma once
#include <cstddef>
#include <utility>

#include "geometry/hit.h"
#include "image/image.h"
#include "math/perlin_noise.h"
#include "math/vec3.h"

class DiffuseMap {
 public:
  virtual ~DiffuseMap() = default;
  /// RGB factors at the place that was hit, always finite; `plain` where the map has none there.
  virtual Vec3d colorAt(const Hit& hit, const Vec3f& plain) const = 0;
};

/// A picture that is laid over a surface by the surface's own coordinates u, to the right, and v,
/// upwards: from 0 to 1 they span the picture.
class ImageTexture : public DiffuseMap {
 public:
  /// Of at least one pixel; three bytes each are kept.
  explicit ImageTexture(Image image) : image_(std::move(image)) {}

  /// The colour between pixels, each component 0..1. With x = u W and y = (1 - v) H, where whole
  /// numbers are the pixels' columns from the left and rows from the top, it is the mean of the
  /// four pixels around, by weights that fall evenly with the distance on each axis. Beyond the
  /// outermost pixels, these go on; a coordinate that is NaN counts as 0.
  Vec3d colorAt(double u, double v) const;
  /// At the hit's texture coordinates; `plain` where the object has none.
  Vec3d colorAt(const Hit& hit, const Vec3f& plain) const override;

  /// Of memory.
  std::size_t byteCount() const {
    return sizeof(Rgb8) * std::size_t(image_.Width()) * std::size_t(image_.Height());
  }

 private:
  Image image_;
};

/// Waves across the x axis of the world, disturbed by noise: at a point p = (x, y, z) the first
/// colour has the weight waves.shareAt(x, p). Where that is NaN (an infinite angle) there is only
/// the second colour.
class NoiseMap : public DiffuseMap {
 public:
  NoiseMap(const Vec3f& first, const Vec3f& second, const math::NoisyWaves& waves)
      : first_(first), second_(second), waves_(waves) {}

  Vec3d colorAt(const Hit& hit, const Vec3f& plain) const override;

 private:
  Vec3d first_, second_;
  math::NoisyWaves waves_;
};
