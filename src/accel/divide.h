// Divide: one step of the builder, a range in two.
#pragma once
#include "accel/build_range.h"
#include "accel/parallel.h"

namespace accel {

/// Divides a range of at least two items that cannot be one leaf. `uniform` says that all items of
/// the tree are of one kind. Large ranges are divided by all threads of `team`; the outcome does
/// not depend on their number.
void divide(const BuildRange& range, bool uniform, Team& team, BuildRange& left, BuildRange& right);

/// True where the range may be one leaf: few enough items, of one kind.
bool fitsLeaf(const BuildRange& range, bool uniform);

/// The most binary levels of a tree: beyond kMostSahSplits a range is halved by number.
constexpr int kMostSahSplits = 40;
constexpr int kMostSplits = kMostSahSplits + 32;

}  // namespace accel
