// SceneGeometry: what answers for the objects of a scene in this run, and what it is called.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "accel/compiled_scene.h"
#include "accel/counting_tree.h"
#include "accel/grid/grid.h"
#include "accel/grid/grid_view.h"
#include "accel/test_tally.h"
#include "cli/request.h"
#include "shading/phong_material.h"

class SceneGeometry {
 public:
  /// Builds what is wanted with `threads` >= 1 threads; where `counts`, a compiled scene counts
  /// what its answers take. `root`, the scene's group, is not owned.
  SceneGeometry(const Object3D& root, const Acceleration& wanted, int threads, bool counts);
  SceneGeometry(const SceneGeometry&) = delete;
  SceneGeometry& operator=(const SceneGeometry&) = delete;

  const Object3D& object() const { return *object_; }
  /// What object() has counted, where it was to count; but for a picture of cells.
  RayTestCounts tallied() const { return tally_.total(); }
  /// The instruction set in use, "none" where there is no choice of one.
  const std::string& simd() const { return simd_; }
  /// In one line what was built.
  const std::string& description() const { return description_; }

 private:
  void makeView(const Object3D& root, const Acceleration& wanted);

  TestTally tally_;
  std::optional<CountingTree> counted_;
  std::optional<CompiledScene> compiled_;
  std::optional<Grid> grid_;
  std::vector<PhongMaterial> palette_;
  std::optional<GridView> view_;
  const Object3D* object_;  // one of these, or the scene's group
  std::string simd_ = "none", description_ = "plain object tree";
};
