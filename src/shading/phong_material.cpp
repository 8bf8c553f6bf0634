// PhongMaterial and BlinnPhongMaterial: the local term of the colour sum, for one light.
//
// The ray tracer calls Shade once for each light that reaches the point, with what arrives there,
// and adds up what it gets; ambient light is a term of its own. Directions come in single
// precision, as the assignment has them; everything is computed in double and rounded once.
#include "shading/phong_material.h"

#include "shading/diffuse_map.h"

/// lightColor * ((n.l) diffuse + c^exponent specular).
Vec3f PhongMaterial::Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                           const Vec3f& lightColor) const {
  const Vec3d &v = ray.getDirection(), &n = hit.getNormal(), l = dirToLight;
  const double c = highlightCosine(v, n, l);
  const Vec3d diffuse =
      diffuseMap_ ? diffuseMap_->colorAt(hit, getDiffuseColor()) : Vec3d(getDiffuseColor());
  return Vec3f(phong_light::reflectedLight(n, l, c, Vec3d(lightColor), diffuse,
                                           Vec3d(specularColor_), double(exponent_), highlight_));
}

double PhongMaterial::highlightCosine(const Vec3d& v, const Vec3d& n, const Vec3d& l) const {
  return phong_light::mirroredCosine(v, n, l);
}

double BlinnPhongMaterial::highlightCosine(const Vec3d& v, const Vec3d& n, const Vec3d& l) const {
  return phong_light::halfwayCosine(v, n, l);
}
