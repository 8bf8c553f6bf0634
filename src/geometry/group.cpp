// Group: asks its objects in scene order; a later one must be nearer to win.
//
// The hit that one object leaves is the bound of the search for the next, so of several at the same
// t the first wins, as everywhere. A slot that nothing was put into is passed over.
#include "geometry/group.h"

#include <algorithm>

void Group::addObject(int index, const Object3D* object) {
  const std::size_t slot = std::size_t(index);
  if (slot >= objects_.size()) objects_.resize(slot + 1, nullptr);
  objects_[slot] = object;
}

bool Group::intersect(const Ray& ray, Hit& hit, double tmin) const {
  bool found = false;
  for (const Object3D* object : objects_) {
    if (object && object->intersect(ray, hit, tmin)) found = true;
  }
  return found;
}

bool Group::occluded(const Ray& ray, double tmin, double tmax) const {
  return std::any_of(objects_.begin(), objects_.end(), [&](const Object3D* object) {
    return object && object->occluded(ray, tmin, tmax);
  });
}

void Group::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  for (const Object3D* object : objects_) {
    if (object) object->visitCrossings(ray, visitor);
  }
}

void Group::addBounds(const Matrix& toWorld, BoundingBox& box) const {
  for (const Object3D* object : objects_) {
    if (object) object->addBounds(toWorld, box);
  }
}

/// One plane among the objects is enough to reach without end.
bool Group::isBounded() const {
  return std::all_of(objects_.begin(), objects_.end(),
                     [](const Object3D* object) { return !object || object->isBounded(); });
}
