// WaveTexture: the weight of the second material.
#include "shading/wave_texture.h"

#include <cmath>

#include "math/functions.h"
#include "math/noise.h"

double WaveTexture::weightOfSecond(const Vec3d& p) const {
  const double angle = frequency_ * distanceAt(p) + amplitude_ * math::fractalNoise(p, octaves_);
  return (1 + math::sin(angle)) / 2;
}

double Wood::distanceAt(const Vec3d& p) const { return std::sqrt(p.x() * p.x() + p.z() * p.z()); }
