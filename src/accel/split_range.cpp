// One step of the builder: the items of the left side are moved to the front. Where there is no
// split they are halved: by centres, by sizes, at last by numbers.
//
// The partition is in place and depends on the items alone, never on the number of threads. Both
// halves of a large range may be partitioned side by side; then the right items of the first half
// change places with the left ones of the second.
#include "accel/split_range.h"

#include <algorithm>

namespace accel {
namespace {

/// Longer runs are partitioned in two.
constexpr std::size_t kMostAtOnce = 65536;

/// Moves the left ones of a run of items to the front, and adds them to their side; returns their
/// number. Each item is written to the border and what was there to the item's place, whichever
/// side it belongs to: a branch would be guessed wrongly half of the time.
std::size_t partitionRun(BuildItem* items, std::size_t count, const Split& split,
                         BuildRange (&sides)[2]) {
  BuildItem* border = items;
  for (BuildItem* item = items; item != items + count; ++item) {
    const Box4 moved = Box4::of(*item), other = Box4::of(*border);
    const bool isLeft = split.isLeft(*item);
    other.store(item->low, item->high);
    moved.store(border->low, border->high);
    border += isLeft;
    sides[isLeft ? 0 : 1].measure(moved);
  }
  return std::size_t(border - items);
}

/// The same, with all threads.
std::size_t partition(BuildItem* items, std::size_t count, const Split& split, ThreadPool& pool,
                      BuildRange (&sides)[2]) {
  if (count <= kMostAtOnce) return partitionRun(items, count, split, sides);
  const std::size_t half = count / 2;
  BuildRange others[2];
  std::size_t first = 0, second = 0;
  pool.both([&] { first = partition(items, half, split, pool, sides); },
            [&] { second = partition(items + half, count - half, split, pool, others); });
  for (int k = 0; k < 2; ++k) sides[k].measure(others[k]);
  BuildItem* const misplaced = items + first;
  const std::size_t exchanged = std::min(half - first, second);
  std::swap_ranges(misplaced, misplaced + exchanged, items + half + second - exchanged);
  return first + second;
}

/// Orders for halving by number: by centre or, where all are equal, by size, smaller boxes first.
void halve(const BuildRange& range) {
  const int axis = range.centers.longestAxis();
  const bool differ = range.centers.longestSide() > 0;
  const auto key = [&](const BuildItem& item) {
    return differ ? item.low[axis] + item.high[axis] : Box4::of(item).halfArea();
  };
  std::nth_element(range.first, range.first + range.count / 2, range.first + range.count,
                   [&](const BuildItem& a, const BuildItem& b) {
                     const float keyA = key(a), keyB = key(b);
                     return keyA != keyB ? keyA < keyB : a.id < b.id;
                   });
}

}  // namespace

int fittingLeaf(const BuildRange& range) {
  const LeafKind kind = range.first->kind;
  if (range.count > std::size_t(mostInLeaf(kind))) return 0;
  int primitives = 0;
  for (const BuildItem* item = range.first; item != range.first + range.count; ++item) {
    if (item->kind != kind) return 0;
    primitives += item->primitives;
  }
  return primitives <= mostInLeaf(kind) ? primitives : 0;
}

void splitRange(const BuildRange& range, const Split& split, ThreadPool& pool, BuildRange& left,
                BuildRange& right) {
  BuildRange sides[2];
  sides[0].count = range.count / 2;
  if (split.axis >= 0) {
    sides[0].count = partition(range.first, range.count, split, pool, sides);
  } else {
    halve(range);
  }
  sides[0].first = range.first;
  sides[1].first = range.first + sides[0].count;
  sides[1].count = range.count - sides[0].count;
  for (BuildRange& side : sides) {
    side.splits = range.splits + 1;
    if (split.axis < 0) side.measureItems();
  }
  left = sides[0];
  right = sides[1];
}

}  // namespace accel
