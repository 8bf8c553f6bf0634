// Bins: items sorted by their centres into slots along all three axes at once, and the best split.
// Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007.
#pragma once
#include "accel/build_range.h"

namespace accel {

constexpr int kMostBins = 16;

/// Which slot a centre belongs to: int((center - base) * scale), from 0 to the number of slots - 1
/// for every centre of the range. An axis along which the centres do not differ has scale 0.
struct Binning {
  Float4 base, scale;

  Binning(const Box4& centers, int bins);
};

/// Items with slot(center on `axis`) <= bin go left.
struct Split {
  int axis = -1;  ///< -1: no centres differ
  int bin = 0;
  float base = 0, scale = 0;
  Box4 left, right;  ///< the boxes of both sides

  bool isLeft(const BuildItem& item) const {
    return int((centerOf(item, axis) - base) * scale) <= bin;
  }
};

class Bins {
 public:
  /// `bins` slots an axis, 2 to kMostBins, all empty.
  explicit Bins(int bins);
  /// Adds every `step`-th of `count` items.
  void add(const BuildItem* items, std::size_t count, std::size_t step, const Binning& binning);
  /// The split of the least cost, the sum of area times number of leaf blocks on both sides, where
  /// a block is 2^blockBits items, begun ones counted whole. `box` is that of all items.
  Split best(const Binning& binning, const Box4& box, int blockBits) const;

 private:
  void add(const BuildItem& item, const Binning& binning) {
    const Box4 box = boxOf(item);
    std::int32_t slot[4];
    toInt((centerOf(box) - binning.base) * binning.scale).store(slot);
    for (int axis = 0; axis < 3; ++axis) {
      boxes_[slot[axis]][axis].extend(box);
      counts_[slot[axis]][axis] += item.primitives;
    }
  }
  /// Relative surfaces of the boxes on three axes, one a lane.
  static Float4 areas(const Box4 (&boxes)[3], Float4 scale);
  void sweepFromRight(Float4 scale, int blockBits, Float4* rightCost) const;

  const int bins_;
  Box4 boxes_[kMostBins][3];
  std::int32_t counts_[kMostBins][4];
};

}  // namespace accel
