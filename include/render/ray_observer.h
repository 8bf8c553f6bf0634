// RayObserver: who wants to know what a RayTracer does, ray by ray; nobody by default.
//
// traceRay reports depth first, in the order of the sum of terms: a ray begins, meets something,
// asks each light, follows its branches, each of which begins and ends inside it, and ends. So a
// tree of rays can be printed. traceBatch reports the same rays, hits, lights and stops, but those
// of many rays mixed, and no terms, passages or parts: enough for counting. An observer belongs to
// one thread.
#pragma once
#include "geometry/batch_geometry.h"
#include "geometry/object3d.h"
#include "math/vec3.h"
#include "render/passage.h"

enum class RayKind { eye, mirror, refracted };
inline constexpr int kRayKinds = 3;

/// A ray that is about to be traced.
struct RayBegin {
  RayKind kind;
  const Ray& ray;
  int bounces;              ///< how many secondary rays came before it
  float weight;             ///< the part that its colour has in the pixel
  float indexOfRefraction;  ///< of the medium it travels in
  double tmin;              ///< it meets what lies at t > tmin
  Vec3f factor;             ///< of its colour in that of the ray it continues; white for an eye ray
};

/// What came of one light at one hit.
struct LightVerdict {
  int light;           ///< its number in the scene
  bool isInFront;      ///< false where the surface is turned away: nothing more was asked
  bool castShadowRay;  ///< whether anything in the way was looked for
  Vec3f visible;       ///< the part of its colour that arrives; black where it is blocked
  Vec3d direction;     ///< unit, to the light
  double distance;     ///< to the light, perhaps infinite
  /// The shadow ray; null where none was cast. It is the observer's for as long as the call takes.
  const ShadowQuery* way;
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
  /// A surface that changes nothing (RenderOptions::nestedDielectrics), which the ray goes through
  /// before what rayMeets tells of.
  virtual void surfaceIsPassed(const Hit&) {}
  /// The media on both sides of what the ray has met, and what dims the light on its way from
  /// there.
  virtual void passageIsKnown(const Passage&) {}
  /// The surface is a solid texture: what follows up to partEnds is as if it were of `material`
  /// alone, whose colour is a part `weight` of the ray's.
  virtual void partBegins(const Material& /*material*/, double /*weight*/) {}
  virtual void partEnds(const Vec3f& /*color*/) {}
  virtual void lightAnswers(const LightVerdict&) {}
  /// What the light that has answered last brings, where anything of it arrives.
  virtual void lightAdds(const Vec3d& /*color*/) {}
  virtual void branchStops(RayKind, BranchStop, float /*weight*/) {}
  virtual void termIsKnown(ColorTerm, const Vec3d& /*color*/) {}
  virtual void rayEnds(const Vec3f& /*color*/) {}
};
