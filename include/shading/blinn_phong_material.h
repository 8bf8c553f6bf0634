// BlinnPhongMaterial: diffuse light and a highlight around the halfway vector.
// Source: Blinn, "Models of Light Reflection for Computer Synthesized Pictures", 1977.
#pragma once
#include "shading/material.h"

class BlinnPhongMaterial : public Material {
 public:
  /// exponent >= 0: the larger, the smaller the highlight. The halfway vector turns half as fast as
  /// the mirror direction, so 4 times the exponent of a PhongMaterial gives a highlight as large:
  /// cos(x/2)^(4e) and cos(x)^e are both 1 - e x^2 / 2 near the middle.
  BlinnPhongMaterial(const Vec3f& diffuseColor, const Vec3f& specularColor, float exponent,
                     const Vec3f& transparentColor, const Vec3f& reflectiveColor,
                     float indexOfRefraction)
      : Material(diffuseColor, transparentColor, reflectiveColor, indexOfRefraction),
        specularColor_(specularColor),
        exponent_(exponent) {}

  Vec3f getSpecularColor() const { return specularColor_; }
  float getExponent() const { return exponent_; }

  /// lightColor * ((n.l) diffuse + (n.h)^exponent specular), h the unit vector halfway between l
  /// and the way back along the ray. Black where n.l <= 0; no highlight where n.h <= 0, even for
  /// exponent 0, or where l is the ray's own direction, so that there is no h.
  Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
              const Vec3f& lightColor) const override;

 private:
  Vec3f specularColor_;
  float exponent_;
};
