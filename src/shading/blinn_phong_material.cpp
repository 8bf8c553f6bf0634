// BlinnPhongMaterial: the local term of the colour sum, for one light.
#include "shading/blinn_phong_material.h"

#include "math/functions.h"

Vec3f BlinnPhongMaterial::Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                                const Vec3f& lightColor) const {
  const Vec3d& n = hit.getNormal();
  const Vec3d l = dirToLight;
  const double cosine = dot(n, l);
  if (!(cosine > 0)) return Vec3f();
  Vec3d reflected = Vec3d(getDiffuseColor()) * cosine;
  const Vec3d halfway = l - ray.getDirection();
  const double size = length(halfway), rise = dot(n, halfway);
  if (rise > 0 && size > 0 && specularColor_ != Vec3f()) {
    reflected += Vec3d(specularColor_) * math::pow(rise / size, exponent_);
  }
  return Vec3f(Vec3d(lightColor) * reflected);
}
