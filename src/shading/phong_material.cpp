// PhongMaterial and BlinnPhongMaterial: the local term of the colour sum, for one light.
//
// The ray tracer calls Shade once for each light that reaches the point, with what arrives there,
// and adds up what it gets; ambient light is a term of its own. Directions come in single
// precision, as the assignment has them; everything is computed in double and rounded once.
#include "shading/phong_material.h"

#include "math/functions.h"

Vec3f PhongMaterial::Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                           const Vec3f& lightColor) const {
  const Vec3d& n = hit.getNormal();
  const Vec3d l = dirToLight;
  // A light behind the surface lights nothing; a NaN counts as one.
  const double cosine = dot(n, l);
  if (!(cosine > 0)) return Vec3f();
  Vec3d reflected = Vec3d(getDiffuseColor()) * cosine;
  const double c = highlightCosine(ray.getDirection(), n, l);
  // The power is the costly step: not for a highlight that is black anyway.
  if (c > 0 && specularColor_ != Vec3f()) {
    reflected += Vec3d(specularColor_) * math::pow(c, exponent_);
  }
  return Vec3f(Vec3d(lightColor) * reflected);
}

/// r.l with r = v - 2 (v.n) n.
double PhongMaterial::highlightCosine(const Vec3d& v, const Vec3d& n, const Vec3d& l) const {
  return dot(v, l) - 2 * dot(v, n) * dot(n, l);
}

/// n.h with h = (l - v) / |l - v|: the way back along the ray is -v.
double BlinnPhongMaterial::highlightCosine(const Vec3d& v, const Vec3d& n, const Vec3d& l) const {
  const Vec3d halfway = l - v;
  const double size = length(halfway);
  return size > 0 ? dot(n, halfway) / size : 0;
}
