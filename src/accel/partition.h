// Partition in place: the items of a split's left side to the front. The new order depends on the
// items alone, never on the number of threads.
#pragma once
#include "accel/bins.h"
#include "accel/parallel.h"

namespace accel {

/// What one partition yields besides the order.
struct Sides {
  std::size_t leftCount = 0;
  Box4 left = Box4::empty(), right = Box4::empty();  ///< around the items
  Box4 leftCenters = Box4::empty(), rightCenters = Box4::empty();
};

/// Partitions `count` items with one thread; the boxes are those that `split` says.
Sides partition(BuildItem* items, std::size_t count, const Split& split);

/// The same with all threads of `team`; the boxes are measured on the way.
Sides partitionAndMeasure(BuildItem* items, std::size_t count, const Split& split, Team& team);

}  // namespace accel
