// Fresnel: the exact form for dielectrics, and Schlick's approximation for colours.
#include "shading/fresnel.h"

#include <algorithm>
#include <cmath>

double dielectricReflectance(double cosine, double index) {
  if (index == 1) return 0;
  // With c the cosine and g^2 = n^2 - 1 + c^2; g is n times the cosine inside.
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
