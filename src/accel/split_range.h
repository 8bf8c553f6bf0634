// splitRange: one step of the builder, a range in two.
#pragma once
#include "accel/best_split.h"
#include "accel/build_range.h"
#include "accel/thread_pool.h"

namespace accel {

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
