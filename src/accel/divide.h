// Divide: one step of the builder, a range in two.
#pragma once
#include "accel/build_range.h"
<<<<<<< HEAD
=======
#include "accel/parallel.h"
>>>>>>> dffe307b3992f29e03742783cc5958ccd9c6e64d

namespace accel {

/// Divides a range of at least two items that cannot be one leaf. `uniform` says that all items of
<<<<<<< HEAD
/// the tree are of one kind. Uses up to `threads` threads; the outcome does not depend on them.
void divide(const BuildRange& range, bool uniform, int threads, BuildRange& left,
            BuildRange& right);
=======
/// the tree are of one kind. Large ranges are divided by all threads of `team`; the outcome does
/// not depend on their number.
void divide(const BuildRange& range, bool uniform, Team& team, BuildRange& left, BuildRange& right);
>>>>>>> dffe307b3992f29e03742783cc5958ccd9c6e64d

/// True where the range may be one leaf: few enough items, of one kind.
bool fitsLeaf(const BuildRange& range, bool uniform);

/// The most binary levels of a tree: beyond kMostSahSplits a range is halved by number.
constexpr int kMostSahSplits = 40;
constexpr int kMostSplits = kMostSahSplits + 32;

}  // namespace accel
