// Optics of a smooth surface: the mirrored and the refracted direction, and how much light goes
// which way. Templates over the number type (math/number.h): the assignment calls them in float,
// the tracer in double, of one ray or several.
//
// How much is mirrored depends on whether the wave swings across the plane of incidence or along
// it. With c the cosine outside, n the relative index and g the cosine inside times n, so that
// g^2 = n^2 - 1 + c^2 by Snell's law, the mirrored amplitudes are
//   across  (g - c) / (g + c)
//   along   across * (c (g + c) - 1) / (c (g - c) + 1)
// and the energy is the mean of their squares, since unpolarised light is half of each. A g^2 that
// is not above 0 means that no ray goes in: total reflection.
#pragma once
#include <cmath>

#include "math/functions.h"
#include "math/vec3.h"

/// The direction in which a mirror with unit normal `normal` sends a ray that arrives along
/// `incoming`: v - 2 (v.n) n. Either side of the mirror will do; the length is kept.
template <class T>
Vec3<T> mirrorDirection(const Vec3<T>& normal, const Vec3<T>& incoming) {
  return incoming - normal * (2 * dot(incoming, normal));
}

/// Snell's law: finds the unit direction after passing into a medium whose index of refraction is
/// 1 / `ratio` of that before. `normal` and `incoming` are unit vectors, the normal on the incoming
/// side (normal . incoming <= 0). False, and `direction` anything, on total internal reflection.
/// Source: Heckbert, "Derivation of Refraction Formulas", in Glassner, "An Introduction to Ray
/// Tracing", 1989.
template <class Number>
MaskOf<Number> refractedDirection(const Vec3<Number>& normal, const Vec3<Number>& incoming,
                                  const Number& ratio, Vec3<Number>& direction) {
  const Number cosIncoming = -dot(normal, incoming);
  const Number cosSquared = 1 - ratio * ratio * (1 - cosIncoming * cosIncoming);
  const MaskOf<Number> passes = cosSquared >= 0;
  if (!any(passes)) return passes;
  direction = normalize(incoming * ratio + normal * (ratio * cosIncoming - squareRoot(cosSquared)));
  return passes;
}

/// The same from a medium of index `index_i` into one of index `index_t`: stores the result in
/// `transmitted` and returns true; on total internal reflection returns false and leaves
/// `transmitted` as it was.
template <class T>
bool transmittedDirection(const Vec3<T>& normal, const Vec3<T>& incoming, float index_i,
                          float index_t, Vec3<T>& transmitted) {
  return refractedDirection(normal, incoming, T(index_i) / T(index_t), transmitted);
}

/// The part of unpolarised light that the border to a medium of relative index `index` > 0 mirrors;
/// the rest goes in. `cosine` is that of the angle between the light and the normal, 0..1. 0 for
/// index 1, ((n - 1) / (n + 1))^2 at cosine 1, 1 at cosine 0, and 1 at total reflection (index <
/// 1). Source: Fresnel's equations as in Cook and Torrance, "A Reflectance Model for Computer
/// Graphics", 1982.
template <class Number>
Number dielectricReflectance(const Number& cosine, const Plain<Number>& index) {
  // (n - 1) (n + 1) and not n^2 - 1, which loses digits for an index near 1.
  const Number c = cosine, squared = (index - 1) * (index + 1) + c * c;
  const Number g = squareRoot(squared);
  const Number across = (g - c) / (g + c);
  const Number along = across * ((c * (g + c) - 1) / (c * (g - c) + 1));
  const Number partly = (across * across + along * along) / 2;
  return choose(index == 1, Number(0), choose(squared <= 0, Number(1), partly));
}

/// c + (1 - c) (1 - cosine)^5 for each component of `normalReflectance` c, what is mirrored at
/// normal incidence (each 0..1). `cosine` as above; above 1, as rounding may leave it, it counts as
/// 1. Source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994.
template <class Number>
Vec3<Number> schlickReflectance(const Plain<Number>& cosine,
                                const Vec3<Number>& normalReflectance) {
  const Number x = larger(Number(0), 1 - cosine), rise = x * x * (x * x) * x;
  return normalReflectance + (Vec3<Number>(1, 1, 1) - normalReflectance) * rise;
}

/// The part of light that glass mirrors by Schlick's formula, between the indices `before` and
/// `behind` it: R0 + (1 - R0) (1 - c)^5 with R0 = ((n - 1) / (n + 1))^2, n being the index behind,
/// and 1 at total reflection. `approach` is n.v of the ray; c is its size where the ray enters
/// (below 0), else the cosine of the refracted ray. Source: MIT 6.837, "Introduction to Computer
/// Graphics", assignment 5 of 2012.
inline double blendedReflectance(double approach, double before, double behind) {
  const double ratio = before / behind, cosSquared = 1 - ratio * ratio * (1 - approach * approach);
  if (cosSquared < 0) return 1;
  const double root = (behind - 1) / (behind + 1), r0 = root * root;
  const double cosine = approach < 0 ? -approach : std::sqrt(cosSquared);
  return schlickReflectance(cosine, Vec3d(r0, r0, r0)).x();
}

/// What is left of light after a way of `length` >= 0 through what leaves `color` of it after a
/// length of 1: color^length, a negative colour taken as 0. Source: Beer's law.
template <class Number>
Number absorption(const Number& color, const Plain<Number>& length) {
  return math::pow(larger(color, Number(0)), length);
}

/// The reflectance of a surface, known by its index of refraction or by its colour.
class Fresnel {
 public:
  /// A dielectric such as glass, varnish or plastic: dielectricReflectance. index > 0.
  static Fresnel ofIndex(float index) { return Fresnel(index, Vec3f()); }
  /// A metal, or anything else whose colour at normal incidence is known: schlickReflectance. Each
  /// component is 0..1.
  static Fresnel ofColor(const Vec3f& normalReflectance) { return Fresnel(0, normalReflectance); }

  /// What is mirrored of light that meets the normal at the angle with this cosine, 0..1.
  Vec3d at(double cosine) const {
    if (index_ == 0) return schlickReflectance(cosine, Vec3d(color_));
    const double reflectance = dielectricReflectance(cosine, double(index_));
    return {reflectance, reflectance, reflectance};
  }

 private:
  Fresnel(float index, const Vec3f& color) : index_(index), color_(color) {}
  float index_;  // 0 where the colour holds
  Vec3f color_;
};
