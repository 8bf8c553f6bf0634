// The builder: from items to a binary tree, and from that to nodes of eight and their leaves.
//
//   1. BinaryTree splits the items until they fit into leaves, and finds for each node the cheapest
//      way to collapse what is below it into wide nodes.
//   2. It is counted how many wide nodes that makes, so that each thread knows where those that it
//      makes begin.
//   3. Wide nodes and leaves are made, in the order of the items. The memory of items is given back
//      as soon as they are in leaves, so that items, leaves and nodes are never in memory all at
//      once.
#include "accel/bvh_builder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "accel/binary_tree.h"
#include "accel/collapse.h"
#include "accel/thread_pool.h"

namespace accel {

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
  const std::size_t mostWords = 1 + tree.mostLeafWords();
  if (mostWords >= kLeafBit) throw std::length_error("too many primitives for one tree");

  Job top(BinaryTree::kRoot);
  top.place.frameSize = tree.longestSide(top.binary);
  std::vector<Job> others;
  countNodes(tree, top, &others);
  pool.forEachIndex(others.size(), [&](std::size_t i) { countNodes(tree, others[i], nullptr); });
  bvh.nodeCount = 1 + top.nodes;
  for (const Job& job : others) bvh.nodeCount += job.nodes;

  const auto bytesWith = [&](std::size_t words) {
    return bvh.nodeCount * sizeof(WideNode) + (words + kWidth) * sizeof(std::uint32_t);
  };
  bvh.memory = PageBuffer(bytesWith(mostWords));
  auto* const nodes = static_cast<WideNode*>(bvh.memory.data());
  auto* const words = reinterpret_cast<std::uint32_t*>(nodes + bvh.nodeCount);
  Collapse collapse{tree, items, writer, isMesh, nodes, words};
  collapse.run(top, others.data());
  pool.forEachIndex(others.size(), [&](std::size_t i) { collapse.run(others[i], nullptr); });
  bvh.leafWords = collapse.wordCount;
  bvh.memory.shrink(bytesWith(bvh.leafWords));

  others.push_back(top);
  for (const Job& job : others) {
    bvh.levels = std::max(bvh.levels, job.levels);
    bvh.frameLevels = std::max(bvh.frameLevels, job.frameLevels);
  }
  bvh.whole = TreeFrame::of(*bvh.root());
}

}  // namespace accel
