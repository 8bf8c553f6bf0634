// BuildRange: a run of items that becomes a subtree, and the boxes that the builder steers by.
#pragma once
#include <cstddef>
#include <limits>

#include "accel/bvh_builder.h"
#include "accel/simd4.h"

namespace accel {

/// A box in the first three lanes. The fourth holds anything: items are loaded whole.
struct Box4 {
  Float4 low, high;

  static Box4 empty() {
    constexpr float inf = std::numeric_limits<float>::infinity();
    return {Float4::all(inf), Float4::all(-inf)};
  }
  void extend(const Box4& other) {
    low = smaller(other.low, low);
    high = larger(other.high, high);
  }
  void extend(Float4 point) {
    low = smaller(point, low);
    high = larger(point, high);
  }
};

inline Box4 boxOf(const BuildItem& item) {
  return {Float4::load(item.low), Float4::load(item.high)};
}
/// Twice the centre of an item's box; the fourth lane is 0.
inline Float4 centerOf(const Box4& box) { return firstThree(box.low + box.high); }
inline float centerOf(const BuildItem& item, int axis) { return item.low[axis] + item.high[axis]; }

/// Half the surface of a box that is not empty.
inline float halfArea(const Box4& box) {
  float d[4];
  firstThree(box.high - box.low).store(d);
  return d[0] * d[1] + d[2] * (d[0] + d[1]);
}

struct BuildRange {
  BuildItem* first;
  std::size_t count;
  Box4 box;      ///< around the items
  Box4 centers;  ///< around twice their centres
  int splits;    ///< binary splits above it
};

/// Measures the boxes of `count` items.
inline BuildRange rangeOf(BuildItem* first, std::size_t count, int splits) {
  BuildRange range{first, count, Box4::empty(), Box4::empty(), splits};
  for (const BuildItem* item = first; item != first + count; ++item) {
    const Box4 box = boxOf(*item);
    range.box.extend(box);
    range.centers.extend(centerOf(box));
  }
  return range;
}

}  // namespace accel
