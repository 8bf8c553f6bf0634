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
#include "math/functions.h"
#include "shading/material.h"

/// The formulas, for any number of places (see math/number.h). v is the ray's unit direction.
namespace phong_light {

/// c = r.l with r = v - 2 (v.n) n.
template <class Number>
Number mirroredCosine(const Vec3<Number>& v, const Vec3<Number>& n, const Vec3<Number>& l) {
  return dot(v, l) - 2 * dot(v, n) * dot(n, l);
}

/// c = n.h with h = (l - v) / |l - v|: the way back along the ray is -v. 0 where l is the ray's own
/// direction, so that there is no h.
template <class Number>
Number halfwayCosine(const Vec3<Number>& v, const Vec3<Number>& n, const Vec3<Number>& l) {
  const Vec3<Number> halfway = l - v;
  const Number size = length(halfway);
  return choose(size > 0, dot(n, halfway) / size, Number(0));
}

/// Of which lights a highlight is seen, and how.
enum class Highlight {
  lit,        ///< of those in front of the surface
  dimmed,     ///< likewise, multiplied by n.l, as diffuse light is
  everywhere  ///< of all; where c <= 0 it is 0^exponent, which for exponent 0 is 1
};

/// lightColor * ((n.l) diffuse + c^exponent specular), rounded to float. A light behind the
/// surface, n.l <= 0 (a NaN counts as one), gives no diffuse light, nor a highlight unless that is
/// seen `everywhere`; none where c <= 0.
template <class Number>
Vec3<Number> reflectedLight(const Vec3<Number>& n, const Vec3<Number>& l, const Number& c,
                            const Vec3<Number>& lightColor, const Vec3<Number>& diffuse,
                            const Vec3<Number>& specular, const Number& exponent,
                            Highlight highlight) {
  const Number cosine = dot(n, l);
  MaskOf<Number> isLit = cosine > 0;
  Vec3<Number> reflected = diffuse * cosine;
  // The power is the costly step: not for a highlight that is black anyway.
  MaskOf<Number> isBright = (c > 0) & isNotZero(specular);
  if (highlight == Highlight::everywhere) {
    reflected = choose(isLit, reflected, Vec3<Number>());
    isLit = cosine == cosine;
    isBright = isBright | ((exponent == 0) & isNotZero(specular));
  }
  if (any(isBright)) {
    const Number power = choose(c > 0, math::pow(c, exponent), Number(1));
    const Number factor = highlight == Highlight::dimmed ? power * cosine : power;
    reflected = choose(isBright, reflected + specular * factor, reflected);
  }
  return choose(isLit, roundedToFloat(lightColor * reflected), Vec3<Number>());
}

}  // namespace phong_light

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
  using Highlight = phong_light::Highlight;
  /// Highlight::lit, unless another one is asked for, while the scene is being read.
  Highlight getHighlight() const { return highlight_; }
  void setHighlight(Highlight highlight) { highlight_ = highlight; }

  const DiffuseMap* getDiffuseMap() const override { return diffuseMap_; }
  /// From now on `map`, not owned, gives the diffuse colour; where it is null, the plain one does.
  /// Only while the scene is being read.
  void setDiffuseMap(const DiffuseMap* map) { diffuseMap_ = map; }

  /// The formula above.
  Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
              const Vec3f& lightColor) const override;
  const char* getKind() const override { return "PhongMaterial"; }

 private:
  /// c for a ray of unit direction v, its normal n and the light's direction l.
  virtual double highlightCosine(const Vec3d& v, const Vec3d& n, const Vec3d& l) const;

  const DiffuseMap* diffuseMap_ = nullptr;
  Vec3f specularColor_;
  float exponent_;
  Highlight highlight_ = Highlight::lit;
};

/// The halfway vector turns half as fast as the mirror direction, so 4 times the exponent of a
/// PhongMaterial gives a highlight as large: cos(x/2)^(4e) and cos(x)^e are both 1 - e x^2 / 2 near
/// the middle.
class BlinnPhongMaterial : public PhongMaterial {
 public:
  using PhongMaterial::PhongMaterial;
  const char* getKind() const override { return "BlinnPhongMaterial"; }

 private:
  double highlightCosine(const Vec3d& v, const Vec3d& n, const Vec3d& l) const override;
};
