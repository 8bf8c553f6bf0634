// SceneGeometry: the compiled scene, a grid, the cells of a grid, or the objects themselves.
#include "cli/scene_geometry.h"

namespace {

/// How -visualize_grid_count paints a cell of at most so many objects; the last one holds for all
/// that have more. README.txt shows the same list.
struct CountColor {
  std::size_t most;
  Vec3f color;
};
constexpr CountColor kCountColors[] = {
    {1, {1, 1, 1}},          {2, {0.6f, 0.3f, 0.9f}},  {3, {0.2f, 0.3f, 1}},
    {4, {0.2f, 0.8f, 0.9f}}, {8, {0.2f, 0.8f, 0.2f}},  {16, {1, 0.9f, 0.1f}},
    {32, {1, 0.5f, 0.1f}},   {33, {0.9f, 0.1f, 0.1f}},
};

PhongMaterial paintOf(const Vec3f& color) { return {color, {}, 1, {}, {}, 1}; }

}  // namespace

SceneGeometry::SceneGeometry(const Object3D& root, const Options& options, int threads)
    : object_(&root) {
  TestTally* const tally = options.stats ? &tally_ : nullptr;
  if (options.accel == Options::Accel::fast) {
    object_ = &compiled_.emplace(root, threads, options.simd, tally);
    simd_ = nameOf(availableSimd(options.simd));
    description_ = compiled_->describe();
  } else if (options.gridPicture != Options::GridPicture::none) {
    makeView(root, options);
  } else if (options.accel == Options::Accel::grid) {
    object_ = &grid_.emplace(root, options.gridSize, GridLimits{}, tally);
    description_ = grid_->describe();
  } else if (tally) {
    object_ = &counted_.emplace(root, *tally);
  }
}

void SceneGeometry::makeView(const Object3D& root, const Options& options) {
  for (const CountColor& each : kCountColors) palette_.push_back(paintOf(each.color));
  std::vector<const Material*> paints;
  if (options.gridPicture == Options::GridPicture::cells) {
    paints.push_back(&palette_.front());
  } else {
    for (std::size_t i = 0; i < palette_.size(); ++i)
      paints.resize(kCountColors[i].most, &palette_[i]);
  }
  object_ = &view_.emplace(root, options.gridSize, std::move(paints));
  description_ = "cells of a grid";
}
