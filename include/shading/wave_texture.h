// WaveTexture: two materials in waves along a distance, their bounds disturbed by noise.
#pragma once
#include "shading/solid_texture.h"

class WaveTexture : public SolidTexture {
 public:
  /// 1 <= octaves <= math::kMaxOctaves. The second material has the weight
  /// (1 + sin(frequency d + amplitude N)) / 2, where d is distanceAt the point and N is
  /// math::fractalNoise there. Where that sine is NaN (an infinite angle) there is only the first
  /// material.
  WaveTexture(const Matrix& toTexture, const Part& first, const Part& second, int octaves,
              double frequency, double amplitude)
      : SolidTexture(toTexture, first, second),
        octaves_(octaves),
        frequency_(frequency),
        amplitude_(amplitude) {}

 private:
  double weightOfSecond(const Vec3d& p) const override;
  virtual double distanceAt(const Vec3d& p) const = 0;

  int octaves_;
  double frequency_, amplitude_;
};

/// Marble: layers across the x axis.
class Marble : public WaveTexture {
 public:
  using WaveTexture::WaveTexture;

 private:
  double distanceAt(const Vec3d& p) const override { return p.x(); }
};

/// Wood: rings around the y axis.
class Wood : public WaveTexture {
 public:
  using WaveTexture::WaveTexture;

 private:
  double distanceAt(const Vec3d& p) const override;
};
