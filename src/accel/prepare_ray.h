// Prepares a ray for the kernels: normalised, moved to the tree's box, with its error bounds.
#pragma once
#include "accel/traversal.h"
#include "geometry/ray.h"

namespace accel {

/// Fills `prepared` but for its candidates and call backs, and stores the map of its t'. Returns
/// false where the ray misses the box of the tree, which is not empty, between tmin and tmax.
inline bool prepareRay(const Kernels& kernels, const WideBvh& bvh, const Ray& ray, double tmin,
                       double tmax, TraversalRay& prepared, TimeMap& time) {
  const Vec3d &o = ray.getOrigin(), &d = ray.getDirection();
  const double origin[] = {o.x(), o.y(), o.z()}, direction[] = {d.x(), d.y(), d.z()};
  if (!kernels.prepareRay(bvh, origin, direction, tmin, tmax, prepared, time)) return false;
  prepared.nodes = bvh.root();
  prepared.leaves = bvh.words();
  return true;
}

}  // namespace accel
