// Batches of rays in a space: meshes take them together, other objects one by one.
#include <algorithm>

#include "accel/lone_rays.h"
#include "accel/packet.h"
#include "accel/space.h"

namespace accel {
namespace {

using Bits = std::uint64_t;
constexpr int kMost = RayPacket::kMostRays;

const TriangleMesh& meshInside(const Entry& entry, const Transform& transform) {
  return static_cast<const TriangleMesh&>(
      entry.kind == Entry::Kind::movedMesh ? *transform.getObject() : *entry.object);
}

Bits nearestInMovedMesh(const Kernels& kernels, const Entry& entry, const Ray* rays, int count,
                        NearestQuery* queries) {
  const auto& transform = static_cast<const Transform&>(*entry.object);
  Ray moved[kMost];
  for (int i = 0; i < count; ++i) moved[i] = transform.toObject(rays[i]);
  const Bits found = nearestInMesh(kernels, *entry.mesh, meshInside(entry, transform), entry.order,
                                   moved, count, queries);
  for (int i = 0; i < count; ++i) {
    if ((found >> i & 1) != 0) transform.toParent(rays[i], *queries[i].hit);
  }
  return found;
}

Bits occludedByMovedMesh(const Kernels& kernels, const Entry& entry, const ShadowQuery* queries,
                         int count) {
  const auto& transform = static_cast<const Transform&>(*entry.object);
  ShadowQuery moved[kMost];
  for (int i = 0; i < count; ++i) {
    moved[i] = {transform.toObject(queries[i].ray), queries[i].tmin, queries[i].tmax};
  }
  return occludedByMesh(kernels, *entry.mesh, meshInside(entry, transform), moved, count);
}

/// A plain object, rays one by one. Those that have hit nothing yet, or something before it in the
/// scene, are asked without a detour.
Bits nearestInPlain(const Space& space, const Entry& entry, const Ray* rays, int count,
                    NearestQuery* queries) {
  Bits found = 0;
  for (int i = 0; i < count; ++i) {
    NearestQuery& query = queries[i];
    if (query.order != NearestQuery::kNothing && query.order >= entry.order) {
      found |= Bits(space.nearestOf(entry, rays[i], query)) << i;
    } else if (entry.object->intersect(rays[i], *query.hit, query.tmin)) {
      query.found(query.hit->getT(), entry.order, query.hit->getFace());
      found |= Bits(1) << i;
    }
  }
  return found;
}

/// The shadow rays that are still on their way. Copies are made only where some have been dropped
/// and others are to go on together.
class OpenQueries {
 public:
  OpenQueries(const ShadowQuery* queries, int count) : queries_(queries), count_(count) {
    for (int i = 0; i < count; ++i) places_[i] = i;
  }
  int count() const { return count_; }
  bool isEmpty() const { return count_ == 0; }
  Bits blocked() const { return blocked_; }

  /// Asks isBlocked(query) for each and drops those that are.
  template <class Ask>
  void askEach(const Ask& isBlocked) {
    int kept = 0;
    for (int k = 0; k < count_; ++k) {
      const int i = places_[k];
      if (isBlocked(queries_[i])) {
        blocked_ |= Bits(1) << i;
      } else {
        places_[kept++] = i;
      }
    }
    count_ = kept;
  }
  /// Asks areBlocked(queries, count) for all together; bit k of the answer stands for queries[k].
  template <class Ask>
  void askTogether(const Ask& areBlocked) {
    const bool isWhole = blocked_ == 0;
    if (!isWhole) {
      for (int k = 0; k < count_; ++k) copies_[k] = queries_[places_[k]];
    }
    Bits bits = areBlocked(isWhole ? queries_ : copies_, count_);
    askEach([&](const ShadowQuery&) {
      const bool isBlocked = (bits & 1) != 0;
      bits >>= 1;
      return isBlocked;
    });
  }
  void addTo(LoneRays& lone) const {
    for (int k = 0; k < count_; ++k) {
      const ShadowQuery& query = queries_[places_[k]];
      lone.add(places_[k], query.ray, query.tmin, query.tmax);
    }
  }

 private:
  const ShadowQuery* queries_;  // not owned
  int count_;
  int places_[kMost];
  Bits blocked_ = 0;
  ShadowQuery copies_[kMost];
};

}  // namespace

Bits Space::nearest(const Ray* rays, int count, NearestQuery* queries) const {
  Bits found = 0;
  for (const std::uint32_t id : direct_) {
    const Entry& entry = entries_[id];
    if (entry.kind == Entry::Kind::mesh) {
      found |=
          nearestInMesh(*kernels_, *entry.mesh, static_cast<const TriangleMesh&>(*entry.object),
                        entry.order, rays, count, queries);
    } else if (entry.kind == Entry::Kind::movedMesh) {
      found |= nearestInMovedMesh(*kernels_, entry, rays, count, queries);
    } else if (entry.kind == Entry::Kind::plain) {
      tellDirect(&TestTally::addNearest, entry, count);
      found |= nearestInPlain(*this, entry, rays, count, queries);
    } else {
      for (int i = 0; i < count; ++i) {
        found |= Bits(nearestOf(entry, rays[i], queries[i])) << i;
      }
    }
  }
  if (bvh_.isEmpty()) return found;
  LoneRays lone;
  for (int i = 0; i < count; ++i) lone.add(i, rays[i], queries[i].tmin, queries[i].t);
  return found | lone.forEach(*kernels_, bvh_, [&](int i, TraversalRay& r, const TimeMap& time) {
    return nearestInTree(rays[i], queries[i], r, time);
  });
}

Bits Space::occluded(const ShadowQuery* queries, int count) const {
  OpenQueries open(queries, count);
  for (const std::uint32_t id : direct_) {
    if (open.isEmpty()) break;
    const Entry& entry = entries_[id];
    if (entry.kind == Entry::Kind::mesh) {
      open.askTogether([&](const ShadowQuery* together, int size) {
        return occludedByMesh(*kernels_, *entry.mesh,
                              static_cast<const TriangleMesh&>(*entry.object), together, size);
      });
    } else if (entry.kind == Entry::Kind::movedMesh) {
      open.askTogether([&](const ShadowQuery* together, int size) {
        return occludedByMovedMesh(*kernels_, entry, together, size);
      });
    } else {
      tellDirect(&TestTally::addShadow, entry, open.count());
      open.askEach([&](const ShadowQuery& q) { return occludedBy(entry, q.ray, q.tmin, q.tmax); });
    }
  }
  if (bvh_.isEmpty() || open.isEmpty()) return open.blocked();
  LoneRays lone;
  open.addTo(lone);
  return open.blocked() |
         lone.forEach(*kernels_, bvh_, [&](int i, TraversalRay& r, const TimeMap&) {
           return occludedInTree(queries[i].ray, queries[i].tmin, queries[i].tmax, r);
         });
}

}  // namespace accel
