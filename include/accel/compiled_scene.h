// CompiledScene: the whole scene as one Object3D that answers fast.
// It gives exactly the answers of the objects it was made from: same t, material, normal.
//
// From here to the decision of one triangle:
//   compiled_scene.cpp                      Trees::ask: all rays of a table
//   asked_objects.cpp                       ObjectTree::ask: what stands alone, then the tree
//   question.h, question.cpp                askTree: the rays become Streams
//   stream.h                                the walk, the filter, its error bounds
//   walk_stream.inc, leaf_filters.inc       boxes, then eight triangles at once, in float
//   nearest_question.cpp, question_walk.h   which candidates are left, and isHit
//   geometry/triangle.cpp                   triangle::intersect, in double
#pragma once
#include <memory>
#include <string>

#include "accel/test_tally.h"
#include "geometry/ray_table.h"
#include "math/simd_level.h"

class CompiledScene : public Object3D, public BatchGeometry {
 public:
  /// Compiles everything below `root` with `threads` >= 1 threads. `root` and what it holds are
  /// not owned, must outlive the compiled scene and must not change any more.
  /// Where `tally` is not null, it is told what each answer takes; it is not owned.
  CompiledScene(const Object3D& root, int threads, SimdLevel simd = SimdLevel::automatic,
                TestTally* tally = nullptr);
  ~CompiledScene() override;

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void intersectAll(const RayTable& rays, HitTable& hits, Arena& arena) const override;
  void occludedAll(const RayTable& rays, bool* blocked, Arena& arena) const override;
  void visitAllCrossings(const RayTable& rays, RowCrossingVisitor& visitor,
                         Arena& arena) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;
  SimdLevel simdLevel() const override;

  /// What was built, in one line: instruction set, trees, nodes, bytes.
  std::string describe() const;
  /// Bytes that all trees occupy, vertices and scene objects not counted.
  std::size_t treeBytes() const;

 private:
  struct Trees;
  std::unique_ptr<const Trees> trees_;
  const Object3D* root_;  // not owned
};
