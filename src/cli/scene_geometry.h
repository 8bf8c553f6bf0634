// SceneGeometry: what answers for the objects of a scene in this run, and what it is called.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "accel/compiled_scene.h"
#include "accel/grid.h"
#include "accel/grid_view.h"
#include "accel/test_counts.h"
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
  /// object() in a form that adds to `counts` what each answer takes, for one thread; null where
  /// there is none. Neither this nor `counts` is owned.
  std::unique_ptr<const Object3D> counting(RayTestCounts& counts) const;
  /// What object() itself has counted: a compiled scene, where it is to count.
  RayTestCounts tallied() const { return tally_.total(); }
  /// The instruction set in use, "none" where there is no choice of one.
  const std::string& simd() const { return simd_; }
  /// In one line what was built.
  const std::string& description() const { return description_; }

 private:
  void makeView(const Object3D& root, const Acceleration& wanted);

  TestTally tally_;
  std::optional<CompiledScene> compiled_;
  std::optional<Grid> grid_;
  std::vector<PhongMaterial> palette_;
  std::optional<GridView> view_;
  const Object3D* object_;  // one of these, or the scene's group
  std::string simd_ = "none", description_ = "plain object tree";
};
