// GridView: the cells of a grid that hold anything, as opaque boxes to look at. The objects
// themselves are not seen; of planes, which have no place in a grid, nothing is.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "accel/grid/grid_frame.h"
#include "geometry/object3d.h"

class GridView : public Object3D {
 public:
  /// Divides the box of all bounded objects below `root` into cells. A cell is occupied where a
  /// solid ball, a triangle or a face of a mesh reaches into it; what only touches its side does
  /// not count. A ball that Transforms squash counts with its whole box. So does everything where
  /// all boxes together overlap more than `mostTests` cells: time and memory grow with the objects
  /// and the cells, not with their product. A cell of n objects is drawn in palette[n - 1], the
  /// last colour standing for all larger n. The palette is not empty; its materials are not owned.
  GridView(const Object3D& root, const GridSize& size, std::vector<const Material*> palette,
           double mostTests = 0x1p26);

  /// Nothing where the scene has no bounded object.
  const std::optional<GridFrame>& frame() const { return frame_; }
  /// How many objects, each face of a mesh being one, reach into a cell.
  std::uint32_t objectsIn(const GridSize& cell) const { return counts_[frame_->indexOf(cell)]; }

  /// The nearest side of an occupied cell: the one that the ray enters by, with its normal towards
  /// the ray, or, where the ray starts inside such a cell, the one it leaves by. What is hit is
  /// numbered as the cells; a ray that leaves a cell never meets the same one.
  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;

 private:
  void addToCorners(const CellRange& range);
  void sumCorners();

  std::vector<const Material*> palette_;  // not owned
  double extent_ = 0;                     // the largest coordinate of the box of all objects
  std::optional<GridFrame> frame_;
  std::vector<std::uint32_t> counts_;
};
