// The builder: gathers the binary tree into nodes of eight, then has the leaves written.
#include "accel/bvh_builder.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

#include "accel/binary_tree.h"
#include "accel/divide.h"
#include "accel/parallel.h"
#include "accel/traversal.h"

namespace accel {
namespace {

static_assert(kMostSplits < kMostLevels, "a walk's stack is deep enough for any tree");

/// Leaves that are written in one go, by one thread, before the memory of their items is returned.
constexpr std::size_t kLeavesPerRun = 2048;

struct LeafRun {
  std::size_t firstItem, firstLeaf, firstWord;
};

/// Makes the wide nodes. Leaves get their places in the order of their items.
class Gatherer {
 public:
  Gatherer(const BinaryTree& tree, const BuildItem* items, WideBvh& bvh)
      : tree_(tree), items_(items), bvh_(bvh) {
    bvh_.nodes = PageBuffer(tree.leafCount() * sizeof(WideNode));
    bvh_.nodeCount = 1;
    bvh_.leafWords = 1;  // offset 0 means no leaf
    sizes_.reserve(tree.leafCount());
    gather(0, BinaryTree::kRoot);
    bvh_.nodes.shrink(bvh_.nodeCount * sizeof(WideNode));
    runs_.push_back({item_, sizes_.size(), bvh_.leafWords});
  }

  /// How many items each leaf has.
  const std::vector<std::uint8_t>& sizes() const { return sizes_; }
  /// Where each run of leaves begins, and the end of the last one.
  const std::vector<LeafRun>& runs() const { return runs_; }

 private:
  struct Parts {
    std::uint32_t nodes[kWidth];
    int count = 0;
  };

  /// Adds what becomes of `index` in `slots` slots of a wide node.
  void open(std::uint32_t index, int slots, Parts& parts) const {
    const BinaryNode& node = tree_.node(index);
    if (GatherPlan::isLeaf(node.plan) || slots < GatherPlan::openFrom(node.plan)) {
      parts.nodes[parts.count++] = index;
      return;
    }
    const int first = GatherPlan::forFirst(node.plan, slots);
    open(node.children, first, parts);
    open(node.children + 1, slots - first, parts);
  }

  /// Makes wide node `number` of binary node `index`. Recursion is as deep as the wide tree.
  void gather(std::uint32_t number, std::uint32_t index) {
    const BinaryNode& whole = tree_.node(index);
    Parts parts;
    if (GatherPlan::isLeaf(whole.plan)) {
      parts.nodes[parts.count++] = index;
    } else {
      const int first = GatherPlan::forFirst(whole.plan, kWidth);
      open(whole.children, first, parts);
      open(whole.children + 1, kWidth - first, parts);
    }
    WideNode& target = static_cast<WideNode*>(bvh_.nodes.data())[number];
    setBoxes(target, parts);
    for (int i = 0; i < parts.count; ++i) {  // nodes of one parent lie side by side
      if (!isLeaf(parts.nodes[i])) target.child[i] = std::uint32_t(bvh_.nodeCount++);
    }
    for (int i = 0; i < parts.count; ++i) {  // in the order of the items: leaves are placed by it
      if (isLeaf(parts.nodes[i])) {
        target.child[i] = placeLeaf(parts.nodes[i]);
      } else {
        gather(target.child[i], parts.nodes[i]);
      }
    }
  }

  void setBoxes(WideNode& target, const Parts& parts) const {
    constexpr float inf = std::numeric_limits<float>::infinity();
    for (int i = 0; i < kWidth; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        const BinaryNode* part = i < parts.count ? &tree_.node(parts.nodes[i]) : nullptr;
        // Adding 0 turns -0 into 0: which of them is the smaller depends on the order of asking.
        target.planes[2 * axis][i] = part ? part->low[axis] + 0.0f : inf;
        target.planes[2 * axis + 1][i] = part ? part->high[axis] + 0.0f : -inf;
      }
      target.child[i] = 0;
    }
  }

  bool isLeaf(std::uint32_t index) const { return GatherPlan::isLeaf(tree_.node(index).plan); }

  std::uint32_t placeLeaf(std::uint32_t index) {
    const std::size_t size = std::size_t(GatherPlan::leafItems(tree_.node(index).plan));
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

void setBox(WideBvh& bvh, const BinaryNode& root) {
  for (int axis = 0; axis < 3; ++axis) {
    bvh.low[axis] = root.low[axis];
    bvh.high[axis] = root.high[axis];
  }
}

}  // namespace

std::uint32_t leafHead(float edge, LeafKind kind, int count) {
  // Not so small that its square could underflow: infinity times it must not be NaN.
  const float bound = std::max(edge, 0x1p-40f);
  std::uint32_t bits;
  std::memcpy(&bits, &bound, sizeof bits);
  return ((bits + 0xff) & ~0xffu) | std::uint32_t(kind) << 4 | std::uint32_t(count);
}

void buildWideBvh(WideBvh& bvh, BuildItems items, const LeafWriter& writer, Team& team) {
  if (items.count() == 0) return;
  if (items.count() > kMostItems) throw std::length_error("too many primitives for one tree");
  std::vector<std::uint8_t> sizes;
  std::vector<LeafRun> runs;
  {
    const BinaryTree tree(items.data(), items.count(), team);
    setBox(bvh, tree.node(BinaryTree::kRoot));
    const Gatherer gatherer(tree, items.data(), bvh);
    sizes = gatherer.sizes();
    runs = gatherer.runs();
  }
  bvh.leaves = PageBuffer((bvh.leafWords + kWidth) * sizeof(std::uint32_t));
  std::uint32_t* words = static_cast<std::uint32_t*>(bvh.leaves.data());
  team.forEachIndex(runs.size() - 1, [&](std::size_t i) {
    const LeafRun &run = runs[i], &next = runs[i + 1];
    writer.write(items.data() + run.firstItem, sizes.data() + run.firstLeaf,
                 next.firstLeaf - run.firstLeaf, words + run.firstWord);
    items.discard(run.firstItem, next.firstItem);
  });
}

}  // namespace accel
