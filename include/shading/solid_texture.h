// SolidTexture: a material that is mixed, point by point in space, from two others; and the five
// kinds of it, which differ in how much of the second material there is at a point.
//
// What a texture is made of may be textures again, to any depth; at every point it comes down to a
// few plain materials, each with a weight, and the ray tracer treats the point as each of them in
// turn. A texture lies in space, not on a surface: `toTexture` takes a point of the world to the
// space in which the pattern is described, so the objects look as if carved out of it.
#pragma once
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "math/matrix.h"
#include "math/perlin_noise.h"
#include "shading/material.h"

/// A material and its share in a point, above 0 and at most 1.
struct WeightedMaterial {
  const Material* material;  ///< not owned
  double weight;
};

class SolidTexture : public Material {
 public:
  /// The weight of the second component at a point of the texture's space. Below 0 counts as 0,
  /// above 1 as 1, NaN as 0.
  using Pattern = std::function<double(const Vec3d& p)>;

  /// `kind` is what getKind gives. `toTexture` may be singular. The components are not owned; where
  /// one of them is a texture, each has its number (Material::getNumber), one above those of its
  /// own components. As a Material the texture has, channel by channel, the largest of its
  /// components' colours, so that neither is transparent or reflective where the texture says that
  /// it is not, and the index and priority of the first.
  SolidTexture(const char* kind, const Matrix& toTexture, const Material* first,
               const Material* second, Pattern weightOfSecond);

  /// What mixAt works on: who asks for many points keeps one, and so its memory.
  struct Mixture {
    std::vector<WeightedMaterial> plain;
    /// Components that are still to be looked at, each once, by rising numbers; none in the end.
    std::vector<WeightedMaterial> waiting;
  };

  /// The plain materials that the texture comes down to at a point of the world, each once, by
  /// falling numbers, owned by `mixture`; their weights add up to 1 but for rounding. Never empty.
  /// Looks at each texture below this one once, in however many ways it is reached, and takes no
  /// stack.
  const std::vector<WeightedMaterial>& mixAt(const Vec3d& point, Mixture& mixture) const;
  std::vector<WeightedMaterial> materialsAt(const Vec3d& point) const {
    Mixture mixture;
    mixAt(point, mixture);
    return std::move(mixture.plain);
  }

  /// The mean of the components' light, by weight, at the point that was hit.
  Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
              const Vec3f& lightColor) const override;
  const SolidTexture* asTexture() const override { return this; }
  const char* getKind() const override { return kind_; }

 private:
  double clampedWeight(const Vec3d& point) const;

  const char* kind_;
  Matrix toTexture_;
  const Material *first_, *second_;
  Pattern weightOfSecond_;
};

/// Space in cubes of the two materials by turns.
class Checkerboard : public SolidTexture {
 public:
  /// size > 0 is the side of a cube. The first material is where floor(x / size) +
  /// floor(y / size) + floor(z / size) is even, (x, y, z) in the texture's space.
  Checkerboard(const Matrix& toTexture, const Material* first, const Material* second,
               double size = 1)
      : SolidTexture("Checkerboard", toTexture, first, second, [=](const Vec3d& p) {
          int parity = 0;  // a sum is odd where an odd number of its terms is
          for (int axis = 0; axis < 3; ++axis) parity ^= math::floorBits(p[axis] / size, 1);
          return parity;
        }) {}
};

/// Soft clouds: the second material has the weight 1/2 + slope N, N being math::fractalNoise.
class Noise : public SolidTexture {
 public:
  /// 0 <= octaves <= math::kMaxOctaves; slope is any finite number.
  Noise(const Matrix& toTexture, const Material* first, const Material* second, int octaves,
        double slope = 0.5)
      : SolidTexture("Noise", toTexture, first, second,
                     [=](const Vec3d& p) { return 0.5 + slope * math::fractalNoise(p, octaves); }) {
  }
};

/// Layers across the x axis, waves that are disturbed by noise: the second material has the weight
/// waves.shareAt(x, p) at p = (x, y, z) in the texture's space. Where that is NaN (an infinite
/// angle) there is only the first.
class Marble : public SolidTexture {
 public:
  Marble(const Matrix& toTexture, const Material* first, const Material* second,
         const math::NoisyWaves& waves)
      : SolidTexture("Marble", toTexture, first, second,
                     [=](const Vec3d& p) { return waves.shareAt(p.x(), p); }) {}
};

/// Rings around the y axis: as Marble, with the distance sqrt(x^2 + z^2) from that axis for x.
class Wood : public SolidTexture {
 public:
  Wood(const Matrix& toTexture, const Material* first, const Material* second,
       const math::NoisyWaves& waves)
      : SolidTexture("Wood", toTexture, first, second, [=](const Vec3d& p) {
          return waves.shareAt(std::sqrt(p.x() * p.x() + p.z() * p.z()), p);
        }) {}
};

/// Wood with narrow dark rings and a long grain: rings around the y axis that lean a little, and
/// noise that is stretched five times along it. The first material has the weight s^2, with
///   s = 1/2 + sin(frequency (sqrt(x^2 + z^2) + 0.05 y) + amplitude N(x, 0.2 y, z)), within 0..1.
class GrainedWood : public SolidTexture {
 public:
  GrainedWood(const Matrix& toTexture, const Material* first, const Material* second,
              const math::NoisyWaves& waves)
      : SolidTexture("Wood", toTexture, first, second, [=](const Vec3d& p) {
          const double rings = std::sqrt(p.x() * p.x() + p.z() * p.z()) + 0.05 * p.y();
          const double s = withinUnit(0.5 + waves.sineAt(rings, {p.x(), 0.2 * p.y(), p.z()}));
          return 1 - s * s;
        }) {}
};
