// Marble: layers of two materials across the x axis, their bounds disturbed by noise.
#pragma once
#include "shading/solid_texture.h"

class Marble : public SolidTexture {
 public:
  /// 1 <= octaves <= math::kMaxOctaves. The second material has the weight
  /// (1 + sin(frequency x + amplitude N)) / 2, where N is math::fractalNoise at the point.
  /// Where that sine is NaN (an infinite angle) there is only the first material.
  Marble(const Matrix& toTexture, const Part& first, const Part& second, int octaves,
         double frequency, double amplitude)
      : SolidTexture(toTexture, first, second),
        octaves_(octaves),
        frequency_(frequency),
        amplitude_(amplitude) {}

 private:
  double weightOfSecond(const Vec3d& p) const override;

  int octaves_;
  double frequency_, amplitude_;
};
