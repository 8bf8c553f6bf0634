// WaveTracer: the colours of many rays at once, each with the very bits that a RayTracer gives.
//
// It walks the same tree of rays breadth first. A generation of rays is a table (WaveRays), and
// every stage is a loop over its columns: all rays go through the scene together, then their shadow
// rays, light by light; then all mirrored and after them all refracted rays are the next
// generation. Formulas are those of the scalar classes, several rows at a time; sums grow in the
// RayTracer's order. A material, a light or an interface that has no wide form is asked row by row.
#pragma once
#include "geometry/ray_table.h"
#include "render/ray_counts.h"
#include "render/ray_tracer.h"

struct MaterialGroup;
struct WaveGeneration;
struct WaveHit;
struct WaveKernels;
struct WaveLight;
struct WaveRays;
struct WaveSurfaces;

/// For one thread.
class WaveTracer {
 public:
  /// Traces as `tracer` would, and leaves a few rays to it. Where `counts` is not null, all rays
  /// are counted there, and `tracer` is a WatchedTracer that tells the same `counts`. Neither is
  /// owned.
  explicit WaveTracer(const RayTracer& tracer, RayCounts* counts = nullptr);

  /// Memory for the tables that trace takes.
  Arena& arena() { return arena_; }
  const WaveKernels& kernels() const { return kernels_; }

  /// colors[i] becomes the colour that arrives along ray i, all of them after `bounces` others; in
  /// `hits` is stored what they meet, and in rays.tmax where.
  void trace(WaveRays& rays, int bounces, HitTable& hits, Vec3f* colors);
  /// Finds what eye rays meet, and no colours.
  void intersect(WaveRays& eyeRays, HitTable& hits);

 private:
  class Branches;

  void traceOneByOne(const WaveRays& rays, int bounces, HitTable& hits, Vec3f* colors);
  const Interface* meet(WaveRays& rays, HitTable& hits);
  void shade(const WaveGeneration& generation, WaveHit* met, int count, Vec3f* colors,
             Vec3d* mixtures);
  void setEpsilons(const WaveGeneration& generation, WaveSurfaces& surfaces) const;
  void setSides(WaveSurfaces& surfaces);
  void addAmbient(const MaterialGroup& group, const WaveGeneration& generation,
                  const WaveSurfaces& surfaces) const;
  void addLight(int index, const WaveGeneration& generation, const WaveSurfaces& surfaces);
  void sampleLight(int index, const WaveGeneration& generation, const WaveSurfaces& surfaces,
                   WaveLight& light) const;
  RowList findVisible(WaveLight& light);
  void reflect(const MaterialGroup& group, const WaveGeneration& generation, const WaveLight& light,
               const RowList& rows, const WaveSurfaces& surfaces) const;

  const BatchGeometry& batches() const { return batches_ ? *batches_ : rayByRay_; }

  const RayTracer& tracer_;       // not owned
  const BatchGeometry rayByRay_;  // the tracer's geometry
  const BatchGeometry* batches_;  // the same, where it answers many rays itself; else null
  RayCounts* counts_;             // not owned; may be null
  const WaveKernels& kernels_;
  const bool hasSources_;
  Arena arena_;
};
