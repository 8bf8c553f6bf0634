// SolidTexture: a material that is mixed, point by point in space, from two others.
// What it is made of may be textures again, to any depth; at every point it comes down to a few
// plain materials, each with a weight, and the ray tracer treats the point as each of them in turn.
#pragma once
#include <cstddef>
#include <vector>

#include "math/matrix.h"
#include "shading/material.h"

/// A plain material (none that is a texture) and its part in a point, above 0 and at most 1.
struct WeightedMaterial {
  const Material* material;  ///< not owned
  double weight;
};

class SolidTexture : public Material {
 public:
  /// A material as a texture refers to it: not owned. Every material of a scene has a place of its
  /// own, and textures refer only to places before theirs.
  struct Part {
    const Material* material;
    std::size_t place;
  };

  /// `toTexture` takes points of the world to the space that the texture is described in; it may be
  /// singular. As a Material the texture has the largest of its parts' colours, by component, so
  /// that no part is transparent or reflective where the texture says that it is not, and the first
  /// part's index and priority.
  SolidTexture(const Matrix& toTexture, const Part& first, const Part& second);

  /// The plain materials at a point of the world, each once, latest place first; their weights add
  /// up to 1 but for rounding. Never empty. Takes time in proportion to the textures below this one
  /// (a texture that is reached in many ways is looked at once), and no stack.
  std::vector<WeightedMaterial> partsAt(const Vec3d& point) const;

  /// The mean of the parts' light, by weight, at the point that was hit.
  Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
              const Vec3f& lightColor) const override;
  const SolidTexture* asTexture() const override { return this; }

 private:
  /// The weight of the second part at a point of the texture's space. Below 0 counts as 0, above 1
  /// as 1, NaN as 0.
  virtual double weightOfSecond(const Vec3d& p) const = 0;

  double clampedWeight(const Vec3d& point) const;

  Matrix toTexture_;
  Part first_, second_;
};
