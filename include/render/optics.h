// Mirror and refraction directions. Templates over the component type: the assignment calls them
// in float, the tracer in double.
#pragma once
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
