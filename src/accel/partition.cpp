// Partition: each item is moved once, from a gap at one end into a gap at either end.
#include "accel/partition.h"

#include <algorithm>
#include <vector>

namespace accel {
namespace {

/// Large ranges are partitioned in chunks of so many items, whatever the number of threads.
constexpr std::size_t kChunk = 16384;

/// Items in a gap. Reading so many before the next decision where to read hides its latency.
constexpr std::size_t kGap = 16;

/// The ends that are written to: items below `left` and from `right` on are in place.
struct Ends {
  BuildItem* left;
  BuildItem* right;
  Sides sides;

  /// Writes each item to both ends and moves the end that it belongs to: a branch would be guessed
  /// wrongly half of the time. There must be room at both ends. `step` is 1 or -1, away from the
  /// end that the items came from, so that none is overwritten before it is read.
  template <bool kMeasure>
  void put(const BuildItem* item, std::size_t count, std::ptrdiff_t step, const Split& split) {
    BuildItem* toLeft = left;
    BuildItem* toRight = right;
    Box4 leftBox = sides.left, rightBox = sides.right;
    Box4 leftCenters = sides.leftCenters, rightCenters = sides.rightCenters;
    for (; count > 0; --count, item += step) {
      const Box4 box = boxOf(*item);
      const int isLeft = split.isLeft(*item) ? 1 : 0;
      box.low.store(toLeft->low);
      box.high.store(toLeft->high);
      box.low.store(toRight[-1].low);
      box.high.store(toRight[-1].high);
      toLeft += isLeft;
      toRight -= 1 - isLeft;
      const Float4 center = centerOf(box);
      leftCenters.extend(unlessMasked(center, isLeft - 1));
      rightCenters.extend(unlessMasked(center, -isLeft));
      if (!kMeasure) continue;
      leftBox.extend({unlessMasked(box.low, isLeft - 1), unlessMasked(box.high, isLeft - 1)});
      rightBox.extend({unlessMasked(box.low, -isLeft), unlessMasked(box.high, -isLeft)});
    }
    left = toLeft;
    right = toRight;
    sides.left = leftBox;
    sides.right = rightBox;
    sides.leftCenters = leftCenters;
    sides.rightCenters = rightCenters;
  }
};

/// A chunk after its own partition: items [begin, middle) are left, [middle, end) right.
struct Chunk {
  std::size_t begin, middle, end;
};

/// Where the items of one kind of misplaced run are: piece after piece, in order.
struct Run {
  std::size_t begin, end;
};

/// Exchanges the right items in front of `middle` with the left ones behind it.
void exchangeMisplaced(BuildItem* items, const std::vector<Chunk>& chunks, std::size_t middle,
                       Team& team) {
  std::vector<Run> early, late;
  for (const Chunk& chunk : chunks) {
    const Run right{chunk.middle, std::min(chunk.end, middle)};
    const Run left{std::max(chunk.begin, middle), chunk.middle};
    if (right.begin < right.end) early.push_back(right);
    if (left.begin < left.end) late.push_back(left);
  }
  struct Exchange {
    std::size_t a, b, count;
  };
  std::vector<Exchange> exchanges;
  for (std::size_t i = 0, j = 0; i < early.size() && j < late.size();) {
    const std::size_t count =
        std::min({early[i].end - early[i].begin, late[j].end - late[j].begin, kChunk});
    exchanges.push_back({early[i].begin, late[j].begin, count});
    if ((early[i].begin += count) == early[i].end) ++i;
    if ((late[j].begin += count) == late[j].end) ++j;
  }
  team.forEachIndex(exchanges.size(), [&](std::size_t i) {
    const Exchange& e = exchanges[i];
    std::swap_ranges(items + e.a, items + e.a + e.count, items + e.b);
  });
}

template <bool kMeasure>
Sides partitionChunk(BuildItem* items, std::size_t count, const Split& split) {
  Ends ends{items, items + count, {}};
  BuildItem saved[3 * kGap];
  std::size_t savedCount = 0;
  BuildItem* from = items;
  BuildItem* to = items + count;
  if (count > 3 * kGap) {
    from += kGap;
    to -= kGap;
    std::copy(items, from, saved);
    std::copy(to, items + count, saved + kGap);
    savedCount = 2 * kGap;
    while (to - from >= std::ptrdiff_t(kGap)) {
      // The gaps sum up to two: read where the gap is the smaller one, then both ends have room.
      const bool atLeft = from - ends.left <= ends.right - to;
      const BuildItem* next = atLeft ? from : to - 1;
      from += atLeft ? kGap : 0;
      to -= atLeft ? 0 : kGap;
      ends.put<kMeasure>(next, kGap, atLeft ? 1 : -1, split);
    }
  }
  std::copy(from, to, saved + savedCount);
  savedCount += std::size_t(to - from);
  ends.put<kMeasure>(saved, savedCount, 1, split);
  ends.sides.leftCount = std::size_t(ends.left - items);
  return ends.sides;
}

}  // namespace

Sides partition(BuildItem* items, std::size_t count, const Split& split) {
  Sides sides = partitionChunk<false>(items, count, split);
  sides.left = split.left;
  sides.right = split.right;
  return sides;
}

Sides partitionAndMeasure(BuildItem* items, std::size_t count, const Split& split, Team& team) {
  const std::size_t chunkCount = (count + kChunk - 1) / kChunk;
  std::vector<Chunk> chunks(chunkCount);
  std::vector<Sides> sides(chunkCount);
  team.forEachIndex(chunkCount, [&](std::size_t i) {
    const std::size_t begin = i * kChunk, end = std::min(begin + kChunk, count);
    sides[i] = partitionChunk<true>(items + begin, end - begin, split);
    chunks[i] = {begin, begin + sides[i].leftCount, end};
  });
  Sides all;
  for (const Sides& part : sides) {
    all.leftCount += part.leftCount;
    all.left.extend(part.left);
    all.right.extend(part.right);
    all.leftCenters.extend(part.leftCenters);
    all.rightCenters.extend(part.rightCenters);
  }
  exchangeMisplaced(items, chunks, all.leftCount, team);
  return all;
}

}  // namespace accel
