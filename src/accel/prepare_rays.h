// What comes before every walk of a tree: a ray, several rays, or a beam of them are brought into
// the tree's normalised space, with the error bounds that hold there.
//
// A ray that walks alone is prepared by its kernel (prepare_one.inc); several that walk one after
// the other are prepared eight at a time (prepare_kernel.inc); those of a beam share one point, and
// become a RayPacket. See traversal.h for the normalised ray and packet.h for the packet.
#pragma once
#include "accel/packet.h"
#include "accel/traversal.h"
#include "geometry/ray.h"

namespace accel {

/// Fills `prepared` but for its candidates and call backs, and stores the map of its t'. Returns
/// false where the ray misses the box of the tree, which is not empty, between tmin and tmax.
inline bool prepareRay(const Kernels& kernels, const WideBvh& bvh, const Ray& ray, double tmin,
                       double tmax, TraversalRay& prepared, ParameterMap& time) {
  const Vec3d &o = ray.getOrigin(), &d = ray.getDirection();
  const double origin[] = {o.x(), o.y(), o.z()}, direction[] = {d.x(), d.y(), d.z()};
  if (!kernels.prepareRay(bvh, origin, direction, tmin, tmax, prepared, time)) return false;
  prepared.nodes = bvh.root();
  prepared.leaves = bvh.words();
  return true;
}

/// Rays that go one by one, but are prepared together: a tenth of the instructions of a scene of
/// one mesh and some mirrors.
class SingleRays {
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
    ParameterMap times[RayRows::kMost];
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

/// A beam: `count` lines through `point`, line i along the i-th direction, of which the part from
/// tmin[i] to tmax[i] counts, measured from the point in lengths of the direction. Each component
/// stands in an array of its own, so that the compiler can take several rays at once.
struct Beam {
  Vec3d point;
  double spread;  ///< every line passes the point at no more than this distance, along any axis
  int count;
  double direction[3][RayPacket::kMostRays];
  double tmin[RayPacket::kMostRays], tmax[RayPacket::kMostRays];
};

/// Fills `packet` for the tree `bvh`. Returns false where these rays had better be asked one by
/// one: directions of different octants, or a point too far away for the error bounds to be useful.
bool preparePacket(const WideBvh& bvh, const Beam& beam, RayPacket& packet);

}  // namespace accel
