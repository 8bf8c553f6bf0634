// Noise: the weight of the second material.
#include "shading/noise.h"

#include "math/noise.h"

double Noise::weightOfSecond(const Vec3d& p) const {
  return (1 + math::fractalNoise(p, octaves_)) / 2;
}
