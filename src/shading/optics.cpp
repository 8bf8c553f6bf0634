// Fresnel: the exact form for dielectrics, and Schlick's approximation for colours.
//
// A wave that meets the border is partly mirrored, and how much depends on whether it swings across
// the plane of incidence or along it. With c the cosine outside, n the relative index and g the
// cosine inside times n, so that g^2 = n^2 - 1 + c^2 by Snell's law, the mirrored amplitudes are
//   across  (g - c) / (g + c)
//   along   across * (c (g + c) - 1) / (c (g - c) + 1)
// and the energy is the mean of their squares, since unpolarised light is half of each. A g^2 that
// is not above 0 means that no ray goes in: total reflection.
#include "shading/optics.h"

#include <algorithm>
#include <cmath>

double dielectricReflectance(double cosine, double index) {
  if (index == 1) return 0;
  // (n - 1) (n + 1) and not n^2 - 1, which loses digits for an index near 1.
  const double c = cosine, squared = (index - 1) * (index + 1) + c * c;
  if (squared <= 0) return 1;
  const double g = std::sqrt(squared);
  const double across = (g - c) / (g + c);
  const double along = across * ((c * (g + c) - 1) / (c * (g - c) + 1));
  return (across * across + along * along) / 2;
}

Vec3d schlickReflectance(double cosine, const Vec3d& normalReflectance) {
  const double x = std::max(0.0, 1 - cosine), rise = x * x * (x * x) * x;
  return normalReflectance + (Vec3d(1, 1, 1) - normalReflectance) * rise;
}

Vec3d Fresnel::at(double cosine) const {
  if (index_ == 0) return schlickReflectance(cosine, color_);
  const double reflectance = dielectricReflectance(cosine, index_);
  return {reflectance, reflectance, reflectance};
}
