// CountingTree: the plain objects, telling a TestTally what each ray takes.
#pragma once
#include "accel/test_tally.h"
#include "geometry/object3d.h"

/// Answers as the objects do. A mesh is one primitive for each of its faces: all of them for a
/// nearest hit and for crossings, those up to the first hit for a shadow.
class CountingTree : public Object3D {
 public:
  /// Answers as `root` does and tells `tally`; neither is owned. Any number of threads may ask.
  CountingTree(const Object3D& root, TestTally& tally) : root_(&root), tally_(&tally) {}

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;

 private:
  const Object3D* root_;  // not owned
  TestTally* tally_;      // not owned
};
