// The builder: binary splits by the binned surface area heuristic, eight children to a node.
#include "accel/bvh_builder.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>

namespace accel {
namespace {

constexpr int kBins = 16;
/// Beyond this many binary splits above it a range is halved by number: bounded depth for any
/// input.
constexpr int kMostSahSplits = 40;

struct Box {
  float low[3], high[3];

  static Box empty() {
    constexpr float inf = std::numeric_limits<float>::infinity();
    return {{inf, inf, inf}, {-inf, -inf, -inf}};
  }
  void extend(const float* otherLow, const float* otherHigh) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], otherLow[axis]);
      high[axis] = std::max(high[axis], otherHigh[axis]);
    }
  }
  void extend(const Box& other) { extend(other.low, other.high); }
  float halfArea() const {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x * y + y * z + z * x;
  }
};

/// A run of items, the boxes around them and around their centres (twice the centres, in fact).
struct Range {
  BuildItem* first;
  std::size_t count;
  Box box, centers;
  int splits;

  bool isLeaf() const {
    if (count > std::size_t(mostInLeaf(first->kind))) return false;
    return std::all_of(first, first + count,
                       [&](const BuildItem& item) { return item.kind == first->kind; });
  }
};

float centerOf(const BuildItem& item, int axis) { return item.low[axis] + item.high[axis]; }

Range rangeOf(BuildItem* first, std::size_t count, int splits) {
  Range range{first, count, Box::empty(), Box::empty(), splits};
  for (const BuildItem* item = first; item != first + count; ++item) {
    range.box.extend(item->low, item->high);
    const float center[3] = {centerOf(*item, 0), centerOf(*item, 1), centerOf(*item, 2)};
    range.centers.extend(center, center);
  }
  return range;
}

struct Split {
  int axis = -1;  // -1: none found
  int bin = 0;    // items in bins up to this one go left
  float cost = std::numeric_limits<float>::infinity();
};

/// Which bin a centre belongs to along one axis.
struct Binning {
  float low, scale;

  Binning(const Range& range, int axis)
      : low(range.centers.low[axis]),
        scale(float(kBins) * 0.99f / (range.centers.high[axis] - range.centers.low[axis])) {}
  bool isUsable() const { return scale > 0 && scale < std::numeric_limits<float>::max(); }
  int operator()(float center) const {
    return std::clamp(int((center - low) * scale), 0, kBins - 1);
  }
};

Split bestSplitOnAxis(const Range& range, int axis) {
  const Binning binOf(range, axis);
  Split best;
  if (!binOf.isUsable()) return best;
  Box boxes[kBins];
  std::size_t counts[kBins] = {};
  std::fill(boxes, boxes + kBins, Box::empty());
  for (const BuildItem* item = range.first; item != range.first + range.count; ++item) {
    const int bin = binOf(centerOf(*item, axis));
    boxes[bin].extend(item->low, item->high);
    ++counts[bin];
  }
  float rightCost[kBins];
  Box right = Box::empty();
  std::size_t rightCount = 0;
  for (int bin = kBins - 1; bin > 0; --bin) {
    right.extend(boxes[bin]);
    rightCount += counts[bin];
    rightCost[bin] = rightCount == 0 ? -1 : right.halfArea() * float(rightCount);
  }
  Box left = Box::empty();
  std::size_t leftCount = 0;
  for (int bin = 0; bin + 1 < kBins; ++bin) {
    left.extend(boxes[bin]);
    leftCount += counts[bin];
    if (leftCount == 0 || rightCost[bin + 1] < 0) continue;
    const float cost = left.halfArea() * float(leftCount) + rightCost[bin + 1];
    if (cost < best.cost) best = {axis, bin, cost};
  }
  return best;
}

/// Divides a range of at least two items in two.
void divide(const Range& range, Range& left, Range& right) {
  Split best;
  if (range.splits < kMostSahSplits) {
    for (int axis = 0; axis < 3; ++axis) {
      const Split split = bestSplitOnAxis(range, axis);
      if (split.cost < best.cost) best = split;
    }
  }
  BuildItem* middle = range.first + range.count / 2;
  if (best.axis >= 0) {
    const Binning binOf(range, best.axis);
    middle = std::partition(range.first, range.first + range.count, [&](const BuildItem& item) {
      return binOf(centerOf(item, best.axis)) <= best.bin;
    });
  } else if (range.count <= 4096) {
    // No centre differs, or none by much: sort by kind, so that leaves become uniform.
    std::sort(range.first, range.first + range.count, [](const BuildItem& a, const BuildItem& b) {
      return a.kind != b.kind ? a.kind < b.kind : a.id < b.id;
    });
  }
  const std::size_t leftCount = std::size_t(middle - range.first);
  left = rangeOf(range.first, leftCount, range.splits + 1);
  right = rangeOf(middle, range.count - leftCount, range.splits + 1);
}

class Builder {
 public:
  Builder(WideBvh& bvh, const LeafWriter& writer, std::size_t count) : bvh_(bvh), writer_(writer) {
    bvh_.nodes = PageBuffer((count + 1) * sizeof(WideNode));
    bvh_.leaves = PageBuffer((count * 11 + 64) * sizeof(std::uint32_t));
  }

  void build(const Range& root) {
    bvh_.nodeCount = 1;
    bvh_.leafWords = 1;  // offset 0 means no leaf
    buildNode(0, root);
    bvh_.nodes.shrink(bvh_.nodeCount * sizeof(WideNode));
    bvh_.leaves.shrink((bvh_.leafWords + kWidth) * sizeof(std::uint32_t));
    for (int axis = 0; axis < 3; ++axis) {
      bvh_.low[axis] = root.box.low[axis];
      bvh_.high[axis] = root.box.high[axis];
    }
  }

 private:
  WideNode& node(std::uint32_t index) { return static_cast<WideNode*>(bvh_.nodes.data())[index]; }

  void buildNode(std::uint32_t index, const Range& range) {
    Range children[kWidth] = {range};
    int count = 1;
    while (count < kWidth) {
      int widest = -1;
      for (int i = 0; i < count; ++i) {
        if (children[i].count < 2 || (children[i].count <= 2 && children[i].isLeaf())) continue;
        if (widest < 0 || children[i].box.halfArea() > children[widest].box.halfArea()) widest = i;
      }
      if (widest < 0) break;
      const Range whole = children[widest];
      divide(whole, children[widest], children[count++]);
    }
    fillNode(index, children, count);
  }

  void fillNode(std::uint32_t index, const Range* children, int count) {
    std::uint32_t numbers[kWidth] = {};
    for (int i = 0; i < count; ++i) {
      numbers[i] = children[i].isLeaf() ? writeLeaf(children[i]) : std::uint32_t(bvh_.nodeCount++);
    }
    WideNode& target = node(index);
    for (int i = 0; i < kWidth; ++i) {
      const Box box = i < count ? children[i].box : Box::empty();
      for (int axis = 0; axis < 3; ++axis) {
        target.planes[2 * axis][i] = box.low[axis];
        target.planes[2 * axis + 1][i] = box.high[axis];
      }
      target.child[i] = numbers[i];
    }
    for (int i = 0; i < count; ++i) {
      if ((numbers[i] & kLeafBit) == 0) buildNode(numbers[i], children[i]);
    }
  }

  std::uint32_t writeLeaf(const Range& range) {
    const std::uint32_t offset = std::uint32_t(bvh_.leafWords);
    writer_.write(range.first, int(range.count),
                  static_cast<std::uint32_t*>(bvh_.leaves.data()) + offset);
    bvh_.leafWords += wordsOf(range.first->kind, int(range.count));
    return offset | kLeafBit;
  }

  WideBvh& bvh_;
  const LeafWriter& writer_;
};

}  // namespace

std::uint32_t leafHead(float edge, LeafKind kind, int count) {
  // Not so small that its square could underflow: infinity times it must not be NaN.
  const float bound = std::max(edge, 0x1p-40f);
  std::uint32_t bits;
  std::memcpy(&bits, &bound, sizeof bits);
  return ((bits + 0xff) & ~0xffu) | std::uint32_t(kind) << 4 | std::uint32_t(count);
}

void buildWideBvh(WideBvh& bvh, BuildItem* items, std::size_t count, const LeafWriter& writer,
                  int threads) {
  (void)threads;
  if (count == 0) return;
  Builder(bvh, writer, count).build(rangeOf(items, count, 0));
}

}  // namespace accel
