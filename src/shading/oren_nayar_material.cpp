// OrenNayarMaterial: the local term of the colour sum, for one light.
//
// The surface is taken for V-shaped grooves whose sides are diffuse. From the light's own direction
// the sides that are seen are those that are lit, so the edge of a ball stays bright; seen from the
// other side they are dark. A is what all directions have in common, B the difference, which goes
// with cos p, the angle between light and eye as seen from above.
#include "shading/oren_nayar_material.h"

#include <algorithm>
#include <cmath>

OrenNayarMaterial::OrenNayarMaterial(const Vec3f& diffuseColor, float roughness,
                                     const Vec3f& transparentColor, const Vec3f& reflectiveColor,
                                     float indexOfRefraction)
    : Material(diffuseColor, transparentColor, reflectiveColor, indexOfRefraction) {
  // s^2, with the constants of the qualitative model.
  const double squared = double(roughness) * roughness;
  const double a = 1 - squared / (2 * (squared + 0.33)), b = 0.45 * squared / (squared + 0.09);
  const double most = std::max(1.0, a + b / 2);
  even_ = a / most;
  uneven_ = b / most;
}

Vec3f OrenNayarMaterial::Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                               const Vec3f& lightColor) const {
  const Vec3d& n = hit.getNormal();
  const Vec3d l = dirToLight, toEye = -ray.getDirection();
  const double lightCosine = dot(n, l), eyeCosine = dot(n, toEye);
  if (!(lightCosine > 0)) return Vec3f();
  // cos p sin a sin b is the scalar product of what l and u have along the surface; the angle b
  // has the larger cosine.
  const double together = dot(l, toEye) - lightCosine * eyeCosine;
  const double larger = std::max(lightCosine, std::fabs(eyeCosine));
  const double amount = even_ + uneven_ * (std::max(0.0, together) / larger);
  return Vec3f(Vec3d(lightColor) * (Vec3d(getDiffuseColor()) * (amount * lightCosine)));
}
