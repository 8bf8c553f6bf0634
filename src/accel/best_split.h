// The split of the surface area heuristic.
#pragma once
#include "accel/build_range.h"

namespace accel {

/// Items with int((twice the centre on `axis` - base) * scale) <= bin go left.
struct Split {
  int axis = -1;  ///< -1: no centres differ
  int bin = 0;
  float base = 0, scale = 0;

  bool isLeft(const BuildItem& item) const {
    return int((item.low[axis] + item.high[axis] - base) * scale) <= bin;
  }
};

/// The split of a range that costs least, the sum of area times number of leaf blocks on both
/// sides, among those between bins on all three axes. Both sides have items.
Split bestSplit(const BuildRange& range);

}  // namespace accel
