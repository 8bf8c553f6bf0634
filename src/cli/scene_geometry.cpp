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

SceneGeometry::SceneGeometry(const Object3D& root, const Acceleration& wanted, int threads,
                             bool counts)
    : object_(&root) {
  TestTally* const tally = counts ? &tally_ : nullptr;
  if (wanted.kind == Acceleration::Kind::fast) {
    object_ = &compiled_.emplace(root, threads, wanted.simd, tally);
    simd_ = nameOf(availableSimd(wanted.simd));
    description_ = compiled_->describe();
  } else if (wanted.cellPicture != Acceleration::CellPicture::none) {
    makeView(root, wanted);
  } else if (wanted.kind == Acceleration::Kind::grid) {
    object_ = &grid_.emplace(root, wanted.gridSize, GridLimits{}, tally);
    description_ = grid_->describe();
  } else if (tally) {
    object_ = &counted_.emplace(root, *tally);
  }
}

void SceneGeometry::makeView(const Object3D& root, const Acceleration& wanted) {
  for (const CountColor& each : kCountColors) palette_.push_back(paintOf(each.color));
  std::vector<const Material*> paints;
  if (wanted.cellPicture == Acceleration::CellPicture::occupied) {
    paints.push_back(&palette_.front());
  } else {
    for (std::size_t i = 0; i < palette_.size(); ++i)
      paints.resize(kCountColors[i].most, &palette_[i]);
  }
  object_ = &view_.emplace(root, wanted.gridSize, std::move(paints));
  description_ = "cells of a grid";
}
