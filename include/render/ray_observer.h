// RayObserver: who wants to know what a RayTracer does, ray by ray; nobody by default.
//
// traceRay reports depth first, in the order of the sum of terms: a ray begins, meets something,
// asks each light, follows its branches, each of which begins and ends inside it, and ends. So a
// tree of rays can be printed. traceBatch reports the same rays, hits, lights and stops, but those
// of many rays mixed, and no terms: enough for counting. An observer belongs to one thread.
#pragma once
#include "geometry/hit.h"
#include "geometry/ray.h"
#include "math/vec3.h"

enum class RayKind { eye, mirror, refracted };
inline constexpr int kRayKinds = 3;

/// A ray that is about to be traced.
struct RayBegin {
  RayKind kind;
  const Ray& ray;
  int bounces;              ///< how many secondary rays came before it
  float weight;             ///< the part that its colour has in the pixel
  float indexOfRefraction;  ///< of the medium it travels in
};

/// What came of one light at one hit.
struct LightVerdict {
  int light;           ///< its number in the scene
  bool isInFront;      ///< false where the surface is turned away: nothing more was asked
  bool castShadowRay;  ///< whether anything in the way was looked for
  Vec3f visible;       ///< the part of its colour that arrives; black where it is blocked
};

/// Why a branch that the material asks for is not followed.
enum class BranchStop {
  bounces,         ///< the most bounces allowed have been made
  weight,          ///< its weight is below the least
  totalReflection  ///< no refracted ray exists
};
inline constexpr int kBranchStops = 3;

/// The terms of the sum.
enum class ColorTerm { ambient, lights, mirror, transmitted };

class RayObserver {
 public:
  virtual ~RayObserver() = default;

  virtual void rayBegins(const RayBegin&) {}
  /// `hit` is null where the ray meets nothing; then the background is its colour.
  virtual void rayMeets(const Hit* /*hit*/) {}
  virtual void lightAnswers(const LightVerdict&) {}
  virtual void branchStops(RayKind, BranchStop, float /*weight*/) {}
  virtual void termIsKnown(ColorTerm, const Vec3d& /*color*/) {}
  virtual void rayEnds(const Vec3f& /*color*/) {}
};
