// BuildRange: a run of items that becomes a subtree, and the boxes that the builder steers by.
//
// Boxes are in vectors of four floats, by the compiler's own: SSE2 or NEON where there is one. Only
// what every processor of its kind has is used, so that all translation units see the same
// functions.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "accel/bvh_builder.h"

namespace accel {

typedef float Float4 __attribute__((vector_size(16)));
typedef std::int32_t Int4 __attribute__((vector_size(16)));

inline Float4 loadFloat4(const float* p) {
  Float4 result;
  std::memcpy(&result, p, sizeof result);
  return result;
}
inline Float4 allFloat4(float x) { return Float4{x, x, x, x}; }
/// b where a is a NaN, on every processor. Compilers make one instruction of each where there is
/// one.
inline Float4 smaller(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 larger(Float4 a, Float4 b) { return a > b ? a : b; }
/// The first three lanes; the fourth becomes 0.
inline Float4 firstThree(Float4 a) { return Float4(Int4(a) & Int4{-1, -1, -1, 0}); }

/// A box in the first three lanes. The fourth holds anything: items are loaded whole.
struct Box4 {
  Float4 low, high;

  static Box4 empty() {
    constexpr float inf = std::numeric_limits<float>::infinity();
    return {allFloat4(inf), allFloat4(-inf)};
  }
  /// The box of an item or a node.
  template <class Boxed>
  static Box4 of(const Boxed& boxed) {
    return {loadFloat4(boxed.low), loadFloat4(boxed.high)};
  }
  /// Stores the box; the fourth lanes land behind the two arrays.
  void store(float* lows, float* highs) const {
    std::memcpy(lows, &low, sizeof low);
    std::memcpy(highs, &high, sizeof high);
  }
  void extend(const Box4& other) {
    low = smaller(other.low, low);
    high = larger(other.high, high);
  }
  void extend(Float4 point) {
    low = smaller(point, low);
    high = larger(point, high);
  }
  /// Twice its centre; the fourth lane is 0.
  Float4 center() const { return firstThree(low + high); }
  /// The sides; the fourth lane is 0.
  Float4 sides() const { return firstThree(high - low); }
  /// The axis of its longest side, and that side.
  int longestAxis() const {
    const Float4 d = sides();
    return d[0] >= d[1] && d[0] >= d[2] ? 0 : d[1] >= d[2] ? 1 : 2;
  }
  float longestSide() const { return sides()[longestAxis()]; }
  /// Half its surface, where it is not empty.
  float halfArea() const {
    const Float4 d = sides();
    return d[0] * d[1] + d[2] * (d[0] + d[1]);
  }
};

struct BuildRange {
  BuildItem* first = nullptr;
  std::size_t count = 0;
  int splits = 0;                ///< binary splits above it
  Box4 box = Box4::empty();      ///< around the items
  Box4 centers = Box4::empty();  ///< around twice their centres

  /// Extends the boxes by those of other items.
  void measure(const Box4& item) {
    box.extend(item);
    centers.extend(item.center());
  }
  void measure(const BuildRange& other) {
    box.extend(other.box);
    centers.extend(other.centers);
  }
  void measureItems() {
    for (std::size_t i = 0; i < count; ++i) measure(Box4::of(first[i]));
  }
};

}  // namespace accel
