// Checkerboard: space in cubes of two materials by turns.
#pragma once
#include "shading/solid_texture.h"

class Checkerboard : public SolidTexture {
 public:
  /// size > 0 is the side of a cube. The first material is where floor(x / size) +
  /// floor(y / size) + floor(z / size) is even, (x, y, z) in the texture's space.
  Checkerboard(const Matrix& toTexture, const Part& first, const Part& second, double size = 1)
      : SolidTexture(toTexture, first, second), size_(size) {}

 private:
  double weightOfSecond(const Vec3d& p) const override;

  double size_;
};
