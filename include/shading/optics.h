// Optics of a smooth surface: the mirrored and the refracted direction, and how much light goes
// which way. Directions are templates over the component type: the assignment calls them in float,
// the tracer in double.
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

/// The part of unpolarised light that the border to a medium of relative index `index` > 0 mirrors;
/// the rest goes in. `cosine` is that of the angle between the light and the normal, 0..1. 0 for
/// index 1, ((n - 1) / (n + 1))^2 at cosine 1, 1 at cosine 0, and 1 at total reflection (index <
/// 1). Source: Fresnel's equations as in Cook and Torrance, "A Reflectance Model for Computer
/// Graphics", 1982.
double dielectricReflectance(double cosine, double index);

/// c + (1 - c) (1 - cosine)^5 for each component of `normalReflectance` c, what is mirrored at
/// normal incidence (each 0..1). `cosine` as above; above 1, as rounding may leave it, it counts as
/// 1. Source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994.
Vec3d schlickReflectance(double cosine, const Vec3d& normalReflectance);

/// The reflectance of a surface, known by its index of refraction or by its colour.
class Fresnel {
 public:
  /// A dielectric such as glass, varnish or plastic: dielectricReflectance. index > 0.
  static Fresnel ofIndex(float index) { return Fresnel(index, Vec3f()); }
  /// A metal, or anything else whose colour at normal incidence is known: schlickReflectance. Each
  /// component is 0..1.
  static Fresnel ofColor(const Vec3f& normalReflectance) { return Fresnel(0, normalReflectance); }

  /// What is mirrored of light that meets the normal at the angle with this cosine, 0..1.
  Vec3d at(double cosine) const;

 private:
  Fresnel(float index, const Vec3f& color) : index_(index), color_(color) {}
  float index_;  // 0 where the colour holds
  Vec3f color_;
};
