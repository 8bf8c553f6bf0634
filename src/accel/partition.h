// Partition in place: the items of a split's left side to the front. The new order depends on the
// items alone, never on the number of threads.
#pragma once
#include "accel/bins.h"
<<<<<<< HEAD
=======
#include "accel/parallel.h"
>>>>>>> dffe307b3992f29e03742783cc5958ccd9c6e64d

namespace accel {

/// What one partition yields besides the order.
struct Sides {
  std::size_t leftCount = 0;
  Box4 left = Box4::empty(), right = Box4::empty();  ///< around the items
  Box4 leftCenters = Box4::empty(), rightCenters = Box4::empty();
};

/// Partitions `count` items with one thread; the boxes are those that `split` says.
Sides partition(BuildItem* items, std::size_t count, const Split& split);

<<<<<<< HEAD
/// The same with up to `threads` threads; the boxes are measured on the way.
Sides partitionAndMeasure(BuildItem* items, std::size_t count, const Split& split, int threads);
=======
/// The same with all threads of `team`; the boxes are measured on the way.
Sides partitionAndMeasure(BuildItem* items, std::size_t count, const Split& split, Team& team);
>>>>>>> dffe307b3992f29e03742783cc5958ccd9c6e64d

}  // namespace accel
