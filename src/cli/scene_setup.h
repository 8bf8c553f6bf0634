// The scene of a run: reading it, what is to be said of it, and what answers for its objects.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "accel/test_tally.h"
#include "cli/request.h"
#include "geometry/object3d.h"
#include "scene/object_places.h"
#include "scene/scene_parser.h"
#include "shading/phong_material.h"
#include "system/sha256.h"

/// What is noted of a scene while it is read, as far as it is needed.
struct ReadNotes {
  Digest digest = {};   ///< of its bytes, for a checkpoint or a part
  ObjectPlaces places;  ///< for -pixel
};

/// Reads the scene that is wanted and its meshes. Where its course has other rules for such a
/// scene, `render` is adapted to them before. Throws InputError, OutOfMemory.
SceneParser readScene(RenderRequest& render, const RunRequest& run, ReadNotes& notes);

/// Prints the warnings, unless `quiet`, and finds out what rendering will ask.
void prepareScene(SceneParser& scene, const PictureRequest& picture, bool quiet);

/// What answers for the objects of a scene: the compiled scene, a grid, the cells of a grid, or the
/// objects themselves.
class SceneGeometry {
 public:
  /// Builds what is wanted with `threads` >= 1 threads; where `counts`, it counts what its answers
  /// take. `root`, the scene's group, is not owned; `cells` say how those of a grid are drawn.
  SceneGeometry(const Object3D& root, const Acceleration& wanted, const CellRules& cells,
                int threads, bool counts);

  const Object3D& object() const { return built_ ? *built_ : root_; }
  /// What object() has counted, where it was to count; but for a picture of cells.
  RayTestCounts tallied() const { return tally_.total(); }
  /// The instruction set in use, "none" where there is no choice of one.
  const std::string& simd() const { return simd_; }
  /// In one line what was built.
  const std::string& description() const { return description_; }

 private:
  void buildCells(const Acceleration& wanted, const CellRules& rules);

  TestTally tally_;  // first, as its counts stand in cache lines of their own
  const Object3D& root_;
  std::vector<PhongMaterial> paints_;      // of cells
  std::unique_ptr<const Object3D> built_;  // null where the scene's group answers itself
  std::string simd_ = "none", description_ = "plain object tree";
};
