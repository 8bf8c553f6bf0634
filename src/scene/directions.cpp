// Directions of any length.
#include "scene/directions.h"

#include <cmath>

Vec3d rescaled(const Vec3d& vector) {
  const double largest = maxAbs(vector);
  if (!(largest > 0)) return vector;
  int exponent = 0;
  std::frexp(largest, &exponent);
  return {std::ldexp(vector.x(), -exponent), std::ldexp(vector.y(), -exponent),
          std::ldexp(vector.z(), -exponent)};
}

bool areParallel(const Vec3d& a, const Vec3d& b) {
  const Vec3d p = rescaled(a), q = rescaled(b);
  return length(cross(p, q)) <= 1e-14 * length(p) * length(q);
}
