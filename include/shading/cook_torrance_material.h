// CookTorranceMaterial: a rough surface of tiny mirrors, and diffuse light from below it.
#pragma once
#include "shading/material.h"
#include "shading/optics.h"

class CookTorranceMaterial : public Material {
 public:
  /// How steep the mirrors are: Beckmann falls off fast, GGX has a bright middle and long tails.
  enum class Distribution { ggx, beckmann };

  /// roughness > 0, without unit: of Beckmann the root mean square slope m, of GGX its alpha.
  CookTorranceMaterial(const Vec3f& diffuseColor, const Fresnel& fresnel, float roughness,
                       Distribution distribution, const Vec3f& transparentColor,
                       const Vec3f& reflectiveColor, float indexOfRefraction)
      : Material(diffuseColor, transparentColor, reflectiveColor, indexOfRefraction),
        fresnel_(fresnel),
        roughness_(roughness),
        distribution_(distribution) {}

  /// lightColor * pi f (n.l), with u the way back along the ray, h halfway between l and u, and
  ///   pi f = diffuse (1 - F(n.l)) (1 - F(n.u)) + pi D F(u.h) G / (4 (n.l) (n.u))
  /// and, with cos t = n.h, for Beckmann
  ///   D = exp(-(tan t / m)^2) / (pi m^2 cos^4 t)
  ///   G = min(1, 2 (n.h) (n.u) / (u.h), 2 (n.h) (n.l) / (u.h)), grooves
  /// and for GGX
  ///   D = alpha^2 / (pi (alpha^2 cos^2 t + sin^2 t)^2)
  ///   G = g(n.l) g(n.u), g(cos a) = 2 / (1 + sqrt(1 + alpha^2 tan^2 a)), after Smith
  /// Diffuse light is what is let in and out again, so that no more comes back than arrived, with
  /// a white diffuseColor too. Black where n.l <= 0. Seen from behind (n.u <= 0) there is no
  /// highlight, and |n.u| stands for n.u.
  /// Sources: Cook and Torrance, "A Reflectance Model for Computer Graphics", 1982; GGX and the 4:
  /// Walter, Marschner, Li and Torrance, "Microfacet Models for Refraction through Rough
  /// Surfaces", 2007.
  Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
              const Vec3f& lightColor) const override;
  const char* getKind() const override { return "CookTorranceMaterial"; }

 private:
  Vec3d highlight(const Vec3d& n, const Vec3d& l, const Vec3d& toEye) const;
  double density(double cosineSquared, double sineSquared) const;
  double visible(double lightCosine, double eyeCosine, double ratio) const;

  Fresnel fresnel_;
  float roughness_;
  Distribution distribution_;
};
