// ObjectTree: one ray's questions.
//
// The way of a ray: what has no box (planes, objects of unknown classes) and what is too few for a
// tree is asked one by one, in scene order. Then the ray is prepared for the tree (prepare_rays.h)
// and a kernel walks it, nearest boxes first. Where its floats prove that a leaf's triangle or
// sphere is missed, nothing more happens; every other one becomes a Candidate, and here the
// object's own double function decides it. A hit lowers the ray's end, so that farther boxes are
// passed over.
//
// A member that is a mesh with a tree is handed on to mesh_queries.cpp; a Transform takes the ray
// into its inside by one multiplication, asks the mesh or the ObjectTree there, and takes the hit
// back out. t means the same on both sides.
//
// NearestQuery goes along all the way. Of equal t the first in the scene wins, whatever the order
// of the walk: a hit is accepted if it is nearer, or as near and earlier in the scene.
#include "accel/object_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/mesh_tree.h"
#include "accel/prepare_rays.h"

namespace accel {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// What the call backs of one traversal need to know.
struct TreeTraversal {
  const ObjectTree& tree;
  const Ray& ray;
  ParameterMap time;

  const TreeMember& memberOf(const Candidate& c) const {
    const std::uint32_t head = *c.words;
    const int n = countOf(head);
    return tree.member(c.words[1 + rowsOf(kindOf(head)) * n + c.lane] & ~kIdBit);
  }
};

struct NearestInTree : TreeTraversal {
  NearestQuery& query;
  bool found = false;

  static bool resolve(TraversalRay& r) {
    auto& self = *static_cast<NearestInTree*>(r.context);
    for (int i = 0; i < r.candidateCount; ++i) {
      if (r.candidates[i].tLow <= r.tmaxUp) self.consider(r, self.memberOf(r.candidates[i]));
    }
    r.candidateCount = 0;
    return false;
  }
  static bool askObject(TraversalRay& r, std::uint32_t id) {
    auto& self = *static_cast<NearestInTree*>(r.context);
    self.consider(r, self.tree.member(id));
    return false;
  }

  void consider(TraversalRay& r, const TreeMember& member) {
    if (!tree.nearestOf(member, ray, query)) return;
    found = true;
    r.tmaxUp = std::min(r.tmaxUp, time.above(query.t));
    r.tmaxDown = std::min(r.tmaxDown, time.below(query.t));
  }
};

struct OccludedInTree : TreeTraversal {
  double tmin, tmax;

  static bool resolve(TraversalRay& r) {
    const auto& self = *static_cast<const OccludedInTree*>(r.context);
    const int count = r.candidateCount;
    r.candidateCount = 0;
    return std::any_of(r.candidates, r.candidates + count, [&](const Candidate& c) {
      return self.tree.occludedBy(self.memberOf(c), self.ray, self.tmin, self.tmax);
    });
  }
  static bool askObject(TraversalRay& r, std::uint32_t id) {
    const auto& self = *static_cast<const OccludedInTree*>(r.context);
    return self.tree.occludedBy(self.tree.member(id), self.ray, self.tmin, self.tmax);
  }
};

struct CrossingsInTree : TreeTraversal {
  CrossingVisitor& visitor;

  static bool resolve(TraversalRay& r) {
    const auto& self = *static_cast<const CrossingsInTree*>(r.context);
    for (int i = 0; i < r.candidateCount; ++i) {
      self.tree.visitCrossingsOf(self.memberOf(r.candidates[i]), self.ray, self.visitor);
    }
    r.candidateCount = 0;
    return false;
  }
  static bool askObject(TraversalRay& r, std::uint32_t id) {
    const auto& self = *static_cast<const CrossingsInTree*>(r.context);
    self.tree.visitCrossingsOf(self.tree.member(id), self.ray, self.visitor);
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

bool ObjectTree::nearestOf(const TreeMember& member, const Ray& ray, NearestQuery& query) const {
  switch (member.kind) {
    case TreeMember::Kind::mesh:
      return nearestInMesh(*kernels_, *member.meshTree, member.mesh(), member.order, ray, query);
    case TreeMember::Kind::transformedMesh: {
      const Transform& transform = member.transform();
      if (!nearestInMesh(*kernels_, *member.meshTree, member.mesh(), member.order,
                         transform.toObject(ray), query)) {
        return false;
      }
      transform.toParent(ray, *query.hit);
      return true;
    }
    case TreeMember::Kind::transformedTree: {
      const Transform& transform = member.transform();
      if (!member.objectTree->nearest(transform.toObject(ray), query)) return false;
      transform.toParent(ray, *query.hit);
      return true;
    }
    case TreeMember::Kind::plain:
      break;
  }
  // What comes later in the scene has to be nearer; `hit` is up to date between two entries.
  if (query.order == NearestQuery::kNothing || query.order < member.order) {
    if (!member.object->intersect(ray, *query.hit, query.tmin)) return false;
    query.found(query.hit->getT(), member.order, query.hit->getFace());
    return true;
  }
  Hit hit(query.inclusiveBound());
  if (!member.object->intersect(ray, hit, query.tmin)) return false;
  if (!query.accepts(hit.getT(), member.order, hit.getFace())) return false;
  *query.hit = hit;
  query.found(hit.getT(), member.order, hit.getFace());
  return true;
}

bool ObjectTree::occludedBy(const TreeMember& member, const Ray& ray, double tmin,
                            double tmax) const {
  switch (member.kind) {
    case TreeMember::Kind::mesh:
      return occludedByMesh(*kernels_, *member.meshTree, member.mesh(), ray, tmin, tmax);
    case TreeMember::Kind::transformedMesh:
      return occludedByMesh(*kernels_, *member.meshTree, member.mesh(),
                            member.transform().toObject(ray), tmin, tmax);
    case TreeMember::Kind::transformedTree:
      return member.objectTree->occluded(member.transform().toObject(ray), tmin, tmax);
    case TreeMember::Kind::plain:
      break;
  }
  return member.object->occluded(ray, tmin, tmax);
}

void ObjectTree::visitCrossingsOf(const TreeMember& member, const Ray& ray,
                                  CrossingVisitor& visitor) const {
  switch (member.kind) {
    case TreeMember::Kind::mesh:
      return visitMeshCrossings(*kernels_, *member.meshTree, member.mesh(), ray, visitor);
    case TreeMember::Kind::transformedMesh:
      return visitMeshCrossings(*kernels_, *member.meshTree, member.mesh(),
                                member.transform().toObject(ray), visitor);
    case TreeMember::Kind::transformedTree:
      return member.objectTree->visitCrossings(member.transform().toObject(ray), visitor);
    case TreeMember::Kind::plain:
      break;
  }
  member.object->visitCrossings(ray, visitor);
}

bool ObjectTree::nearest(const Ray& ray, NearestQuery& query) const {
  bool found = false;
  for (const std::uint32_t id : direct_) {
    countPlain(&TestTally::addNearest, members_[id], 1);
    if (nearestOf(members_[id], ray, query)) found = true;
  }
  TraversalRay r;
  ParameterMap time;
  if (bvh_.isEmpty() || !prepareRay(*kernels_, bvh_, ray, query.tmin, query.t, r, time)) {
    return found;
  }
  return nearestInTree(ray, query, r, time) || found;
}

bool ObjectTree::nearestInTree(const Ray& ray, NearestQuery& query, TraversalRay& r,
                               const ParameterMap& time) const {
  NearestInTree self{{*this, ray, time}, query};
  attach(r, self);
  kernels_->nearest(r);
  kernels_->countNearest(r);
  NearestInTree::resolve(r);
  return self.found;
}

bool ObjectTree::occluded(const Ray& ray, double tmin, double tmax) const {
  for (const std::uint32_t id : direct_) {
    countPlain(&TestTally::addShadow, members_[id], 1);
    if (occludedBy(members_[id], ray, tmin, tmax)) return true;
  }
  TraversalRay r;
  ParameterMap time;
  return !bvh_.isEmpty() && prepareRay(*kernels_, bvh_, ray, tmin, tmax, r, time) &&
         occludedInTree(ray, tmin, tmax, r);
}

bool ObjectTree::occludedInTree(const Ray& ray, double tmin, double tmax, TraversalRay& r) const {
  OccludedInTree self{{*this, ray, {}}, tmin, tmax};
  attach(r, self);
  const bool isBlocked = kernels_->any(r);
  kernels_->countShadow(r);
  return isBlocked;
}

void ObjectTree::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  for (const std::uint32_t id : direct_) {
    countPlain(&TestTally::addShadow, members_[id], 1);
    visitCrossingsOf(members_[id], ray, visitor);
  }
  if (bvh_.isEmpty()) return;
  TraversalRay r;
  CrossingsInTree self{{*this, ray, {}}, visitor};
  if (!prepareRay(*kernels_, bvh_, ray, 0, kInf, r, self.time)) return;
  attach(r, self);
  kernels_->all(r);
  kernels_->countShadow(r);
  CrossingsInTree::resolve(r);
}

}  // namespace accel
