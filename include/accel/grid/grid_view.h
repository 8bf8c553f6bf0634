// GridView: the cells of a grid that hold anything, as opaque boxes to look at. The objects
// themselves are not seen; of planes, which have no place in a grid, nothing is. What a cell holds
// is found out by one of two rules.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/grid/grid_frame.h"
#include "geometry/object3d.h"

/// How many objects, each face of a mesh being one, each cell of a grid holds.
struct CellCounts {
  /// No objects yet.
  explicit CellCounts(const GridFrame& cells) : frame(cells), counts(cells.cellCount()) {}

  GridFrame frame;  ///< of no cells where the scene has no bounded object
  std::vector<std::uint32_t> counts;

  std::uint32_t at(const GridSize& cell) const { return counts[frame.indexOf(cell)]; }
};

/// Divides the box of all bounded objects below `root` into cells. A cell holds a solid ball, a
/// triangle or a face of a mesh that reaches into it; what only touches its side does not count. A
/// ball that Transforms squash counts with its whole box. So does everything where all boxes
/// together overlap more than `mostTests` cells: time and memory grow with the objects and the
/// cells, not with their product.
CellCounts countReached(const Object3D& root, const GridSize& size, double mostTests = 0x1p26);

/// The same by a simpler rule, that of a grid which is filled box by box. The grid's box holds the
/// boxes of all bounded objects; that of a Transform is the one of the eight corners of what it
/// holds. A sphere under no Transform is in each cell whose centre is at most its radius and half
/// the cell's diagonal from its own; a sphere under Transforms, a triangle and a face are in each
/// cell that the box of their eight, or three, corners in the world touches, within 3e-5 of a cell.
/// Source: MIT 6.837, "Grid Acceleration", 2004.
CellCounts countTouched(const Object3D& root, const GridSize& size);

class GridView : public Object3D {
 public:
  /// A cell of n objects is drawn in palette[n - 1], the last colour standing for all larger n. The
  /// palette is not empty; its materials are not owned.
  GridView(CellCounts cells, std::vector<const Material*> palette)
      : cells_(std::move(cells)), palette_(std::move(palette)) {}

  const CellCounts& cells() const { return cells_; }

  /// The nearest side of an occupied cell: the one that the ray enters by, with its normal towards
  /// the ray, or, where the ray starts inside such a cell, the one it leaves by. What is hit is
  /// numbered as the cells; a ray that leaves a cell never meets the same one.
  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;

 private:
  CellCounts cells_;
  std::vector<const Material*> palette_;  // not owned
};
