// Marble: the weight of the second material.
#include "shading/marble.h"

#include "math/functions.h"
#include "math/noise.h"

double Marble::weightOfSecond(const Vec3d& p) const {
  const double angle = frequency_ * p.x() + amplitude_ * math::fractalNoise(p, octaves_);
  return (1 + math::sin(angle)) / 2;
}
