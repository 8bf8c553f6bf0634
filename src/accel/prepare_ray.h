// Prepares a ray for the kernels: normalised, moved to the tree's box, with its error bounds.
#pragma once
#include "accel/traversal.h"
#include "geometry/ray.h"

namespace accel {

/// How a ray's own t and the tree's t' belong together: t' = t * scale - shift.
struct TimeMap {
  double scale = 1, shift = 0;

  /// Floats surely not above, and surely not below, the t' of t.
  float below(double t) const;
  float above(double t) const;
};

/// Fills `prepared` but for its candidates and call backs, and stores the map of its t'. Returns
/// false where the ray misses the box of the tree between tmin and tmax.
bool prepareRay(const WideBvh& bvh, const Ray& ray, double tmin, double tmax,
                TraversalRay& prepared, TimeMap& time);

}  // namespace accel
