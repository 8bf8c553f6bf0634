// ObjectTree: batches of rays.
//
// Members that are asked one by one take all rays of a batch together where they are meshes, for
// those can be asked by packets; else ray after ray. For the tree the rays are prepared together
// and then walk one after the other, each on its own. Shadow rays that are blocked drop out on the
// way, and no further member is asked for them.
#include <algorithm>

#include "accel/object_tree.h"
#include "accel/packet.h"
#include "accel/prepare_rays.h"

namespace accel {
namespace {

using Bits = std::uint64_t;
constexpr int kMost = RayPacket::kMostRays;

Bits nearestInTransformedMesh(const Kernels& kernels, const TreeMember& member, const Ray* rays,
                              int count, NearestQuery* queries) {
  const Transform& transform = member.transform();
  Ray moved[kMost];
  for (int i = 0; i < count; ++i) moved[i] = transform.toObject(rays[i]);
  const Bits found =
      nearestInMesh(kernels, *member.meshTree, member.mesh(), member.order, moved, count, queries);
  for (int i = 0; i < count; ++i) {
    if ((found >> i & 1) != 0) transform.toParent(rays[i], *queries[i].hit);
  }
  return found;
}

Bits occludedByTransformedMesh(const Kernels& kernels, const TreeMember& member,
                               const ShadowQuery* queries, int count) {
  const Transform& transform = member.transform();
  ShadowQuery moved[kMost];
  for (int i = 0; i < count; ++i) {
    moved[i] = {transform.toObject(queries[i].ray), queries[i].tmin, queries[i].tmax};
  }
  return occludedByMesh(kernels, *member.meshTree, member.mesh(), moved, count);
}

/// A plain object, rays one by one. Those that have hit nothing yet, or something before it in the
/// scene, are asked without a detour.
Bits nearestInPlain(const ObjectTree& tree, const TreeMember& member, const Ray* rays, int count,
                    NearestQuery* queries) {
  Bits found = 0;
  for (int i = 0; i < count; ++i) {
    NearestQuery& query = queries[i];
    if (query.order != NearestQuery::kNothing && query.order >= member.order) {
      found |= Bits(tree.nearestOf(member, rays[i], query)) << i;
    } else if (member.object->intersect(rays[i], *query.hit, query.tmin)) {
      query.found(query.hit->getT(), member.order, query.hit->getFace());
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
  void addTo(SingleRays& singles) const {
    for (int k = 0; k < count_; ++k) {
      const ShadowQuery& query = queries_[places_[k]];
      singles.add(places_[k], query.ray, query.tmin, query.tmax);
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

Bits ObjectTree::nearest(const Ray* rays, int count, NearestQuery* queries) const {
  Bits found = 0;
  for (const std::uint32_t id : direct_) {
    const TreeMember& member = members_[id];
    if (member.kind == TreeMember::Kind::mesh) {
      found |= nearestInMesh(*kernels_, *member.meshTree, member.mesh(), member.order, rays, count,
                             queries);
    } else if (member.kind == TreeMember::Kind::transformedMesh) {
      found |= nearestInTransformedMesh(*kernels_, member, rays, count, queries);
    } else if (member.kind == TreeMember::Kind::plain) {
      countPlain(&TestTally::addNearest, member, count);
      found |= nearestInPlain(*this, member, rays, count, queries);
    } else {
      for (int i = 0; i < count; ++i) {
        found |= Bits(nearestOf(member, rays[i], queries[i])) << i;
      }
    }
  }
  if (bvh_.isEmpty()) return found;
  SingleRays singles;
  for (int i = 0; i < count; ++i) singles.add(i, rays[i], queries[i].tmin, queries[i].t);
  return found |
         singles.forEach(*kernels_, bvh_, [&](int i, TraversalRay& r, const ParameterMap& time) {
           return nearestInTree(rays[i], queries[i], r, time);
         });
}

Bits ObjectTree::occluded(const ShadowQuery* queries, int count) const {
  OpenQueries open(queries, count);
  for (const std::uint32_t id : direct_) {
    if (open.isEmpty()) break;
    const TreeMember& member = members_[id];
    if (member.kind == TreeMember::Kind::mesh) {
      open.askTogether([&](const ShadowQuery* together, int size) {
        return occludedByMesh(*kernels_, *member.meshTree, member.mesh(), together, size);
      });
    } else if (member.kind == TreeMember::Kind::transformedMesh) {
      open.askTogether([&](const ShadowQuery* together, int size) {
        return occludedByTransformedMesh(*kernels_, member, together, size);
      });
    } else {
      countPlain(&TestTally::addShadow, member, open.count());
      open.askEach([&](const ShadowQuery& q) { return occludedBy(member, q.ray, q.tmin, q.tmax); });
    }
  }
  if (bvh_.isEmpty() || open.isEmpty()) return open.blocked();
  SingleRays singles;
  open.addTo(singles);
  return open.blocked() |
         singles.forEach(*kernels_, bvh_, [&](int i, TraversalRay& r, const ParameterMap&) {
           return occludedInTree(queries[i].ray, queries[i].tmin, queries[i].tmax, r);
         });
}

}  // namespace accel
