// CountingTree: the walk that Group and Transform make, with a count at each step.
//
// The walk is written once, for any question: a Group asks its members in order, a Transform takes
// the ray in and the answer out, everything else is asked itself. A question says what it asks of a
// primitive, what becomes of a hit that leaves a Transform, and whether the first yes ends it.
#include "accel/test_tally.h"

#include "geometry/group.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

namespace {

std::uint32_t facesOf(const Object3D& primitive) {
  const auto* mesh = exactly<TriangleMesh>(&primitive);
  return mesh ? mesh->getGeometry().faceCount() : 1;
}

/// Asks ask(primitive, ray) for everything in `object`, up to the first true where `endsAtFirst`;
/// calls leave(transform, ray) where a true comes out of a Transform that `ray` has met. The depth
/// of recursion is the scene's nesting.
template <class Ask, class Leave>
bool walk(const Object3D& object, const Ray& ray, bool endsAtFirst, TestCounts& counts,
          const Ask& ask, const Leave& leave) {
  if (const auto* group = exactly<Group>(&object)) {
    ++counts.nodes;
    bool found = false;
    for (const Object3D* member : group->getObjects()) {
      if (member && walk(*member, ray, endsAtFirst, counts, ask, leave)) found = true;
      if (found && endsAtFirst) break;
    }
    return found;
  }
  if (const auto* transform = exactly<Transform>(&object)) {
    ++counts.nodes;
    const Ray inside = transform->toObject(ray);
    if (!walk(*transform->getObject(), inside, endsAtFirst, counts, ask, leave)) return false;
    leave(*transform, ray);
    return true;
  }
  return ask(object, ray);
}

void stayInside(const Transform&, const Ray&) {}

}  // namespace

bool CountingTree::intersect(const Ray& ray, Hit& hit, double tmin) const {
  TestCounts counts;
  const auto ask = [&](const Object3D& primitive, const Ray& inside) {
    counts.primitives += facesOf(primitive);
    return primitive.intersect(inside, hit, tmin);
  };
  const auto leave = [&](const Transform& transform, const Ray& outside) {
    transform.toParent(outside, hit);
  };
  const bool found = walk(*root_, ray, false, counts, ask, leave);
  tally_->addNearest(counts);
  return found;
}

bool CountingTree::occluded(const Ray& ray, double tmin, double tmax) const {
  TestCounts counts;
  const auto ask = [&](const Object3D& primitive, const Ray& inside) {
    const auto* mesh = exactly<TriangleMesh>(&primitive);
    bool isBlocked = false;
    for (std::uint32_t face = 0; face < facesOf(primitive) && !isBlocked; ++face) {
      double t;
      ++counts.primitives;
      isBlocked = mesh ? mesh->nearestRoot(face, inside, tmin, tmax, t)
                       : primitive.occluded(inside, tmin, tmax);
    }
    return isBlocked;
  };
  const bool isBlocked = walk(*root_, ray, true, counts, ask, stayInside);
  tally_->addShadow(counts);
  return isBlocked;
}

void CountingTree::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  TestCounts counts;
  const auto ask = [&](const Object3D& primitive, const Ray& inside) {
    counts.primitives += facesOf(primitive);
    primitive.visitCrossings(inside, visitor);
    return false;
  };
  walk(*root_, ray, false, counts, ask, stayInside);
  tally_->addShadow(counts);
}
