// BatchGeometry: what answers Object3D's questions for many rays in one call.
// Rays that begin together take much the same way through a tree of boxes, so that a node that is
// visited once for all of them costs less than once for each. Each answer is that of the ray alone.
#pragma once
#include "geometry/hit.h"

/// The question of Object3D::occluded, to be asked along with others.
struct ShadowQuery {
  Ray ray;
  double tmin = 0, tmax = 0;
  ShadowQuery() {}  // as that of Ray
  ShadowQuery(const Ray& r, double least, double most) : ray(r), tmin(least), tmax(most) {}
};

/// The most rays that belong together: the 16 x 16 pixels of a tile. More of them share fewer
/// nodes, and what is known of them no longer stays in the processor's first cache.
inline constexpr int kBatchSize = 256;

class BatchGeometry {
 public:
  virtual ~BatchGeometry() = default;

  /// Object3D::intersect for `count` rays, 0 to kBatchSize, each with its own hit: hits[i] is
  /// changed as intersect(rays[i], hits[i], tmins[i]) would.
  virtual void intersectBatch(const Ray* rays, const double* tmins, int count, Hit* hits) const = 0;
  /// Object3D::occluded for `count` queries, 0 to kBatchSize; stores each answer in blocked[i].
  virtual void occludedBatch(const ShadowQuery* queries, int count, bool* blocked) const = 0;
};
