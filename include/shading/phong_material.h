// PhongMaterial and BlinnPhongMaterial: diffuse light, and a highlight that is a power of a cosine.
// With the unit vectors n (normal) and l (towards the light), both answer one light with
//
//   lightColor * ((n.l) diffuse + c^exponent specular)
//
// and differ in the angle that c is the cosine of:
//   Phong  c = r.l, r being the ray's direction mirrored at the surface;
//   Blinn  c = n.h, h being the unit vector halfway between l and the way back along the ray.
// Sources: Phong, "Illumination for Computer Generated Pictures", 1975; Blinn, "Models of Light
// Reflection for Computer Synthesized Pictures", 1977.
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

  /// RGB factors of the highlight; where black there is none.
  Vec3f getSpecularColor() const { return specularColor_; }
  float getExponent() const { return exponent_; }

  /// The formula above. Black where n.l <= 0; no highlight where c <= 0, even for exponent 0.
  Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
              const Vec3f& lightColor) const override;
  const char* getKind() const override { return "PhongMaterial"; }

 private:
  /// c for a ray of unit direction v, its normal n and the light's direction l.
  virtual double highlightCosine(const Vec3d& v, const Vec3d& n, const Vec3d& l) const;

  Vec3f specularColor_;
  float exponent_;
};

/// The halfway vector turns half as fast as the mirror direction, so 4 times the exponent of a
/// PhongMaterial gives a highlight as large: cos(x/2)^(4e) and cos(x)^e are both 1 - e x^2 / 2 near
/// the middle.
class BlinnPhongMaterial : public PhongMaterial {
 public:
  using PhongMaterial::PhongMaterial;
  const char* getKind() const override { return "BlinnPhongMaterial"; }

 private:
  /// 0 where l is the ray's own direction, so that there is no h.
  double highlightCosine(const Vec3d& v, const Vec3d& n, const Vec3d& l) const override;
};
