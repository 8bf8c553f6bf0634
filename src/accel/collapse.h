// From a binary tree to wide nodes and leaves, by jobs that threads can do side by side.
#pragma once
#include <atomic>
#include <cstdint>
#include <vector>

#include "accel/binary_tree.h"
#include "accel/bvh_builder.h"

namespace accel {

/// Where a wide node is: its level from the root's 1 on, how many frames it is in, and the longest
/// side of the innermost, or of the whole tree.
struct Place {
  int level = 1, frames = 0;
  float frameSize = 0;
};

/// A binary node that becomes a wide one and all below it, but for what is left to other jobs. Has
/// a cache line of its own: threads write to neighbouring jobs (counting by two took 1.4 times as
/// long).
struct alignas(64) Job {
  std::uint32_t binary;
  std::uint32_t number = 0;                ///< of the wide node
  Place place = {};                        ///< of the wide node
  std::size_t nodes = 0, items = 0;        ///< below it, once they are counted
  std::size_t nextNode = 1, nextItem = 0;  ///< the first that is below it
  int levels = 0, frameLevels = 0;         ///< the most that the job has met

  explicit Job(std::uint32_t index) : binary(index) {}
};

/// Counts wide nodes and items of a job. With `others` subtrees below the top of the tree are left
/// to jobs that are added there, in the order of the items.
void countNodes(const BinaryTree& tree, Job& job, std::vector<Job>* others);

/// What all jobs share.
struct Collapse {
  const BinaryTree& tree;
  BuildItems& items;
  const LeafWriter& writer;
  const bool
      hasFrames;  ///< only leaves of a mesh hold exact numbers, which can be seen from nearby
  WideNode* const nodes;
  std::uint32_t* const words;             ///< of leaves
  std::atomic<std::size_t> wordCount{1};  ///< offset 0 means no leaf
  /// Of each large page of items, how many are in leaves.
  std::vector<std::atomic<std::size_t>> doneItems =
      std::vector<std::atomic<std::size_t>>(items.count() / BuildItems::kPerLargePage + 1);

  /// Makes the wide nodes and leaves of a job. `others` are those that countNodes has made: they
  /// are told where they begin. Jobs of which none is another's may run side by side.
  void run(Job& job, Job* others);
};

}  // namespace accel
