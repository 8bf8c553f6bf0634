// PhongMaterial: diffuse light and a highlight around the mirror direction.
// Source: Phong, "Illumination for Computer Generated Pictures", 1975.
#pragma once
#include "shading/material.h"

class PhongMaterial : public Material {
 public:
  /// exponent >= 0: the larger, the smaller the highlight.
  PhongMaterial(const Vec3f& diffuseColor, const Vec3f& specularColor, float exponent,
                const Vec3f& transparentColor, const Vec3f& reflectiveColor,
                float indexOfRefraction)
      : Material(diffuseColor, transparentColor, reflectiveColor, indexOfRefraction),
        specularColor_(specularColor),
        exponent_(exponent) {}

  Vec3f getSpecularColor() const { return specularColor_; }
  float getExponent() const { return exponent_; }

  /// lightColor * ((n.l) diffuse + (r.l)^exponent specular), r the mirrored ray direction. Black
  /// where n.l <= 0; no highlight where r.l <= 0, even for exponent 0.
  Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
              const Vec3f& lightColor) const override;

 private:
  Vec3f specularColor_;
  float exponent_;
};
