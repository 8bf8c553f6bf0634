// Group: a list of objects, in scene order.
#pragma once
#include <vector>

#include "geometry/object3d.h"

class Group : public Object3D {
 public:
  /// With room for numObjects; slots that are never filled are passed over.
  explicit Group(int numObjects = 0) : objects_(std::size_t(numObjects), nullptr) {}

  /// Puts `object` (not owned, not null) into slot `index` >= 0, growing the list if need be.
  void addObject(int index, const Object3D* object);
  /// Appends `object` (not owned, not null).
  void addObject(const Object3D* object) { objects_.push_back(object); }

  /// How many slots there are, those that are empty included.
  int getGroupSize() const { return int(objects_.size()); }
  /// In scene order; null where a slot is empty.
  const std::vector<const Object3D*>& getObjects() const { return objects_; }

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override;
  bool isBounded() const override;

 private:
  std::vector<const Object3D*> objects_;  // not owned; null where a slot is empty
};
