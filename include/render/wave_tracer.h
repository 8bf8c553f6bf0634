// WaveTracer: the colours of many rays at once, each with the very bits that a RayTracer gives.
//
// It walks the same tree of rays breadth first: all rays of a batch go through the scene together,
// then their shadow rays, light by light, then all mirrored and at last all refracted rays, each as
// a batch of its own. Rays that go together share the nodes that they visit. The terms are the
// Shader's, summed in the RayTracer's order.
#pragma once
#include "render/ray_counts.h"
#include "render/ray_tracer.h"

class WaveTracer {
 public:
  /// Traces as `tracer` would, and leaves batches of few rays to it. Where `counts` is not null,
  /// all rays are counted there, and `tracer` is a WatchedTracer that tells the same `counts`.
  /// Neither is owned.
  explicit WaveTracer(const RayTracer& tracer, RayCounts* counts = nullptr);

  /// colors[i] becomes the colour that arrives along ray i, all of them after `bounces` others; in
  /// hits[i], passed in fresh, what it meets is stored.
  void trace(const RayBatch& batch, int bounces, Hit* hits, Vec3f* colors) const;
  /// Finds what eye rays meet, and no colours.
  void intersect(const RayBatch& eyeRays, Hit* hits) const;

 private:
  class SurfaceBatch;
  struct Branches;

  void traceOneByOne(const RayBatch& batch, int bounces, Hit* hits, Vec3f* colors) const;
  std::vector<Interface> meet(const RayBatch& batch, Hit* hits) const;
  void shade(const std::vector<Surface>& surfaces, Vec3f* colors) const;
  void addLight(int index, const std::vector<Surface>& surfaces, std::vector<Vec3d>& sums) const;
  void findVisible(const std::vector<Surface>& surfaces, const std::vector<std::size_t>& places,
                   const std::vector<LightSample>& samples, Vec3f* visible) const;
  void addBranches(const Branches& branches, int bounces, std::vector<Vec3d>& sums) const;

  const RayTracer& tracer_;       // not owned
  const BatchGeometry* batches_;  // the tracer's geometry; null where it is asked ray by ray
  RayCounts* counts_;             // not owned; may be null
};
