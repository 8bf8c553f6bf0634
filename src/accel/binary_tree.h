// BinaryTree: what the builder makes first, with the cheapest way to collapse it into wide nodes.
//
// A subtree may hand its parent one child (itself as a node) or up to seven (the nodes it is opened
// into). Costs are surfaces, so proportional to the expected number of visits by a random ray; the
// number of leaves is given, so what a leaf costs against a node does not matter. Source: Ylitie,
// Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs",
// 2017.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "accel/build_range.h"
#include "accel/thread_pool.h"
#include "accel/wide_bvh.h"

namespace accel {

/// How a binary node is collapsed. A leaf: kLeaf. Else for each number of
/// slots from 2 to 8 how many of them its first child gets, three bits each, and from which number
/// of slots on it is better opened than left whole.
class CollapsePlan {
 public:
  static constexpr std::uint32_t kLeaf = 0x80000000u;

  static constexpr bool isLeaf(std::uint32_t plan) { return (plan & kLeaf) != 0; }
  static constexpr int forFirst(std::uint32_t plan, int slots) {
    return int(plan >> (3 * (slots - 2)) & 7);
  }
  static constexpr int openFrom(std::uint32_t plan) { return int(plan >> 21 & 15); }
};

struct CollapseCost {
  int most;             ///< as many children at most: the number of its leaves, up to kWidth - 1
  float least[kWidth];  ///< [i]: with up to i children, 1 <= i <= most; [0] is unused

  /// A leaf of an area.
  static CollapseCost ofLeaf(float area) { return {1, {area, area}}; }
  /// A node over two subtrees, where being a node of its own costs `price`; stores its plan.
  static CollapseCost ofNode(float price, const CollapseCost& first, const CollapseCost& second,
                             std::uint32_t& plan) {
    float open[kWidth + 1];  // more slots than there are leaves are of no use
    int best = 1;
    std::uint32_t found = 0;
    const int useful = std::min(first.most + second.most, kWidth);
    for (int slots = 2; slots <= useful; ++slots) {
      best = std::max(1, slots - second.most);
      open[slots] = first.least[best] + second.least[slots - best];
      for (int k = best + 1; k <= std::min(first.most, slots - 1); ++k) {
        const float cost = first.least[k] + second.least[slots - k];
        best = cost < open[slots] ? k : best;
        open[slots] = std::min(open[slots], cost);
      }
      found |= std::uint32_t(best) << (3 * (slots - 2));
    }
    for (int slots = useful + 1; slots <= kWidth; ++slots) {
      found |= std::uint32_t(first.most) << (3 * (slots - 2));
    }
    CollapseCost cost;
    cost.most = std::min(useful, kWidth - 1);
    cost.least[1] = open[useful] + price;
    std::uint32_t openFrom = kWidth;
    for (int slots = cost.most; slots >= 2; --slots) {
      cost.least[slots] = std::min(cost.least[1], open[slots]);
      if (open[slots] < cost.least[1]) openFrom = std::uint32_t(slots);
    }
    plan = found | openFrom << 21;
    return cost;
  }
};

struct BinaryNode {
  float low[3];
  std::uint32_t children;  ///< the first of two neighbours; in a leaf how many items it has
  float high[3];
  std::uint32_t plan;  ///< how to collapse it: see CollapsePlan
};
static_assert(sizeof(BinaryNode) == 32, "a box and two numbers");

class BinaryTree {
 public:
  /// Builds the tree over `count` >= 1 items, which are reordered: in the tree's order of leaves
  /// they are then one behind the other.
  BinaryTree(BuildItem* items, std::size_t count, ThreadPool& pool);

  static constexpr std::uint32_t kRoot = 0;
  const BinaryNode& node(std::uint32_t index) const { return nodes()[index]; }
  bool isLeaf(std::uint32_t index) const { return CollapsePlan::isLeaf(node(index).plan); }
  float longestSide(std::uint32_t index) const {
    const BinaryNode& n = node(index);
    return std::max({n.high[0] - n.low[0], n.high[1] - n.low[1], n.high[2] - n.low[2]});
  }
  /// Whether it is above all that one thread has built alone.
  bool isTop(std::uint32_t index) const { return index < topEnd_; }
  /// The most words that all leaves together can take.
  std::size_t mostLeafWords() const;

 private:
  struct Task {
    BuildRange range;
    std::uint32_t node;
    CollapseCost cost;
    std::size_t mostLeafWords;
  };
  class Subtree;

  BinaryNode* nodes() { return static_cast<BinaryNode*>(memory_.data()); }
  const BinaryNode* nodes() const { return static_cast<const BinaryNode*>(memory_.data()); }
  BuildRange wholeRange(BuildItem* items, std::size_t count);
  void splitTop(const BuildRange& range, std::uint32_t node, std::size_t mostInTask,
                ThreadPool& pool, std::vector<Task>& tasks);
  void runTasks();
  CollapseCost finishTop(std::uint32_t node, std::size_t& task);

  PageBuffer memory_;                ///< BinaryNodes
  std::atomic<std::uint32_t> used_;  ///< blocks of them are taken from here on
  std::uint32_t topEnd_ = 0;
  ThreadPool& pool_;
  std::size_t mostInTask_;
  bool uniform_ = true;
  float memoryPrice_ = 0;
  std::vector<Task> tasks_;
};

}  // namespace accel
