// GridFrame and CellWalk.
//
// The walk: the ray is clipped by the whole frame, which gives the first cell. For each axis it is
// known at which t the ray would leave the cell across it; it does so across the axis of the least
// t, where the cell's number changes by one, and only that axis needs a new t. Each t is computed
// from its plane's own number, one division, so that no error adds up from cell to cell (the source
// adds a constant instead). A ray along an axis never leaves across the others: t = infinity.
// Source: Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987.
#include "accel/grid/grid_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
/// The least thickness of a grid: of its longest side, and of its largest coordinate.
constexpr double kThinnest = 0x1p-10, kFinest = 0x1p-40;

}  // namespace

/// Of an empty box all planes stand at NaN, so that every walk is at its end.
GridFrame::GridFrame(const BoundingBox& box, const GridSize& size)
    : size_(box.isEmpty() ? GridSize{} : size) {
  const double least = std::max(box.longestSide() * kThinnest, box.extent() * kFinest);
  for (int axis = 0; axis < 3; ++axis) {
    const double thickness = box.high()[axis] - box.low()[axis];
    const double missing = least > 0 ? std::max(least - thickness, 0.0) : 1;
    low_[axis] = box.low()[axis] - missing / 2;
    side_[axis] = (thickness + missing) / size[axis];
  }
}

int GridFrame::cellAt(int axis, double x) const {
  const double number = std::floor((x - low_[axis]) / side_[axis]);
  return number > 0 ? int(std::min(number, double(size_[axis] - 1))) : 0;  // 0 for NaN
}

CellRange GridFrame::overlappedBy(const BoundingBox& box) const {
  CellRange range{};
  for (int axis = 0; axis < 3; ++axis) {
    range.first[axis] = cellAt(axis, box.low()[axis]);
    const double last = std::ceil((box.high()[axis] - low_[axis]) / side_[axis]) - 1;
    range.last[axis] = int(std::clamp(last, double(range.first[axis]), double(size_[axis] - 1)));
  }
  return range;
}

CellWalk::CellWalk(const GridFrame& frame, const Ray& ray, double tmin)
    : frame_(&frame), origin_(ray.getOrigin()), direction_(ray.getDirection()), enterT_(tmin) {
  double left = kInf;
  for (int axis = 0; axis < 3; ++axis) {
    const int end = frame.size()[axis];
    const bool falls = std::signbit(direction_[axis]);  // -0 too: both are infinite, in order
    const double near = parameterAt(axis, falls ? end : 0);
    const double far = parameterAt(axis, falls ? 0 : end);
    if (near > enterT_) enterAxis_ = axis;
    enterT_ = std::max(enterT_, near);  // 0 / 0, in the plane of a side, changes nothing
    left = std::min(left, far);
  }
  if (!(left >= enterT_ && std::isfinite(left - enterT_))) return;
  atEnd_ = false;
  for (int axis = 0; axis < 3; ++axis) {
    cell_[axis] = frame.cellAt(axis, origin_[axis] + direction_[axis] * enterT_);
    if (axis == enterAxis_) cell_[axis] = direction_[axis] > 0 ? 0 : frame.size()[axis] - 1;
    findExit(axis);
  }
}

/// Finds where the ray leaves the cell across `axis`, and chooses where it does so first.
void CellWalk::findExit(int axis) {
  const double d = direction_[axis];
  exits_[axis] = d == 0 ? kInf : parameterAt(axis, cell_[axis] + (d > 0 ? 1 : 0));
  exitAxis_ = exits_[1] < exits_[0] ? 1 : 0;
  if (exits_[2] < exits_[exitAxis_]) exitAxis_ = 2;
}
