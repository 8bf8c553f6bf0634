// Noise: two materials in soft clouds.
#pragma once
#include "shading/solid_texture.h"

class Noise : public SolidTexture {
 public:
  /// 1 <= octaves <= math::kMaxOctaves. The second material has the weight (1 + N) / 2, clamped to
  /// 0..1, where N is math::fractalNoise at the point.
  Noise(const Matrix& toTexture, const Part& first, const Part& second, int octaves)
      : SolidTexture(toTexture, first, second), octaves_(octaves) {}

 private:
  double weightOfSecond(const Vec3d& p) const override;

  int octaves_;
};
