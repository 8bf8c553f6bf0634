// WatchedTracer: a RayTracer that tells a RayObserver what it does, step by step. The colours are
// the RayTracer's own.
#pragma once
#include "render/ray_observer.h"
#include "render/ray_tracer.h"

class WatchedTracer : public RayTracer {
 public:
  /// As RayTracer; `observer` is not owned. It belongs to one thread, and so does the tracer.
  WatchedTracer(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
                RayObserver& observer)
      : RayTracer(scene, geometry, options), observer_(observer) {}

  Vec3f traceRay(Ray& ray, float tmin, int bounces, float weight, float indexOfRefraction,
                 Hit& hit) const override;

 protected:
  bool meet(const Ray& ray, double tmin, Hit& hit, Interface& interface) const override;
  Vec3f shadeComponent(const Surface& s, double share) const override;
  Vec3d ambient(const Surface& s) const override;
  Vec3d lights(const Surface& s) const override;
  Vec3d light(int index, const Surface& s) const override;
  Vec3d mirror(const Surface& s) const override;
  Vec3d transmitted(const Surface& s) const override;

 private:
  Vec3d report(ColorTerm term, const Vec3d& color) const;
  Vec3d branch(RayKind kind, const Surface& s, Outcome outcome, TracedRay& next) const;

  RayObserver& observer_;
};
