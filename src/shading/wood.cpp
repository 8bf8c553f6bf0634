// Wood: the weight of the second material.
#include "shading/wood.h"

#include "math/functions.h"
#include "math/noise.h"

double Wood::weightOfSecond(const Vec3d& p) const {
  const double radius = std::sqrt(p.x() * p.x() + p.z() * p.z());
  const double angle = frequency_ * radius + amplitude_ * math::fractalNoise(p, octaves_);
  return (1 + math::sin(angle)) / 2;
}
