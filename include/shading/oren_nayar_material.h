// OrenNayarMaterial: rough diffuse surfaces such as clay, plaster or the moon, whose edge is as
// bright as their middle when the light comes from behind the eye.
#pragma once
#include "shading/material.h"

class OrenNayarMaterial : public Material {
 public:
  /// roughness >= 0: the standard deviation s of the slope angle, in radians; 0 is Lambert's law,
  /// the diffuse term of the other materials.
  OrenNayarMaterial(const Vec3f& diffuseColor, float roughness, const Vec3f& transparentColor,
                    const Vec3f& reflectiveColor, float indexOfRefraction);

  /// lightColor * pi f (n.l), with u the way back along the ray and
  ///   pi f = diffuse (A + B max(0, cos p) sin a tan b) / max(1, A + B / 2)
  ///   A = 1 - s^2 / (2 (s^2 + 0.33)),  B = 0.45 s^2 / (s^2 + 0.09)
  /// where p is the angle between l and u seen from above, a the larger and b the smaller of the
  /// angles of l and u with n. The published formula has no divisor, which is 1.0152 at most (for
  /// s = 0.2) and 1 from s = 0.327 on: at grazing view a white surface sends back A + B / 2, the
  /// most at any angle, which must not be above 1. Black where n.l <= 0. Seen from behind (n.u <
  /// 0), the surface looks as from the mirrored place in front of it. Source: Oren and Nayar,
  /// "Generalization of Lambert's Reflectance Model", 1994 (the qualitative model).
  Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
              const Vec3f& lightColor) const override;
  const char* getKind() const override { return "OrenNayarMaterial"; }

 private:
  double even_, uneven_;  // A and B, each divided by max(1, A + B / 2)
};
