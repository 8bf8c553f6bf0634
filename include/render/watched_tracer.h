// WatchedTracer: a RayTracer that tells a RayObserver what it does, step by step. The colours are
// the RayTracer's own.
//
// Events come depth first, in the order of the sum of terms: a ray begins, meets something, asks
// each light, follows its branches, each of which begins and ends inside it, and ends. So a tree of
// rays can be printed as it is traced.
#pragma once
#include "render/ray_tracer.h"

/// The terms of the sum.
enum class ColorTerm { ambient, lights, mirror, transmitted };

/// Who wants to know. All events do nothing by default. An observer belongs to one thread; what it
/// is handed by reference lasts as long as the call.
class RayObserver {
 public:
  virtual ~RayObserver() = default;

  /// An eye ray, or a secondary one inside the ray it continues, `bounces` others before it.
  virtual void rayBegins(RayKind, int /*bounces*/, const TracedRay&) {}
  /// A surface that changes nothing (RenderOptions::nestedDielectrics), which the ray goes through
  /// before what rayMeets tells of.
  virtual void surfaceIsPassed(const Hit&) {}
  /// `hit` is null where the ray meets nothing; then the background is its colour. Else the
  /// interface tells the media on both sides, and what dims the light on its way from there.
  virtual void rayMeets(const Hit* /*hit*/, const Interface&) {}
  /// The surface is a solid texture: what follows up to componentEnds is as if it were of
  /// `material` alone, whose colour has the share `share` in the ray's, 0 to 1.
  virtual void componentBegins(const Material& /*material*/, double /*share*/) {}
  /// The colour of the component that began last, not yet multiplied by its share.
  virtual void componentEnds(const Vec3f& /*color*/) {}
  /// Once for each light, in the scene's order: its number, and what the surface sees of it.
  /// `shadowRay` is null where none was cast, as towards a light that the surface is turned away
  /// from; of the light's colour the part `visible` arrives, black where it is blocked, and adds
  /// `added` to the ray's.
  virtual void lightAnswers(int /*light*/, const LightSample&, const ShadowQuery* /*shadowRay*/,
                            const Vec3f& /*visible*/, const Vec3d& /*added*/) {}
  /// A branch that the material asks for is not followed: tooManyBounces, tooFaint (then `weight`
  /// is below the least) or totalReflection.
  virtual void branchEnds(RayKind, Outcome, float /*weight*/) {}
  /// What a term adds, before Interface::tint; all four, in the order of the sum.
  virtual void termIsKnown(ColorTerm, const Vec3d& /*color*/) {}
  /// The colour of the ray that began last and has not ended.
  virtual void rayEnds(const Vec3f& /*color*/) {}
};

class WatchedTracer : public RayTracer {
 public:
  /// Of the same scene, geometry and options as `tracer`. `observer` is not owned. It belongs to
  /// one thread, and so does this.
  WatchedTracer(const RayTracer& tracer, RayObserver& observer)
      : RayTracer(tracer.scene(), tracer.geometry(), tracer.options()), observer_(observer) {}

  Vec3f traceRay(Ray& ray, float tmin, int bounces, float weight, float indexOfRefraction,
                 Hit& hit) const override;

 protected:
  bool meet(const Ray& ray, double tmin, float index, Hit& hit,
            Interface& interface) const override;
  Vec3f shadeComponent(const Surface& s, double share) const override;
  Vec3d ambient(const Surface& s) const override;
  Vec3d lights(const Surface& s) const override;
  Vec3d light(int index, const Surface& s) const override;
  Vec3d branch(RayKind kind, const Surface& s) const override;

 private:
  Vec3d report(ColorTerm term, const Vec3d& color) const;

  RayObserver& observer_;
};
