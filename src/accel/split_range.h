// The steps of the builder's way down: which split, the range in two, and where it ends.
#pragma once
#include "accel/build_range.h"
#include "accel/thread_pool.h"

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
/// sides, among those between bins on all three axes (best_split.cpp). Both sides have items.
Split bestSplit(const BuildRange& range);

/// Splits a range of at least two items: as `split` says or, where its axis is -1, into halves of
/// as many items. Large ranges are split by all threads of `pool`; the outcome does not depend on
/// their number.
void splitRange(const BuildRange& range, const Split& split, ThreadPool& pool, BuildRange& left,
                BuildRange& right);

/// How many primitives the range has where it may be one leaf: few enough, of one kind; else 0.
int fittingLeaf(const BuildRange& range);

/// The most binary levels of a tree: beyond kMostSahSplits a range is halved by number.
constexpr int kMostSahSplits = 40;
constexpr int kMostSplits = kMostSahSplits + 1 + 32;

}  // namespace accel
