// Mirror and refraction directions. Templates over the component type: the assignment calls them
// in float, the tracer in double. And how much of the light is reflected.
#pragma once
#include <algorithm>
#include <cmath>

#include "math/vec3.h"

/// The direction in which a mirror with unit normal `normal` sends a ray that arrives along
/// `incoming`: v - 2 (v.n) n. Either side of the mirror will do; the length is kept.
template <class T>
Vec3<T> mirrorDirection(const Vec3<T>& normal, const Vec3<T>& incoming) {
  return incoming - normal * (2 * dot(incoming, normal));
}

/// Snell's law: finds the direction after passing from a medium of index `index_i` into one of
/// index `index_t`. `normal` and `incoming` are unit vectors, the normal on the incoming side
/// (normal . incoming <= 0). Stores the unit result in `transmitted` and returns true; on total
/// internal reflection returns false and leaves `transmitted` as it was.
/// Source: Heckbert, "Derivation of Refraction Formulas", in Glassner, "An Introduction to Ray
/// Tracing", 1989.
template <class T>
bool transmittedDirection(const Vec3<T>& normal, const Vec3<T>& incoming, float index_i,
                          float index_t, Vec3<T>& transmitted) {
  const T ratio = T(index_i) / T(index_t);
  const T cosIncoming = -dot(normal, incoming);
  const T cosSquared = 1 - ratio * ratio * (1 - cosIncoming * cosIncoming);
  if (!(cosSquared >= 0)) return false;
  transmitted =
      normalize(incoming * ratio + normal * (ratio * cosIncoming - std::sqrt(cosSquared)));
  return true;
}

/// The part of unpolarised light that a smooth surface reflects where it comes from a medium of
/// index `index_i` to one of index `index_t`, both above 0: 0 where they are equal, 1 on total
/// internal reflection. `cosIncoming` is that of the angle between the ray and the normal, 0..1
/// (a little beyond does no harm). The rest is transmitted.
/// Source: Fresnel's equations, as in Born and Wolf, "Principles of Optics", 1.5.2.
inline double fresnelReflectance(double cosIncoming, float index_i, float index_t) {
  if (index_i == index_t) return 0;
  const double from = double(index_i), to = double(index_t), ratio = from / to;
  const double cosSquared = 1 - ratio * ratio * (1 - cosIncoming * cosIncoming);
  if (!(cosSquared > 0)) return 1;
  const double cosine = std::sqrt(cosSquared);
  const double across = (from * cosIncoming - to * cosine) / (from * cosIncoming + to * cosine);
  const double along = (to * cosIncoming - from * cosine) / (to * cosIncoming + from * cosine);
  return std::clamp((across * across + along * along) / 2, 0.0, 1.0);
}

/// How much an opaque surface reflects that reflects `atNormal` of light along its normal:
/// R0 + (1 - R0) (1 - cos)^5 in each component.
/// Source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994.
inline Vec3f schlickReflectance(double cosIncoming, const Vec3f& atNormal) {
  const double rest = 1 - std::clamp(cosIncoming, 0.0, 1.0), squared = rest * rest;
  const Vec3d r(atNormal);
  return Vec3f(r + (Vec3d(1, 1, 1) - r) * (squared * squared * rest));
}
