// Grid: the whole scene as one Object3D that finds hits through a uniform grid of cells.
// It gives exactly the answers of the objects it was made from: same t, material, normal.
//
// Each cell lists the spheres, the triangles and the faces of meshes, inside Transforms too, whose
// surface in the world has a part in it (of spheres that Transforms squash, the box); a ray asks
// the cells it passes, one after the other, and stops where no later cell can hold anything nearer.
// Cells count as wider by a bound on all rounding, so that no hit is lost; what has no bounds, or
// numbers too extreme for that, is asked one by one, and so is everything by a ray from more than a
// thousand sizes of the scene away.
#pragma once
#include <memory>
#include <string>

#include "accel/grid_frame.h"
#include "accel/test_counts.h"
#include "geometry/object3d.h"

/// What bounds the memory of a grid.
struct GridLimits {
  double items = 0x1p25;    ///< objects and triangles, at the most, that are listed one by one
  double entries = 0x1p26;  ///< of the lists of all cells together
};

class Grid : public Object3D {
 public:
  /// Sorts everything below `root` into cells. `root` and what it holds are not owned, must outlive
  /// the grid and must not change any more. Where the lists would have more entries than `limits`
  /// allow, the sides of `size` are halved until they have not; where the scene has more items, 2,
  /// 4, 8 ... faces of a mesh in a row are listed as one.
  Grid(const Object3D& root, const GridSize& size, const GridLimits& limits = {});
  ~Grid() override;

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override;
  bool isBounded() const override;

  /// The same questions, adding to `counts` the cells visited and the objects and faces tested,
  /// each as often as cells list it.
  bool intersect(const Ray& ray, Hit& hit, double tmin, RayTestCounts& counts) const;
  bool occluded(const Ray& ray, double tmin, double tmax, RayTestCounts& counts) const;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor, RayTestCounts& counts) const;

  /// What was built, in one line: cells, entries of their lists, objects beside.
  std::string describe() const;

 private:
  struct Content;
  std::unique_ptr<const Content> content_;
  const Object3D* root_;  // not owned
};

/// A grid that counts for one thread.
class CountingGrid : public Object3D {
 public:
  /// Answers as `grid` does and adds to `counts`; neither is owned.
  CountingGrid(const Grid& grid, RayTestCounts& counts) : grid_(&grid), counts_(&counts) {}

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override {
    return grid_->intersect(ray, hit, tmin, *counts_);
  }
  bool occluded(const Ray& ray, double tmin, double tmax) const override {
    return grid_->occluded(ray, tmin, tmax, *counts_);
  }
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override {
    grid_->visitCrossings(ray, visitor, *counts_);
  }
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override {
    grid_->addBounds(toWorld, box);
  }
  bool isBounded() const override { return grid_->isBounded(); }

 private:
  const Grid* grid_;       // not owned
  RayTestCounts* counts_;  // not owned
};
