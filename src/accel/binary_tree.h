// BinaryTree: what the builder makes first, with the cheapest way to collapse it into wide nodes.
#pragma once
#include <atomic>
#include <cstdint>

#include "accel/build_range.h"
#include "accel/thread_pool.h"

namespace accel {

/// A box, and two halves or a leaf. How a node is best collapsed into a wide one is told by `plan`:
/// for each number of slots from 2 to 8 how many of them its first half gets, three bits each; and
/// from which number of slots on it is better opened than left whole.
struct BinaryNode {
  static constexpr std::uint32_t kLeaf = 0x80000000u;

  float low[3];
  std::uint32_t first;  ///< of two nodes side by side; in a leaf, its first item
  float high[3];
  std::uint32_t plan;  ///< in a leaf: kLeaf and how many items it has

  bool isLeaf() const { return (plan & kLeaf) != 0; }
  int items() const { return int(plan & ~kLeaf); }
  int slotsOfFirst(int slots) const { return int(plan >> (3 * (slots - 2)) & 7); }
  int openFrom() const { return int(plan >> 21); }
};
static_assert(sizeof(BinaryNode) == 32, "a box and two numbers");

// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): a counter has its own cache line
class BinaryTree {
 public:
  /// Builds the tree over `count` >= 1 items, which are reordered: those of a leaf are then one
  /// behind the other, and leaves are in the tree's order. Of very many items at one place, those
  /// are left out that `writer` says. But for the numbers of nodes, the tree is a function of the
  /// items alone.
  BinaryTree(BuildItem* items, std::size_t count, const LeafWriter& writer, ThreadPool& pool);

  const BinaryNode& root() const { return *static_cast<const BinaryNode*>(memory_.data()); }
  /// The two halves of a node that is no leaf.
  const BinaryNode* halvesOf(const BinaryNode& node) const { return &root() + node.first; }
  /// How many wide nodes it becomes.
  std::size_t wideNodes() const { return wideNodes_; }
  /// The most words that all leaves together can take.
  std::size_t mostLeafWords() const { return mostLeafWords_; }

 private:
  struct Subtree;
  struct Block;
  Subtree build(const BuildRange& range, BinaryNode& node, Block& block);

  /// Nodes in use; blocks are taken from here on. In a cache line of its own.
  alignas(64) std::atomic<std::uint32_t> used_;
  alignas(64) PageBuffer memory_;  ///< BinaryNodes
  const std::size_t leastForked_;
  const BuildItem* const items_;
  const LeafWriter& writer_;
  ThreadPool& pool_;
  float memoryPrice_ = 0;
  std::size_t wideNodes_ = 0, mostLeafWords_ = 0;
};

}  // namespace accel
