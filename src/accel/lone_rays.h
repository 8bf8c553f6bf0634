// LoneRays: rays that have nothing in common but the moment at which they are asked.
#pragma once
#include "accel/traversal.h"
#include "geometry/ray.h"

namespace accel {

/// Rays that go one by one, but are prepared together: a tenth of the instructions of a scene of
/// one mesh and some mirrors.
class LoneRays {
 public:
  /// Adds a ray, known as `place` from 0 to 63, of which the part from tmin to tmax counts.
  void add(int place, const Ray& ray, double tmin, double tmax) {
    for (int axis = 0; axis < 3; ++axis) {
      rows_.origin[axis][count_] = ray.getOrigin()[axis];
      rows_.direction[axis][count_] = ray.getDirection()[axis];
    }
    rows_.tmin[count_] = tmin;
    rows_.tmax[count_] = tmax;
    places_[count_++] = place;
  }

  /// Calls ask(place, prepared, time) for each ray that meets the box of the tree, which is not
  /// empty; bit `place` of the result is what it returns.
  template <class Ask>
  std::uint64_t forEach(const Kernels& kernels, const WideBvh& bvh, const Ask& ask) {
    fillUp();
    TraversalRay prepared[RayRows::kMost];
    TimeMap times[RayRows::kMost];
    std::uint64_t bits = 0;
    for (std::uint64_t left = kernels.prepareRays(bvh, rows_, count_, prepared, times); left != 0;
         left &= left - 1) {
      const int k = __builtin_ctzll(left);
      prepared[k].nodes = bvh.root();
      prepared[k].leaves = bvh.words();
      bits |= std::uint64_t(ask(places_[k], prepared[k], times[k])) << places_[k];
    }
    return bits;
  }

 private:
  /// The kernels take up to eight at a time: repeats the first up to there.
  void fillUp() {
    for (int k = count_; k % 8 != 0; ++k) {
      for (auto& row : rows_.origin) row[k] = row[0];
      for (auto& row : rows_.direction) row[k] = row[0];
      rows_.tmin[k] = rows_.tmin[0];
      rows_.tmax[k] = rows_.tmax[0];
    }
  }

  int count_ = 0;
  int places_[RayRows::kMost];
  RayRows rows_;
};

}  // namespace accel
