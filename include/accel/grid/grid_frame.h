// GridFrame: a box divided into equal cells; CellWalk: the cells that a ray passes, in order.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/ray.h"
#include "math/bounding_box.h"
#include "math/vec3.h"

/// How many cells a grid has along x, y and z, each at least 1; or which cell is meant, counting
/// from 0.
using GridSize = Vec3<int>;

/// Limits of a grid: cells along one axis, and in all.
inline constexpr int kMaxGridSide = 1024;
inline constexpr int kMaxGridCells = 1 << 24;

/// The cells first[axis] to last[axis] along each axis, both included.
struct CellRange {
  GridSize first, last;

  /// How many cells there are along each axis, and in all.
  GridSize size() const { return last - first + GridSize(1, 1, 1); }
  double count() const { return double(size().x()) * size().y() * size().z(); }
};

/// Calls visit(cell) for every cell of the range, in the order of GridFrame::indexOf.
template <class Visit>
void forEachCell(const CellRange& range, const Visit& visit) {
  GridSize cell{};
  for (cell[2] = range.first[2]; cell[2] <= range.last[2]; ++cell[2]) {
    for (cell[1] = range.first[1]; cell[1] <= range.last[1]; ++cell[1]) {
      for (cell[0] = range.first[0]; cell[0] <= range.last[0]; ++cell[0]) visit(cell);
    }
  }
}

class GridFrame {
 public:
  /// Divides `box`, whose corners are finite unless it is empty, which makes no cells whatever the
  /// size; else at most kMaxGridCells. A side that is thinner than 2^-10 of the longest one is
  /// widened to that; a box that is a point gets a size of its own.
  GridFrame(const BoundingBox& box, const GridSize& size);

  /// 0 along each axis where there are no cells.
  const GridSize& size() const { return size_; }
  std::size_t cellCount() const {
    return std::size_t(size_.x()) * std::size_t(size_.y()) * std::size_t(size_.z());
  }
  CellRange allCells() const { return {{}, size_ - GridSize(1, 1, 1)}; }
  std::size_t indexOf(const GridSize& cell) const {
    return (std::size_t(cell.z()) * std::size_t(size_.y()) + std::size_t(cell.y())) *
               std::size_t(size_.x()) +
           std::size_t(cell.x());
  }

  /// How long a cell is along each axis.
  const Vec3d& side() const { return side_; }
  /// Where plane `number` (0..size) stands on `axis`: the lower side of the cell of that number.
  double plane(int axis, int number) const { return low_[axis] + side_[axis] * number; }
  /// That of some cells in a block; of one cell; of all.
  BoundingBox boxOf(const CellRange& cells) const {
    return {low_ + side_ * cells.first, low_ + side_ * (cells.last + GridSize(1, 1, 1))};
  }
  BoundingBox boxOf(const GridSize& cell) const { return boxOf(CellRange{cell, cell}); }
  BoundingBox box() const { return boxOf(allCells()); }
  /// The number of the cell that holds x, the nearest one where x lies outside; 0 for NaN.
  int cellAt(int axis, double x) const;
  /// The cells that `box` overlaps. One that it only touches from outside does not count, but there
  /// is at least one cell along each axis, the nearest where the box lies outside.
  CellRange overlappedBy(const BoundingBox& box) const;

 private:
  GridSize size_;
  Vec3d low_, side_;
};

class CellWalk {
 public:
  /// Starts in the first cell that the ray passes at t >= tmin, which may be -infinity; a ray that
  /// passes none is at its end at once. The frame is not owned. Each cell is left at the t at which
  /// the next one is entered. A place within rounding of a cell's side may count to either
  /// neighbour: off by at most 2^-50 of the largest coordinate of origin and frame.
  CellWalk(const GridFrame& frame, const Ray& ray, double tmin);

  bool isAtEnd() const { return atEnd_; }
  /// The cell, while not at the end.
  const GridSize& cell() const { return cell_; }
  std::size_t index() const { return frame_->indexOf(cell_); }
  /// From which t to which t the ray is in the cell, and the axes across which it comes in and goes
  /// out; enterAxis is -1 where the walk starts inside, enterT being tmin.
  double enterT() const { return enterT_; }
  double exitT() const { return exits_[exitAxis_]; }
  int enterAxis() const { return enterAxis_; }
  int exitAxis() const { return exitAxis_; }
  /// Goes on to the next cell, or to the end.
  void advance() {
    const int axis = exitAxis_;
    enterT_ = std::max(enterT_, exits_[axis]);
    enterAxis_ = axis;
    cell_[axis] += direction_[axis] > 0 ? 1 : -1;
    atEnd_ = cell_[axis] < 0 || cell_[axis] >= frame_->size()[axis] || !std::isfinite(enterT_);
    if (!atEnd_) findExit(axis);
  }

 private:
  /// The t at which the ray passes a plane; along it infinite, or not a number within the plane.
  double parameterAt(int axis, int plane) const {
    return (frame_->plane(axis, plane) - origin_[axis]) / direction_[axis];
  }
  void findExit(int axis);

  const GridFrame* frame_;  // not owned
  Vec3d origin_, direction_;
  GridSize cell_{};
  double enterT_;
  double exits_[3]{};  // where the ray would leave the cell across each axis
  int enterAxis_ = -1, exitAxis_ = 0;
  bool atEnd_ = true;
};
