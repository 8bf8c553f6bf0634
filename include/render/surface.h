// Surface: where a ray has met something, with all that the colour there depends on; and what the
// tracers pass on from surface to surface.
#pragma once
#include "geometry/hit.h"
#include "math/number.h"
#include "math/vec3.h"
#include "shading/material.h"

/// What lies on both sides of the place where a ray hits a surface.
struct Interface {
  /// The medium on one side: that of the surface's own material, or another.
  struct Side {
    bool isOwn = false;
    float index = 1;  ///< of refraction, where it is another

    float indexAt(const Material& surface) const {
      return isOwn ? surface.getIndexOfRefraction() : index;
    }
  };

  Side before;            ///< where the ray comes from
  Side behind;            ///< where it would go on straight
  bool isClosed = false;  ///< the surface encloses a volume; known with RenderOptions::fresnel
  Vec3f tint{1, 1, 1};    ///< what is left of the light from the surface where the ray began
};

/// A view of a hit for the time of one call; nothing is owned.
struct Surface {
  const Ray& ray;              ///< in the world, with a unit direction
  const Hit& hit;              ///< of that ray: there is a material
  const Interface& interface;  ///< at the hit
  int bounces;                 ///< secondary rays before this one; 0 for an eye ray
  float weight;                ///< the share that the ray's colour has in the pixel
  float indexOfRefraction;     ///< of the medium the ray travels in
};

/// One light as a surface sees it.
struct LightSample {
  Vec3d direction;         ///< unit, to the light
  Vec3f color;             ///< what arrives where nothing is in the way
  double distance = 0;     ///< along `direction`, perhaps infinite
  bool isInFront = false;  ///< isLit: the side that lights see is turned towards it
};

/// Whether a light in a direction reaches a surface whose normal, on the side that lights see, is
/// `lit`: 0 where it is dark. Those behind it do where highlights are seen of them.
template <class Number>
MaskOf<Number> isLit(const Vec3<Number>& lit, const Vec3<Number>& direction, bool areSeenBehind) {
  return dot(lit, areSeenBehind ? lit : direction) > 0;
}

enum class RayKind { eye, mirror, refracted };
inline constexpr int kRayKinds = 3;

/// What becomes of a ray that could continue where another one ends.
enum class Outcome {
  none,            ///< the material sends none
  follows,         ///< it is traced
  tooManyBounces,  ///< the most bounces allowed have been made
  tooFaint,        ///< its weight is below the least
  totalReflection  ///< no refracted ray exists
};
inline constexpr int kOutcomes = 5;

/// A ray to be traced, with what the recursion knows of it. As it is made, it is an eye ray.
struct TracedRay {
  Ray ray;
  double tmin = 0;              ///< it meets what lies at t > tmin
  float weight = 1;             ///< the share that its colour has in the pixel
  float indexOfRefraction = 1;  ///< of the medium it travels in
  Vec3f factor{1, 1, 1};        ///< of its colour in that of the ray it continues
};
