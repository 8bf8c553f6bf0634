// CountingTree: the walk that Group and Transform make, with a count at each step.
#include "accel/counting_tree.h"

#include "accel/exact_type.h"
#include "geometry/group.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

using accel::exactly;

bool CountingTree::intersect(const Object3D& object, const Ray& ray, Hit& hit, double tmin) const {
  if (const auto* group = exactly<Group>(&object)) {
    ++counts_->nearest.nodes;
    bool found = false;
    for (const Object3D* member : group->getObjects()) {
      if (member && intersect(*member, ray, hit, tmin)) found = true;
    }
    return found;
  }
  if (const auto* transform = exactly<Transform>(&object)) {
    ++counts_->nearest.nodes;
    if (!intersect(*transform->getObject(), transform->toObject(ray), hit, tmin)) return false;
    transform->toParent(ray, hit);
    return true;
  }
  const auto* mesh = exactly<TriangleMesh>(&object);
  counts_->nearest.primitives += mesh ? mesh->getGeometry().faceCount() : 1;
  return object.intersect(ray, hit, tmin);
}

bool CountingTree::occluded(const Object3D& object, const Ray& ray, double tmin,
                            double tmax) const {
  if (const auto* group = exactly<Group>(&object)) {
    ++counts_->shadow.nodes;
    for (const Object3D* member : group->getObjects()) {
      if (member && occluded(*member, ray, tmin, tmax)) return true;
    }
    return false;
  }
  if (const auto* transform = exactly<Transform>(&object)) {
    ++counts_->shadow.nodes;
    return occluded(*transform->getObject(), transform->toObject(ray), tmin, tmax);
  }
  const auto* mesh = exactly<TriangleMesh>(&object);
  if (!mesh) {
    ++counts_->shadow.primitives;
    return object.occluded(ray, tmin, tmax);
  }
  double t;
  for (std::uint32_t face = 0; face < mesh->getGeometry().faceCount(); ++face) {
    ++counts_->shadow.primitives;
    if (mesh->nearestRoot(face, ray, tmin, tmax, t)) return true;
  }
  return false;
}

void CountingTree::visitCrossings(const Object3D& object, const Ray& ray,
                                  CrossingVisitor& visitor) const {
  if (const auto* group = exactly<Group>(&object)) {
    ++counts_->shadow.nodes;
    for (const Object3D* member : group->getObjects()) {
      if (member) visitCrossings(*member, ray, visitor);
    }
    return;
  }
  if (const auto* transform = exactly<Transform>(&object)) {
    ++counts_->shadow.nodes;
    return visitCrossings(*transform->getObject(), transform->toObject(ray), visitor);
  }
  const auto* mesh = exactly<TriangleMesh>(&object);
  counts_->shadow.primitives += mesh ? mesh->getGeometry().faceCount() : 1;
  object.visitCrossings(ray, visitor);
}
