// CookTorranceMaterial: the local term of the colour sum, for one light.
//
// The surface is taken for tiny mirrors of all slopes. Of those that face halfway between light and
// eye (D says how many) each mirrors F of the light, and a part G of them is neither shaded nor
// hidden by others: the highlight is D F G / (4 (n.l) (n.u)). What the mirrors let in is scattered
// below them and comes out as diffuse light, (1 - F) on the way in and again on the way out.
//
// A BRDF is multiplied by n.l for the light that falls on the surface. In the highlight that
// cancels against the n.l below, so `visible` holds G / (4 (n.u)), which stays finite as n.l -> 0.
#include "shading/cook_torrance_material.h"

#include <algorithm>
#include <cmath>

#include "math/functions.h"

Vec3f CookTorranceMaterial::Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                                  const Vec3f& lightColor) const {
  const Vec3d& n = hit.getNormal();
  const Vec3d l = dirToLight, toEye = -ray.getDirection();
  const double cosine = dot(n, l);
  if (!(cosine > 0)) return Vec3f();
  const Vec3d white(1, 1, 1);
  const Vec3d letIn = white - fresnel_.at(cosine);
  const Vec3d letOut = white - fresnel_.at(std::fabs(dot(n, toEye)));
  const Vec3d diffuse = Vec3d(getDiffuseColor()) * letIn * letOut * cosine;
  return Vec3f(Vec3d(lightColor) * (diffuse + highlight(n, l, toEye)));
}

/// pi D F G / (4 (n.u)), for n.l > 0.
Vec3d CookTorranceMaterial::highlight(const Vec3d& n, const Vec3d& l, const Vec3d& toEye) const {
  const Vec3d halfway = l + toEye;
  const double squared = dot(halfway, halfway), rise = dot(n, halfway);
  const double lightCosine = dot(n, l), eyeCosine = dot(n, toEye);
  if (!(eyeCosine > 0) || !(rise > kLeastHeight)) return Vec3d();
  // h = halfway / size. The sine of the angle between n and h comes from the cross product: from
  // the cosine it would have lost its digits where the highlight is brightest.
  const Vec3d sideways = cross(n, halfway);
  const double size = std::sqrt(squared);
  const double slant = size / 2;  // u.h: l and u are unit vectors
  const double amount = density(rise * rise / squared, dot(sideways, sideways) / squared) *
                        visible(lightCosine, eyeCosine, rise / size / slant);
  return fresnel_.at(slant) * amount;
}

/// G / (4 (n.u)), `ratio` being (n.h) / (u.h).
double CookTorranceMaterial::visible(double lightCosine, double eyeCosine, double ratio) const {
  if (distribution_ == Distribution::beckmann) {
    return std::min({1.0, 2 * ratio * eyeCosine, 2 * ratio * lightCosine}) / (4 * eyeCosine);
  }
  // 2 / (1 + sqrt(1 + alpha^2 tan^2)) is 2 c / (c + sqrt(alpha^2 + (1 - alpha^2) c^2)).
  const double alpha = std::max(double(roughness_), kLeastRoughness), squared = alpha * alpha;
  const auto root = [&](double c) { return std::sqrt(squared + (1 - squared) * (c * c)); };
  return lightCosine / ((lightCosine + root(lightCosine)) * (eyeCosine + root(eyeCosine)));
}

/// pi D by the squared cosine and sine of the angle between n and h: each as exact as the other.
double CookTorranceMaterial::density(double cosineSquared, double sineSquared) const {
  const double alpha = std::max(double(roughness_), kLeastRoughness), squared = alpha * alpha;
  if (distribution_ == Distribution::beckmann) {
    const double falloff = math::exp(-sineSquared / (cosineSquared * squared));
    return falloff / (squared * (cosineSquared * cosineSquared));
  }
  const double spread = squared * cosineSquared + sineSquared;
  return squared / (spread * spread);
}
