// The hemisphere above a surface whose normal is +z: what materials answer there, and how much of
// the light that arrives they send back.
#pragma once
#include <cmath>

#include "math/functions.h"
#include "shading/material.h"

namespace hemisphere {

/// The unit vector at `angle` from the normal, turned by `turn` from x to y; radians.
inline Vec3d direction(double angle, double turn) {
  return {std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle)};
}

/// What goes to the eye in direction `toEye` under white light from `toLight`: pi f (n.l).
inline Vec3d answer(const Material& material, const Vec3d& toEye, const Vec3f& toLight,
                    const Vec3d& normal = {0, 0, 1}) {
  const Ray ray(toEye, -toEye);
  return Vec3d(material.Shade(ray, Hit(1, &material, normal), toLight, {1, 1, 1}));
}

/// Of even light from the whole hemisphere, the part that goes to the eye, in red: the integral of
/// f (n.l) over it by the midpoint rule. For materials whose answer changes slowly.
inline double albedo(const Material& material, const Vec3d& toEye, int steps = 300) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double angle = (i + 0.5) / steps * math::kPi / 2;
    double ring = 0;
    for (int k = 0; k < steps; ++k) {
      const Vec3d toLight = direction(angle, (k + 0.5) / steps * 2 * math::kPi);
      ring += answer(material, toEye, Vec3f(toLight)).x();
    }
    sum += ring * std::sin(angle);
  }
  return sum * (math::kPi / 2) * (2 * math::kPi) / steps / steps / math::kPi;
}

/// The same integral over the halfway vectors h, of which there are most where they are up to
/// `roughness` steep: d(l) = 4 (u.h) d(h). For narrow highlights.
inline double highlightAlbedo(const Material& material, const Vec3d& toEye, double roughness,
                              int steps = 300) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) / steps, steepness = roughness * s / (1 - s);
    const double stretch = roughness / ((1 - s) * (1 - s));  // d(steepness) / ds
    const double square = 1 + steepness * steepness;
    double ring = 0;
    for (int k = 0; k < steps; ++k) {
      const Vec3d h = direction(std::atan(steepness), (k + 0.5) / steps * 2 * math::kPi);
      const double slant = dot(toEye, h);
      if (slant <= 0) continue;
      ring += 4 * slant * answer(material, toEye, Vec3f(h * (2 * slant) - toEye)).x();
    }
    sum += ring * (steepness / std::sqrt(square)) * (stretch / square);
  }
  return sum * (2 * math::kPi) / steps / steps / math::kPi;
}

}  // namespace hemisphere
