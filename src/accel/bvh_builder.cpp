// The builder: from a binary tree to nodes of eight, then to leaves.
//
//   1. BinaryTree splits the items until they fit into leaves, and finds for each node the cheapest
//      way to collapse what is below it into wide nodes.
//   2. The leaves are written in the order of the items, in batches, by all threads. How many words
//      a batch takes is known when it is written; then it gets its place behind those that came
//      before. The memory of items is given back as soon as they are in leaves, so that items,
//      leaves and nodes are never in memory all at once.
//   3. WideNodeBuilder follows the plans from the root down. The children of one wide node lie side
//      by side; leaves come in the order of the items, so where they are follows from their sizes.
#include "accel/bvh_builder.h"

#include <algorithm>
#include <atomic>
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

/// Leaves that are written in one go, to a place of their own.
constexpr std::size_t kLeavesPerBatch = 64;
/// Batches that one thread writes before the memory of their items is given back, for 1 M triangles
/// about 1 MB at a time: given back by less, large pages fall apart, and reading what is left of
/// them takes twice as long.
constexpr std::size_t kBatchesPerRun = 128;

/// A node so much smaller than the frame that it is in begins another.
constexpr float kFrameStep = 0x1p-12f;

/// Writes all leaves of a tree.
class Leaves {
 public:
  Leaves(std::vector<LeafSize> sizes, BuildItems& items, const LeafWriter& writer)
      : sizes_(std::move(sizes)), items_(items), writer_(writer) {
    std::size_t item = 0;
    for (std::size_t leaf = 0; leaf < sizes_.size(); ++leaf) {
      if (leaf % kLeavesPerBatch == 0) batches_.push_back({item, 0});
      item += sizes_[leaf].items;
      mostWords_ += std::size_t(kFirstRow + kMostTriangleWords * sizes_[leaf].primitives);
    }
    if (mostWords_ >= kLeafBit) throw std::length_error("too many primitives for one tree");
  }

  void write(WideBvh& bvh, ThreadPool& pool) {
    bvh.leaves = PageBuffer((mostWords_ + kWidth) * sizeof(std::uint32_t));
    std::uint32_t* words = static_cast<std::uint32_t*>(bvh.leaves.data());
    pool.forEachIndex((batches_.size() + kBatchesPerRun - 1) / kBatchesPerRun, [&](std::size_t i) {
      const std::size_t first = i * kBatchesPerRun,
                        end = std::min(first + kBatchesPerRun, batches_.size());
      for (std::size_t batch = first; batch < end; ++batch) writeBatch(batch, words);
      items_.discard(batches_[first].item,
                     end < batches_.size() ? batches_[end].item : items_.count());
    });
    bvh.leafWords = next_;
    bvh.leaves.shrink((next_ + kWidth) * sizeof(std::uint32_t));
  }

  std::size_t count() const { return sizes_.size(); }
  /// Where leaf `leaf` is; `before` is where the leaf before it is.
  std::uint32_t offsetOf(std::size_t leaf, std::uint32_t before) const {
    return leaf % kLeavesPerBatch == 0 ? batches_[leaf / kLeavesPerBatch].word
                                       : before + sizes_[leaf - 1].words;
  }

 private:
  struct Batch {
    std::size_t item;    // its first
    std::uint32_t word;  // where it is written
  };

  void writeBatch(std::size_t number, std::uint32_t* words) {
    std::uint32_t written[kLeavesPerBatch * kMostLeafWords];
    std::size_t size = 0, item = batches_[number].item;
    const std::size_t first = number * kLeavesPerBatch,
                      end = std::min(first + kLeavesPerBatch, sizes_.size());
    for (std::size_t leaf = first; leaf < end; ++leaf) {
      const int count = sizes_[leaf].items;
      const BuildItem* items = items_.data() + item;
      writer_.prepare(items, count, items_.count() - item);
      sizes_[leaf].words = std::uint8_t(writer_.write(items, count, written + size));
      size += sizes_[leaf].words;
      item += std::size_t(count);
    }
    const std::size_t place = next_.fetch_add(size);
    batches_[number].word = std::uint32_t(place);
    std::copy(written, written + size, words + place);
  }

  std::vector<LeafSize> sizes_;
  std::vector<Batch> batches_;
  std::size_t mostWords_ = 1;
  std::atomic<std::size_t> next_{1};  // offset 0 means no leaf
  BuildItems& items_;
  const LeafWriter& writer_;
};

/// Makes the wide nodes.
class WideNodeBuilder {
 public:
  /// `hasFrames`: only leaves of a mesh hold exact numbers, which can be seen from nearby.
  WideNodeBuilder(const BinaryTree& tree, const Leaves& leaves, bool hasFrames, WideBvh& bvh)
      : tree_(tree), leaves_(leaves), hasFrames_(hasFrames), bvh_(bvh) {
    bvh_.nodes = PageBuffer(leaves.count() * sizeof(WideNode));
    bvh_.nodeCount = 1;
    collapse(0, BinaryTree::kRoot, {1, 0, longestSide(BinaryTree::kRoot)});
    bvh_.nodes.shrink(bvh_.nodeCount * sizeof(WideNode));
  }

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
    // In the order of the items: leaves are placed by it.
    for (int i = 0; i < children.count; ++i) {
      if (isLeaf(children.nodes[i])) {
        place_ = leaves_.offsetOf(leaf_++, place_);
        target.child[i] = place_ | kLeafBit;
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
  bool beginsFrame(std::uint32_t index, float around) const {
    const float size = longestSide(index);
    return hasFrames_ && size < around * kFrameStep && size > TreeFrame::kLeast;
  }

  bool isLeaf(std::uint32_t index) const { return CollapsePlan::isLeaf(tree_.node(index).plan); }

  const BinaryTree& tree_;
  const Leaves& leaves_;
  const bool hasFrames_;
  WideBvh& bvh_;
  std::size_t leaf_ = 0;     // how many have been met
  std::uint32_t place_ = 0;  // of the last of them
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

std::uint32_t leafHead(float edge, LeafKind kind, int count, int vertices) {
  // Not so small that its square could underflow: infinity times it must not be NaN.
  const float bound = std::max(edge, 0x1p-40f);
  std::uint32_t bits;
  std::memcpy(&bits, &bound, sizeof bits);
  return ((bits + 0xffff) & ~0xffffu) | std::uint32_t(vertices) << 8 | std::uint32_t(kind) << 4 |
         std::uint32_t(count);
}

void buildWideBvh(WideBvh& bvh, BuildItems items, const LeafWriter& writer, ThreadPool& pool) {
  if (items.count() == 0) return;
  const bool isMesh = items.data()[0].kind == LeafKind::meshTriangles;
  const BinaryTree tree(items.data(), items.count(), pool);
  Leaves leaves(tree.leafSizes(), items, writer);
  leaves.write(bvh, pool);
  const WideNodeBuilder builder(tree, leaves, isMesh, bvh);
  bvh.whole = TreeFrame::of(*bvh.root());
}

}  // namespace accel
