// BinaryTree: ranges of items are split until they fit into leaves; both halves of a large one may
// be split side by side.
//
// On the way back up every node learns what its subtree costs as 1 to 7 children of a wide node,
// from the costs of its two halves: a subtree may hand its parent one child (itself as a node) or
// up to seven (the nodes it is opened into). Costs are surfaces, so proportional to the expected
// number of visits by a random ray; the number of leaves is given, so what a leaf costs against a
// node does not matter. Threads take nodes in blocks, so that they need no lock, and memory is
// filled from the front.
// Source: Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed
// Wide BVHs", 2017.
#include "accel/binary_tree.h"

#include <cassert>

#include "accel/split_range.h"
#include "accel/wide_bvh.h"

namespace accel {
namespace {

/// Halves of more items each may be built side by side. There are at most 128 such forks, so that
/// tasks which wait for one another on a thread do not fill its stack.
std::size_t leastForked(std::size_t count) { return std::max<std::size_t>(4096, count / 128); }

/// Nodes that a thread takes at a time.
constexpr std::uint32_t kBlock = 64;

/// Every item has room for two nodes, and the last block of each thread may be unfinished.
std::size_t nodesFor(std::size_t count) {
  return 2 * count + kBlock * (count / leastForked(count) + 2);
}

/// What a node costs beyond its surface, for its memory: so small that the expected visits stay
/// the same within 0.1 %, it saves 4 % of the nodes. Where surfaces vanish, the fewest nodes win.
float memoryPrice(const Box4& whole, std::size_t count) {
  return 20 * whole.halfArea() / float(count) + 0x1p-100f;
}

/// The range of all items, measured by all threads.
BuildRange rangeOf(BuildItem* items, std::size_t count, ThreadPool& pool) {
  constexpr std::size_t kMostAtOnce = 32768;
  BuildRange range{items, count};
  if (count <= kMostAtOnce) {
    range.measureItems();
    return range;
  }
  BuildRange second;
  pool.both([&] { range = rangeOf(items, count / 2, pool); },
            [&] { second = rangeOf(items + count / 2, count - count / 2, pool); });
  range.measure(second);
  range.count = count;
  return range;
}

}  // namespace

/// What is known of a subtree when it has been built. With up to i children, 1 <= i <= most,
/// least[i] is what it costs and wide[i] how many wide nodes it becomes.
struct BinaryTree::Subtree {
  int most;  ///< as many children at most: the number of its leaves, up to kWidth - 1
  float least[kWidth];
  std::uint32_t wide[kWidth];
  std::size_t mostWords;  ///< that its leaves can take

  /// A leaf of an area.
  static Subtree ofLeaf(float area, LeafKind kind, int primitives) {
    const int most = kind == LeafKind::objects ? kMostObjectWords : kMostTriangleWords;
    return {1, {area, area}, {}, std::size_t(kFirstRow + most * primitives)};
  }
  /// A node over two subtrees, where being a node of its own costs `price`; stores its plan.
  static Subtree ofNode(float price, const Subtree& first, const Subtree& second,
                        std::uint32_t& plan) {
    float open[kWidth + 1];
    std::uint32_t openWide[kWidth + 1];
    const int useful = std::min(first.most + second.most, kWidth);  // more slots are of no use
    plan = 0;
    for (int slots = 2; slots <= kWidth; ++slots) {
      int best = slots > useful ? first.most : std::max(1, slots - second.most);
      if (slots <= useful) {
        open[slots] = first.least[best] + second.least[slots - best];
        for (int k = best + 1; k <= std::min(first.most, slots - 1); ++k) {
          const float cost = first.least[k] + second.least[slots - k];
          best = cost < open[slots] ? k : best;
          open[slots] = std::min(open[slots], cost);
        }
        openWide[slots] = first.wide[best] + second.wide[slots - best];
      }
      plan |= std::uint32_t(best) << (3 * (slots - 2));
    }
    Subtree whole;
    whole.mostWords = first.mostWords + second.mostWords;
    whole.most = std::min(useful, kWidth - 1);
    whole.least[1] = open[useful] + price;
    whole.wide[1] = openWide[useful] + 1;
    std::uint32_t openFrom = kWidth;
    for (int slots = whole.most; slots >= 2; --slots) {
      const bool isBetter = open[slots] < whole.least[1];
      whole.least[slots] = isBetter ? open[slots] : whole.least[1];
      whole.wide[slots] = isBetter ? openWide[slots] : whole.wide[1];
      if (isBetter) openFrom = std::uint32_t(slots);
    }
    plan |= openFrom << 21;
    return whole;
  }
};

/// The nodes that are taken next, where nobody else takes any.
struct BinaryTree::Block {
  std::uint32_t next = 0;

  std::uint32_t takePair(std::atomic<std::uint32_t>& used) {
    if (next % kBlock == 0) next = used.fetch_add(kBlock);
    next += 2;
    return next - 2;
  }
};

BinaryTree::BinaryTree(BuildItem* items, std::size_t count, const LeafWriter& writer,
                       ThreadPool& pool)
    : used_(kBlock),
      memory_(nodesFor(count) * sizeof(BinaryNode)),
      leastForked_(leastForked(count)),
      items_(items),
      writer_(writer),
      pool_(pool) {
  const BuildRange whole = rangeOf(items, count, pool);
  memoryPrice_ = memoryPrice(whole.box, count);
  Block block{2};  // the root has no neighbour
  const Subtree tree = build(whole, *static_cast<BinaryNode*>(memory_.data()), block);
  wideNodes_ = std::max(tree.wide[1], 1u);  // a leaf alone is below a node, too
  mostLeafWords_ = tree.mostWords;
}

/// The depth of recursion is at most kMostSplits.
BinaryTree::Subtree BinaryTree::build(const BuildRange& range, BinaryNode& node, Block& block) {
  range.box.store(node.low, node.high);  // the fourth lanes land in what is set next
  if (const int primitives = fittingLeaf(range)) {
    node.first = std::uint32_t(range.first - items_);
    node.plan = BinaryNode::kLeaf | std::uint32_t(range.count);
    return Subtree::ofLeaf(range.box.halfArea(), range.first->kind, primitives);
  }
  assert(range.splits < kMostSplits);
  const Split split = range.splits < kMostSahSplits ? bestSplit(range) : Split();
  if (split.axis < 0 && range.splits <= kMostSahSplits) {
    BuildRange unlike = range;  // where no split tells items apart they are halved from here on
    unlike.count = writer_.dropCopies(range.first, range.count);
    unlike.splits = kMostSahSplits + 1;
    return build(unlike, node, block);
  }
  BuildRange left, right;
  splitRange(range, split, pool_, left, right);
  node.first = block.takePair(used_);
  BinaryNode* pair = static_cast<BinaryNode*>(memory_.data()) + node.first;
  Subtree first, second;
  if (std::min(left.count, right.count) > leastForked_) {
    const auto buildSecond = [&] {
      Block other;
      second = build(right, pair[1], other);
    };
    pool_.both([&] { first = build(left, pair[0], block); }, buildSecond);
  } else {
    first = build(left, pair[0], block);
    second = build(right, pair[1], block);
  }
  return Subtree::ofNode(range.box.halfArea() + memoryPrice_, first, second, node.plan);
}

}  // namespace accel
