// PhongMaterial: the local term of the colour sum, for one light.
#include "shading/phong_material.h"

#include "math/functions.h"

Vec3f PhongMaterial::Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                           const Vec3f& lightColor) const {
  const Vec3d& n = hit.getNormal();
  const Vec3d l = dirToLight;
  const double cosine = dot(n, l);
  if (!(cosine > 0)) return Vec3f();
  Vec3d reflected = Vec3d(getDiffuseColor()) * cosine;
  // r.l with r = v - 2 (v.n) n, for the ray's unit direction v.
  const Vec3d& v = ray.getDirection();
  const double highlight = dot(v, l) - 2 * dot(v, n) * cosine;
  if (highlight > 0 && specularColor_ != Vec3f()) {
    reflected += Vec3d(specularColor_) * math::pow(highlight, exponent_);
  }
  return Vec3f(Vec3d(lightColor) * reflected);
}
