// Space: objects without bounds are asked one by one, the others through the tree.
#include "accel/space.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/mesh_tree.h"
#include "accel/prepare_ray.h"

namespace accel {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const TriangleMesh& meshOf(const Entry& entry) {
  return static_cast<const TriangleMesh&>(*entry.object);
}
const Transform& transformOf(const Entry& entry) {
  return static_cast<const Transform&>(*entry.object);
}
const TriangleMesh& movedMeshOf(const Entry& entry) {
  return static_cast<const TriangleMesh&>(*transformOf(entry).getObject());
}

/// What the call backs of one traversal need to know.
struct SpaceTraversal {
  const Space& space;
  const Ray& ray;
  TimeMap time;

  const Entry& entryOf(const Candidate& c) const {
    const std::uint32_t head = *c.words;
    const int n = countOf(head);
    return space.entry(c.words[1 + rowsOf(kindOf(head)) * n + c.lane] & ~kIdBit);
  }
};

struct NearestInSpace : SpaceTraversal {
  NearestQuery& query;
  bool found = false;

  static bool resolve(TraversalRay& r) {
    auto& self = *static_cast<NearestInSpace*>(r.context);
    for (int i = 0; i < r.candidateCount; ++i) {
      if (r.candidates[i].tLow <= r.tmaxUp) self.consider(r, self.entryOf(r.candidates[i]));
    }
    r.candidateCount = 0;
    return false;
  }
  static bool askObject(TraversalRay& r, std::uint32_t id) {
    auto& self = *static_cast<NearestInSpace*>(r.context);
    self.consider(r, self.space.entry(id));
    return false;
  }

  void consider(TraversalRay& r, const Entry& entry) {
    if (!space.nearestOf(entry, ray, query)) return;
    found = true;
    r.tmaxUp = std::min(r.tmaxUp, time.above(query.t));
    r.tmaxDown = std::min(r.tmaxDown, time.below(query.t));
  }
};

struct OccludedInSpace : SpaceTraversal {
  double tmin, tmax;

  static bool resolve(TraversalRay& r) {
    const auto& self = *static_cast<const OccludedInSpace*>(r.context);
    const int count = r.candidateCount;
    r.candidateCount = 0;
    return std::any_of(r.candidates, r.candidates + count, [&](const Candidate& c) {
      return self.space.occludedBy(self.entryOf(c), self.ray, self.tmin, self.tmax);
    });
  }
  static bool askObject(TraversalRay& r, std::uint32_t id) {
    const auto& self = *static_cast<const OccludedInSpace*>(r.context);
    return self.space.occludedBy(self.space.entry(id), self.ray, self.tmin, self.tmax);
  }
};

struct CrossingsInSpace : SpaceTraversal {
  CrossingVisitor& visitor;

  static bool resolve(TraversalRay& r) {
    const auto& self = *static_cast<const CrossingsInSpace*>(r.context);
    for (int i = 0; i < r.candidateCount; ++i) {
      self.space.visitCrossingsOf(self.entryOf(r.candidates[i]), self.ray, self.visitor);
    }
    r.candidateCount = 0;
    return false;
  }
  static bool askObject(TraversalRay& r, std::uint32_t id) {
    const auto& self = *static_cast<const CrossingsInSpace*>(r.context);
    self.space.visitCrossingsOf(self.space.entry(id), self.ray, self.visitor);
    return false;
  }
};

template <class Traversal>
void attach(TraversalRay& r, Traversal& traversal) {
  r.resolve = Traversal::resolve;
  r.askObject = Traversal::askObject;
  r.context = &traversal;
}

}  // namespace

double NearestQuery::inclusiveBound() const {
  return order == kNothing ? t : std::nextafter(t, std::numeric_limits<double>::infinity());
}

bool Space::nearestOf(const Entry& entry, const Ray& ray, NearestQuery& query) const {
  switch (entry.kind) {
    case Entry::Kind::mesh:
      return nearestInMesh(*kernels_, *entry.mesh, meshOf(entry), entry.order, ray, query);
    case Entry::Kind::movedMesh: {
      const Transform& transform = transformOf(entry);
      if (!nearestInMesh(*kernels_, *entry.mesh, movedMeshOf(entry), entry.order,
                         transform.toObject(ray), query)) {
        return false;
      }
      transform.toParent(ray, *query.hit);
      return true;
    }
    case Entry::Kind::movedSpace: {
      const Transform& transform = transformOf(entry);
      if (!entry.space->nearest(transform.toObject(ray), query)) return false;
      transform.toParent(ray, *query.hit);
      return true;
    }
    case Entry::Kind::plain:
      break;
  }
  // What comes later in the scene has to be nearer; `hit` is up to date between two entries.
  if (query.order == NearestQuery::kNothing || query.order < entry.order) {
    if (!entry.object->intersect(ray, *query.hit, query.tmin)) return false;
    query.found(query.hit->getT(), entry.order, query.hit->getFace());
    return true;
  }
  Hit hit(query.inclusiveBound());
  if (!entry.object->intersect(ray, hit, query.tmin)) return false;
  if (!query.accepts(hit.getT(), entry.order, hit.getFace())) return false;
  *query.hit = hit;
  query.found(hit.getT(), entry.order, hit.getFace());
  return true;
}

bool Space::occludedBy(const Entry& entry, const Ray& ray, double tmin, double tmax) const {
  switch (entry.kind) {
    case Entry::Kind::mesh:
      return occludedByMesh(*kernels_, *entry.mesh, meshOf(entry), ray, tmin, tmax);
    case Entry::Kind::movedMesh:
      return occludedByMesh(*kernels_, *entry.mesh, movedMeshOf(entry),
                            transformOf(entry).toObject(ray), tmin, tmax);
    case Entry::Kind::movedSpace:
      return entry.space->occluded(transformOf(entry).toObject(ray), tmin, tmax);
    case Entry::Kind::plain:
      break;
  }
  return entry.object->occluded(ray, tmin, tmax);
}

void Space::visitCrossingsOf(const Entry& entry, const Ray& ray, CrossingVisitor& visitor) const {
  switch (entry.kind) {
    case Entry::Kind::mesh:
      return visitMeshCrossings(*kernels_, *entry.mesh, meshOf(entry), ray, visitor);
    case Entry::Kind::movedMesh:
      return visitMeshCrossings(*kernels_, *entry.mesh, movedMeshOf(entry),
                                transformOf(entry).toObject(ray), visitor);
    case Entry::Kind::movedSpace:
      return entry.space->visitCrossings(transformOf(entry).toObject(ray), visitor);
    case Entry::Kind::plain:
      break;
  }
  entry.object->visitCrossings(ray, visitor);
}

bool Space::nearest(const Ray& ray, NearestQuery& query) const {
  bool found = false;
  for (const std::uint32_t id : direct_) {
    tellDirect(&TestTally::addNearest, entries_[id], 1);
    if (nearestOf(entries_[id], ray, query)) found = true;
  }
  TraversalRay r;
  TimeMap time;
  if (bvh_.isEmpty() || !prepareRay(*kernels_, bvh_, ray, query.tmin, query.t, r, time)) {
    return found;
  }
  return nearestInTree(ray, query, r, time) || found;
}

bool Space::nearestInTree(const Ray& ray, NearestQuery& query, TraversalRay& r,
                          const TimeMap& time) const {
  NearestInSpace self{{*this, ray, time}, query};
  attach(r, self);
  kernels_->nearest(r);
  kernels_->tellNearest(r);
  NearestInSpace::resolve(r);
  return self.found;
}

bool Space::occluded(const Ray& ray, double tmin, double tmax) const {
  for (const std::uint32_t id : direct_) {
    tellDirect(&TestTally::addShadow, entries_[id], 1);
    if (occludedBy(entries_[id], ray, tmin, tmax)) return true;
  }
  TraversalRay r;
  TimeMap time;
  return !bvh_.isEmpty() && prepareRay(*kernels_, bvh_, ray, tmin, tmax, r, time) &&
         occludedInTree(ray, tmin, tmax, r);
}

bool Space::occludedInTree(const Ray& ray, double tmin, double tmax, TraversalRay& r) const {
  OccludedInSpace self{{*this, ray, {}}, tmin, tmax};
  attach(r, self);
  const bool isBlocked = kernels_->any(r);
  kernels_->tellShadow(r);
  return isBlocked;
}

void Space::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  for (const std::uint32_t id : direct_) {
    tellDirect(&TestTally::addShadow, entries_[id], 1);
    visitCrossingsOf(entries_[id], ray, visitor);
  }
  if (bvh_.isEmpty()) return;
  TraversalRay r;
  CrossingsInSpace self{{*this, ray, {}}, visitor};
  if (!prepareRay(*kernels_, bvh_, ray, 0, kInf, r, self.time)) return;
  attach(r, self);
  kernels_->all(r);
  kernels_->tellShadow(r);
  CrossingsInSpace::resolve(r);
}

}  // namespace accel
