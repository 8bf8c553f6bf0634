// BinaryTree: what the builder makes first, with the cheapest way to gather it into wide nodes.
#pragma once
#include <vector>

#include "accel/build_range.h"
#include "accel/gather_cost.h"
#include "accel/parallel.h"

namespace accel {

struct BinaryNode {
  float low[3];
  std::uint32_t children;  ///< the first of two neighbours; unused in a leaf
  float high[3];
  std::uint32_t plan;  ///< how to gather it: see GatherPlan
};
static_assert(sizeof(BinaryNode) == 32, "a box and two numbers");

class BinaryTree {
 public:
  /// Builds the tree over `count` >= 1 items, which are reordered: in the tree's order of leaves
  /// they are then one behind the other.
  BinaryTree(BuildItem* items, std::size_t count, Team& team);

  static constexpr std::uint32_t kRoot = 0;
  const BinaryNode& node(std::uint32_t index) const { return nodes()[index]; }
  std::size_t leafCount() const { return leafCount_; }
  /// True where all items are of one kind.
  bool isUniform() const { return uniform_; }

 private:
  struct Task {
    BuildRange range;
    std::uint32_t node;
    GatherCost cost;
    std::size_t leaves;
  };
  class Subtree;

  BinaryNode* nodes() { return static_cast<BinaryNode*>(memory_.data()); }
  const BinaryNode* nodes() const { return static_cast<const BinaryNode*>(memory_.data()); }
  BuildRange wholeRange(BuildItem* items, std::size_t count);
  void splitTop(const BuildRange& range, std::uint32_t node);
  void runTasks();
  GatherCost finishTop(std::uint32_t node, std::size_t& task);

  PageBuffer memory_;  ///< BinaryNodes; each range of items has a stretch of its own
  const BuildItem* items_;
  Team& team_;
  std::size_t mostInTask_;
  std::uint32_t nextTop_;
  bool uniform_ = true;
  float memoryPrice_ = 0;
  std::size_t leafCount_ = 0;
  std::vector<Task> tasks_;
};

}  // namespace accel
