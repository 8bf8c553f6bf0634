// CountingTree: the plain object tree, counting what is asked of it.
#pragma once
#include "accel/test_counts.h"
#include "geometry/object3d.h"

class CountingTree : public Object3D {
 public:
  /// Answers as `root` does and adds to `counts`; neither is owned. For one thread.
  CountingTree(const Object3D& root, RayTestCounts& counts) : root_(&root), counts_(&counts) {}

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override {
    return intersect(*root_, ray, hit, tmin);
  }
  bool occluded(const Ray& ray, double tmin, double tmax) const override {
    return occluded(*root_, ray, tmin, tmax);
  }
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override {
    visitCrossings(*root_, ray, visitor);
  }
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override {
    root_->addBounds(toWorld, box);
  }
  bool isBounded() const override { return root_->isBounded(); }

 private:
  // The same for one object below the root. The depth of recursion is the scene's nesting.
  bool intersect(const Object3D& object, const Ray& ray, Hit& hit, double tmin) const;
  bool occluded(const Object3D& object, const Ray& ray, double tmin, double tmax) const;
  void visitCrossings(const Object3D& object, const Ray& ray, CrossingVisitor& visitor) const;

  const Object3D* root_;   // not owned
  RayTestCounts* counts_;  // not owned
};
