// One step of the builder: which split, and the items of its left side moved to the front.
//
// The split is the one of least cost by the surface area heuristic, among those between the bins of
// all three axes. Where no centres differ, or the tree has got too deep, the range is halved: by
// centres, by sizes, at last by numbers.
//
// The partition is in place and depends on the items alone, never on the number of threads. Each
// item is moved once, from a gap at one end into a gap at either end; large ranges are partitioned
// in chunks, and then the right items in front of the middle change places with the left ones
// behind it.
#include "accel/split_range.h"

#include <algorithm>
#include <vector>

#include "accel/bins.h"

namespace accel {
namespace {

/// What one partition yields besides the order.
struct Sides {
  std::size_t leftCount = 0;
  Box4 left = Box4::empty(), right = Box4::empty();  ///< around the items
  Box4 leftCenters = Box4::empty(), rightCenters = Box4::empty();
};

/// Large ranges are partitioned in chunks of so many items, whatever the number of threads.
constexpr std::size_t kItemsPerChunk = 16384;

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
                       ThreadPool& pool) {
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
        std::min({early[i].end - early[i].begin, late[j].end - late[j].begin, kItemsPerChunk});
    exchanges.push_back({early[i].begin, late[j].begin, count});
    if ((early[i].begin += count) == early[i].end) ++i;
    if ((late[j].begin += count) == late[j].end) ++j;
  }
  pool.forEachIndex(exchanges.size(), [&](std::size_t i) {
    const Exchange& e = exchanges[i];
    std::swap_ranges(items + e.a, items + e.a + e.count, items + e.b);
  });
}

/// Partitions `count` items with one thread; the boxes of both sides are measured where wanted.
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

/// The same with all threads of `pool`, chunk by chunk; the boxes are measured on the way.
Sides partitionAndMeasure(BuildItem* items, std::size_t count, const Split& split,
                          ThreadPool& pool) {
  const std::size_t chunkCount = (count + kItemsPerChunk - 1) / kItemsPerChunk;
  std::vector<Chunk> chunks(chunkCount);
  std::vector<Sides> sides(chunkCount);
  pool.forEachIndex(chunkCount, [&](std::size_t i) {
    const std::size_t begin = i * kItemsPerChunk, end = std::min(begin + kItemsPerChunk, count);
    sides[i] = partitionChunk<true>(items + begin, end - begin, split);
    chunks[i] = {begin, begin + sides[i].leftCount, end};
  });
  Sides all;
  for (const Sides& each : sides) {
    all.leftCount += each.leftCount;
    all.left.extend(each.left);
    all.right.extend(each.right);
    all.leftCenters.extend(each.leftCenters);
    all.rightCenters.extend(each.rightCenters);
  }
  exchangeMisplaced(items, chunks, all.leftCount, pool);
  return all;
}

int binsFor(std::size_t count) { return count >= 128 ? 16 : count >= 32 ? 12 : 8; }

/// Leaves are filled by counting whole blocks of eight where that matters, near the bottom.
int blockBitsFor(const BuildRange& range, bool uniform) {
  return uniform && range.first->kind != LeafKind::objects && range.count <= 64 ? 3 : 0;
}

/// Of large ranges only a sample is binned, about 4096 items: enough to choose among 45 splits
/// (build time 0.93). The step is odd, for what repeats in a mesh repeats by twos.
std::size_t sampleStep(std::size_t count) { return count < 16384 ? 1 : count / 4096 | 1; }

Split bestSplit(const BuildRange& range, bool uniform, std::size_t step) {
  const int binCount = binsFor(range.count);
  const Binning binning(range.centers, binCount);
  Bins bins(binCount);
  bins.add(range.first, range.count, step, binning);
  return bins.best(binning, range.box, blockBitsFor(range, uniform));
}

/// The axis along which twice the centres spread most, or -1 where none differ.
int widestAxis(const Box4& centers) {
  float extent[4];
  firstThree(centers.high - centers.low).store(extent);
  const int axis = int(std::max_element(extent, extent + 3) - extent);
  return extent[axis] > 0 ? axis : -1;
}

/// Orders for halving by number: by centre or, where all are equal, by size, smaller boxes first.
void halve(const BuildRange& range) {
  const int axis = widestAxis(range.centers);
  const auto key = [axis](const BuildItem& item) {
    return axis >= 0 ? centerOf(item, axis) : halfArea(boxOf(item));
  };
  std::nth_element(range.first, range.first + range.count / 2, range.first + range.count,
                   [&](const BuildItem& a, const BuildItem& b) {
                     const float keyA = key(a), keyB = key(b);
                     return keyA != keyB ? keyA < keyB : a.id < b.id;
                   });
}

}  // namespace

int fittingLeaf(const BuildRange& range, bool uniform) {
  const LeafKind kind = range.first->kind;
  if (range.count > std::size_t(mostInLeaf(kind))) return 0;
  int primitives = 0;
  for (const BuildItem* item = range.first; item != range.first + range.count; ++item) {
    if (!uniform && item->kind != kind) return 0;
    primitives += item->primitives;
  }
  return primitives <= mostInLeaf(kind) ? primitives : 0;
}

void splitRange(const BuildRange& range, bool uniform, ThreadPool& pool, BuildRange& left,
                BuildRange& right) {
  const int splits = range.splits + 1;
  const std::size_t step = sampleStep(range.count);
  Split split;
  if (range.splits < kMostSahSplits) split = bestSplit(range, uniform, step);
  if (split.axis >= 0) {
    // Boxes come from the bins or, where these have not seen all items, from the partition.
    Sides sides;
    if (step == 1) {
      sides = partitionChunk<false>(range.first, range.count, split);
      sides.left = split.left;
      sides.right = split.right;
    } else {
      sides = partitionAndMeasure(range.first, range.count, split, pool);
    }
    left = {range.first, sides.leftCount, sides.left, sides.leftCenters, splits};
    right = {range.first + sides.leftCount, range.count - sides.leftCount, sides.right,
             sides.rightCenters, splits};
    return;
  }
  halve(range);
  left = rangeOf(range.first, range.count / 2, splits);
  right = rangeOf(range.first + range.count / 2, range.count - range.count / 2, splits);
}

}  // namespace accel
