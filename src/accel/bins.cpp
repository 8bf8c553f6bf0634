// Bins: filling them, and weighing the splits between them.
//
// Every item goes into one bin on each axis, the three at once. A sweep from the right leaves, for
// each border between bins, area times leaf blocks of all that is right of it, one axis a lane; a
// sweep from the left adds the left side, and the least sum on any axis is the split.
#include "accel/bins.h"

#include <algorithm>

namespace accel {

Binning::Binning(const Box4& centers, int bins) : base(firstThree(centers.low)), scale{} {
  float extent[4];
  firstThree(centers.high - centers.low).store(extent);
  for (float& x : extent) {
    // Less than one by more than the rounding, so that no centre lands in a slot too many. An
    // extent whose reciprocal overflows counts as none.
    const float factor = float(bins) * (1 - 0x1p-20f) / x;
    x = factor < 0x1p120f ? factor : 0;
  }
  scale = Float4::load(extent);
}

Bins::Bins(int bins) : bins_(bins) {
  for (int bin = 0; bin < bins_; ++bin) {
    for (Box4& box : boxes_[bin]) box = Box4::empty();
    Int4::all(0).store(counts_[bin]);
  }
}

void Bins::add(const BuildItem* items, std::size_t count, std::size_t step,
               const Binning& binning) {
  // From two places in turn: neighbours mostly share a slot, and the second would wait for the
  // first to be stored (build time 0.9).
  const std::size_t half = count / (2 * step) * step;
  const BuildItem* other = items + half;
  for (std::size_t i = 0; i < half; i += step) {
    add(items[i], binning);
    add(other[i], binning);
  }
  for (std::size_t i = 2 * half; i < count; i += step) add(items[i], binning);
}

Float4 Bins::areas(const Box4 (&boxes)[3], Float4 scale) {
  // Rows are the boxes of the three axes; columns, the sides along x, y and z.
  const Float4::Lanes a = (boxes[0].high - boxes[0].low).v, b = (boxes[1].high - boxes[1].low).v,
                      c = (boxes[2].high - boxes[2].low).v;
  const Float4 x = Float4::of(a[0], b[0], c[0]), y = Float4::of(a[1], b[1], c[1]),
               z = Float4::of(a[2], b[2], c[2]);
  return (x * scale) * y + (z * scale) * (x + y);
}

void Bins::sweepFromRight(Float4 scale, int blockBits, Float4* rightCost) const {
  const Int4 roundUp = Int4::all((1 << blockBits) - 1);
  Box4 right[3] = {Box4::empty(), Box4::empty(), Box4::empty()};
  Int4 count = Int4::all(0);
  for (int bin = bins_ - 1; bin > 0; --bin) {
    for (int axis = 0; axis < 3; ++axis) right[axis].extend(boxes_[bin][axis]);
    count = count + Int4::load(counts_[bin]);
    // Without items: infinity times 0, a NaN, which is never the least.
    rightCost[bin] = areas(right, scale) * toFloat(shiftedRight(count + roundUp, blockBits));
  }
}

Split Bins::best(const Binning& binning, const Box4& box, int blockBits) const {
  float extent[4];
  firstThree(box.high - box.low).store(extent);
  // Surfaces are taken relative to the longest side: those of tiny boxes would underflow.
  const float longest = std::max({extent[0], extent[1], extent[2], 0x1p-120f});
  const Float4 scale = Float4::all(1 / longest);
  Float4 rightCost[kMostBins];
  sweepFromRight(scale, blockBits, rightCost);

  const Int4 roundUp = Int4::all((1 << blockBits) - 1);
  Float4 least = Float4::all(std::numeric_limits<float>::infinity()), at = Float4::all(0);
  Box4 left[3] = {Box4::empty(), Box4::empty(), Box4::empty()};
  Int4 count = Int4::all(0);
  for (int bin = 0; bin + 1 < bins_; ++bin) {
    for (int axis = 0; axis < 3; ++axis) left[axis].extend(boxes_[bin][axis]);
    count = count + Int4::load(counts_[bin]);
    const Float4 blocks = toFloat(shiftedRight(count + roundUp, blockBits));
    const Float4 cost = areas(left, scale) * blocks + rightCost[bin + 1];
    at = whereLess(cost, least, Float4::all(float(bin)), at);
    least = smaller(cost, least);
  }

  Split split;
  float costs[4], bins[4], base[4], scales[4];
  least.store(costs);
  at.store(bins);
  binning.base.store(base);
  binning.scale.store(scales);
  float bestCost = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (!(costs[axis] < bestCost)) continue;
    bestCost = costs[axis];
    split.axis = axis;
  }
  if (split.axis < 0) return split;
  split.bin = int(bins[split.axis]);
  split.base = base[split.axis];
  split.scale = scales[split.axis];
  split.left = split.right = Box4::empty();
  for (int bin = 0; bin < bins_; ++bin) {
    (bin <= split.bin ? split.left : split.right).extend(boxes_[bin][split.axis]);
  }
  return split;
}

}  // namespace accel
