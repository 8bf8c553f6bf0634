// The builder: from a binary tree to nodes of eight, then to leaves.
//
//   1. BinaryTree splits the items until they fit into leaves, and finds for each node the cheapest
//      way to collapse what is below it into wide nodes.
//   2. WideNodeBuilder follows these plans from the root down. The children of one wide node lie
//      side by side; leaves get their places in the order of the items, so that whoever knows the
//      sizes of the leaves knows where each is.
//   3. The leaves are written in runs, by all threads; the memory of a run's items is given back
//      when it is written, so that items and leaves are never in memory all at once.
#include "accel/bvh_builder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

#include "accel/binary_tree.h"
#include "accel/split_range.h"
#include "accel/thread_pool.h"

namespace accel {
namespace {

/// Leaves that are written in one go, by one thread, before the memory of their items is returned.
constexpr std::size_t kLeavesPerRun = 2048;

/// A node so much smaller than the frame that it is in begins another.
constexpr float kFrameStep = 0x1p-12f;

struct LeafRun {
  std::size_t firstItem, firstLeaf, firstWord;
};

/// Makes the wide nodes. Leaves get their places in the order of their items.
class WideNodeBuilder {
 public:
  WideNodeBuilder(const BinaryTree& tree, const BuildItem* items, WideBvh& bvh)
      : tree_(tree), items_(items), bvh_(bvh) {
    bvh_.nodes = PageBuffer(tree.leafCount() * sizeof(WideNode));
    bvh_.nodeCount = 1;
    bvh_.leafWords = 1;  // offset 0 means no leaf
    sizes_.reserve(tree.leafCount());
    collapse(0, BinaryTree::kRoot, {1, 0, longestSide(BinaryTree::kRoot)});
    bvh_.nodes.shrink(bvh_.nodeCount * sizeof(WideNode));
    runs_.push_back({item_, sizes_.size(), bvh_.leafWords});
  }

  /// How many items each leaf has.
  const std::vector<std::uint8_t>& sizes() const { return sizes_; }
  /// Where each run of leaves begins, and the end of the last one.
  const std::vector<LeafRun>& runs() const { return runs_; }

 private:
  struct Children {
    std::uint32_t nodes[kWidth];
    int count = 0;
  };

  /// Where a wide node is: its level from the root's 1 on, how many frames it is in, and the
  /// longest side of the innermost, or of the whole tree.
  struct Place {
    int level, frames;
    float frameSize;
  };

  /// Adds what becomes of `index` in `slots` slots of a wide node; eight slots open any node that
  /// is no leaf.
  void open(std::uint32_t index, int slots, Children& children) const {
    const BinaryNode& node = tree_.node(index);
    if (CollapsePlan::isLeaf(node.plan) || slots < CollapsePlan::openFrom(node.plan)) {
      children.nodes[children.count++] = index;
      return;
    }
    const int first = CollapsePlan::forFirst(node.plan, slots);
    open(node.children, first, children);
    open(node.children + 1, slots - first, children);
  }

  /// Makes wide node `number` of binary node `index`. Recursion is as deep as the wide tree.
  void collapse(std::uint32_t number, std::uint32_t index, const Place& place) {
    bvh_.levels = std::max(bvh_.levels, place.level);
    bvh_.frameLevels = std::max(bvh_.frameLevels, place.frames);
    Children children;
    open(index, kWidth, children);
    WideNode& target = static_cast<WideNode*>(bvh_.nodes.data())[number];
    setBoxes(target, children);
    for (int i = 0; i < children.count; ++i) {  // nodes of one parent lie side by side
      if (!isLeaf(children.nodes[i])) target.child[i] = std::uint32_t(bvh_.nodeCount++);
    }
    for (int i = 0; i < children.count;
         ++i) {  // in the order of the items: leaves are placed by it
      if (isLeaf(children.nodes[i])) {
        target.child[i] = placeLeaf(children.nodes[i]);
      } else {
        Place inside = {place.level + 1, place.frames, place.frameSize};
        const std::uint32_t node = target.child[i];
        if (beginsFrame(children.nodes[i], place.frameSize)) {
          target.child[i] |= kFrameBit;
          inside = {place.level + 2, place.frames + 1, longestSide(children.nodes[i])};
        }
        collapse(node, children.nodes[i], inside);
      }
    }
  }

  void setBoxes(WideNode& target, const Children& children) const {
    constexpr float inf = std::numeric_limits<float>::infinity();
    for (int i = 0; i < kWidth; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        const BinaryNode* child = i < children.count ? &tree_.node(children.nodes[i]) : nullptr;
        // Adding 0 turns -0 into 0: which of them is the smaller depends on the order of asking.
        target.planes[2 * axis][i] = child ? child->low[axis] + 0.0f : inf;
        target.planes[2 * axis + 1][i] = child ? child->high[axis] + 0.0f : -inf;
      }
      target.child[i] = 0;
    }
  }

  float longestSide(std::uint32_t index) const {
    const BinaryNode& node = tree_.node(index);
    return std::max(
        {node.high[0] - node.low[0], node.high[1] - node.low[1], node.high[2] - node.low[2]});
  }
  /// Only leaves of a mesh hold exact numbers, which can be seen from nearby.
  bool beginsFrame(std::uint32_t index, float around) const {
    const float size = longestSide(index);
    return items_[0].kind == LeafKind::meshTriangles && size < around * kFrameStep &&
           size > TreeFrame::kLeast;
  }

  bool isLeaf(std::uint32_t index) const { return CollapsePlan::isLeaf(tree_.node(index).plan); }

  std::uint32_t placeLeaf(std::uint32_t index) {
    const std::size_t size = std::size_t(CollapsePlan::leafItems(tree_.node(index).plan));
    if (sizes_.size() % kLeavesPerRun == 0) runs_.push_back({item_, sizes_.size(), bvh_.leafWords});
    const std::uint32_t offset = std::uint32_t(bvh_.leafWords);
    const LeafKind kind = items_[tree_.isUniform() ? 0 : item_].kind;
    bvh_.leafWords += wordsOf(kind, int(size));
    item_ += size;
    sizes_.push_back(std::uint8_t(size));
    return offset | kLeafBit;
  }

  const BinaryTree& tree_;
  const BuildItem* items_;
  WideBvh& bvh_;
  std::vector<std::uint8_t> sizes_;
  std::vector<LeafRun> runs_;
  std::size_t item_ = 0;
};

}  // namespace

TreeFrame TreeFrame::of(const WideNode& node) {
  TreeFrame frame;
  double longest = kLeast;
  for (int axis = 0; axis < 3; ++axis) {
    const float *low = node.planes[2 * axis], *high = node.planes[2 * axis + 1];
    frame.low[axis] = *std::min_element(low, low + kWidth);
    frame.high[axis] = *std::max_element(high, high + kWidth);
    longest = std::max(longest, frame.high[axis] - frame.low[axis]);
  }
  frame.size = std::min(std::ldexp(1.0, std::ilogb(longest)), 1.0);
  return frame;
}

std::uint32_t leafHead(float edge, LeafKind kind, int count) {
  // Not so small that its square could underflow: infinity times it must not be NaN.
  const float bound = std::max(edge, 0x1p-40f);
  std::uint32_t bits;
  std::memcpy(&bits, &bound, sizeof bits);
  return ((bits + 0xff) & ~0xffu) | std::uint32_t(kind) << 4 | std::uint32_t(count);
}

void buildWideBvh(WideBvh& bvh, BuildItems items, const LeafWriter& writer, ThreadPool& pool) {
  if (items.count() == 0) return;
  if (items.count() > kMostItems) throw std::length_error("too many primitives for one tree");
  std::vector<std::uint8_t> sizes;
  std::vector<LeafRun> runs;
  {
    const BinaryTree tree(items.data(), items.count(), pool);
    const WideNodeBuilder builder(tree, items.data(), bvh);
    bvh.whole = TreeFrame::of(*bvh.root());
    sizes = builder.sizes();
    runs = builder.runs();
  }
  bvh.leaves = PageBuffer((bvh.leafWords + kWidth) * sizeof(std::uint32_t));
  std::uint32_t* words = static_cast<std::uint32_t*>(bvh.leaves.data());
  pool.forEachIndex(runs.size() - 1, [&](std::size_t i) {
    const LeafRun &run = runs[i], &next = runs[i + 1];
    writer.write(items.data() + run.firstItem, sizes.data() + run.firstLeaf,
                 next.firstLeaf - run.firstLeaf, words + run.firstWord);
    items.discard(run.firstItem, next.firstItem);
  });
}

}  // namespace accel
