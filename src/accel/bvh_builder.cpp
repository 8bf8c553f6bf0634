// The builder: from items to a binary tree, and from that to nodes of eight and their leaves.
//
// BinaryTree splits the items until they fit into leaves, and finds for each node the cheapest way
// to collapse what is below it into wide nodes. These plans are then followed from the root down,
// and what is below the first levels is divided among the threads. Who makes a wide node takes
// numbers for all its children at once, so that they lie side by side. Leaves are written in
// batches, each of which gets its place when its size is known. The memory of items is given back
// as soon as they are in leaves, so that items, leaves and nodes are never in memory all at once.
#include "accel/bvh_builder.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "accel/binary_tree.h"
#include "accel/thread_pool.h"

namespace accel {
namespace {

/// Leaves that are written in one go, to a place of their own.
constexpr int kLeavesPerBatch = 64;

/// What is below so many levels is divided among the threads.
constexpr int kTopLevels = 2;

/// A node so much smaller than the frame that it is in begins another.
constexpr float kFrameStep = 0x1p-12f;

/// Where a wide node is: its level from the root's 1 on, how many frames it is in, and the longest
/// side of the innermost, or of the whole tree.
struct Place {
  int level, frames;
  float frameSize;
};

/// A wide node that is still to be made: `child` of its parent says its number.
struct Job {
  std::uint32_t* child;
  const BinaryNode* node;
  Place parent;
};

/// What all threads share while they make wide nodes.
struct Collapse {
  const BinaryTree& tree;
  BuildItems& items;
  const LeafWriter& writer;
  WideBvh& bvh;
  WideNode* const nodes = static_cast<WideNode*>(bvh.memory.data());
  std::uint32_t* const words = reinterpret_cast<std::uint32_t*>(nodes + bvh.nodeCount);
  /// Only leaves of a mesh hold exact numbers, which can be seen from nearby.
  const bool hasFrames = items.data()->kind == LeafKind::meshTriangles;
  /// Counters have cache lines of their own: all else is only read.
  alignas(64) std::atomic<std::size_t> nodeCount{1};
  alignas(64) std::atomic<std::size_t> wordCount{1};  ///< offset 0 means no leaf
  /// Of each large page of items, how many are in leaves.
  alignas(64) std::vector<std::atomic<std::size_t>> doneItems =
      std::vector<std::atomic<std::size_t>>(items.count() / BuildItems::kPerLargePage + 1);
  std::mutex mutex = {};  ///< of bvh.levels and bvh.frameLevels
};

/// The binary nodes that become the children of a wide one.
struct Children {
  const BinaryNode* nodes[kWidth];
  int count = 0;

  Children(const BinaryTree& tree, const BinaryNode& node) { open(tree, node, kWidth); }

 private:
  /// Adds what becomes of a node in `slots` slots; eight slots open any node that is no leaf.
  void open(const BinaryTree& tree, const BinaryNode& node, int slots) {
    if (node.isLeaf() || slots < node.openFrom()) {
      nodes[count++] = &node;
      return;
    }
    const BinaryNode* halves = tree.halvesOf(node);
    const int ofFirst = node.slotsOfFirst(slots);
    open(tree, halves[0], ofFirst);
    open(tree, halves[1], slots - ofFirst);
  }
};

/// Makes what is below some wide node, by one thread.
class WideNodeBuilder {
 public:
  explicit WideNodeBuilder(Collapse& shared) : shared_(shared) {}

  /// Makes wide node `number` and all below it; with `jobs`, only the top levels, and what is below
  /// them is added there, in the order of the items. Recursion is as deep as the wide tree.
  void makeNode(std::size_t number, const BinaryNode& node, const Place& place,
                std::vector<Job>* jobs) {
    levels_ = std::max(levels_, place.level);
    frameLevels_ = std::max(frameLevels_, place.frames);
    const Children children(shared_.tree, node);
    WideNode& target = shared_.nodes[number];
    setBoxes(target, children);
    numberChildren(target, children);
    for (int i = 0; i < children.count; ++i) {
      const Job job{&target.child[i], children.nodes[i], place};
      if (jobs && place.level == kTopLevels && !job.node->isLeaf()) {
        jobs->push_back(job);
      } else {
        makeChild(job, jobs);
      }
    }
  }

  /// Makes what a child becomes, a leaf or a node.
  void makeChild(const Job& job, std::vector<Job>* jobs) {
    const BinaryNode& node = *job.node;
    const Place& parent = job.parent;
    if (node.isLeaf()) return addLeaf(node, *job.child);
    const std::size_t number = *job.child;
    Place place = {parent.level + 1, parent.frames, parent.frameSize};
    const float size = Box4::of(node).longestSide();
    if (shared_.hasFrames && size < parent.frameSize * kFrameStep && size > TreeFrame::kLeast) {
      *job.child |= kFrameBit;
      place = {parent.level + 2, parent.frames + 1, size};
    }
    makeNode(number, node, place, jobs);
  }

  /// To be called when all is made.
  void finish() {
    finishBatch();
    const std::lock_guard<std::mutex> lock(shared_.mutex);
    shared_.bvh.levels = std::max(shared_.bvh.levels, levels_);
    shared_.bvh.frameLevels = std::max(shared_.bvh.frameLevels, frameLevels_);
  }

 private:
  static void setBoxes(WideNode& target, const Children& children) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    for (int i = 0; i < kWidth; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        const BinaryNode* child = i < children.count ? children.nodes[i] : nullptr;
        // Adding 0 turns -0 into 0: which of them is the smaller depends on the order of asking.
        target.planes[2 * axis][i] = child ? child->low[axis] + 0.0f : inf;
        target.planes[2 * axis + 1][i] = child ? child->high[axis] + 0.0f : -inf;
      }
      target.child[i] = 0;
    }
  }

  void numberChildren(WideNode& target, const Children& children) {
    std::uint32_t inner = 0;
    for (int i = 0; i < children.count; ++i) {
      if (!children.nodes[i]->isLeaf()) target.child[i] = inner++;
    }
    const std::size_t first = shared_.nodeCount.fetch_add(inner);
    for (int i = 0; i < children.count; ++i) target.child[i] += std::uint32_t(first);
  }

  /// Writes a leaf; `child` is told where it is when the batch ends.
  void addLeaf(const BinaryNode& leaf, std::uint32_t& child) {
    if (leaf.first != batchEnd_ || leaves_ == kLeavesPerBatch) {
      finishBatch();
      batchBegin_ = leaf.first;
    }
    const BuildItem* items = shared_.items.data() + leaf.first;
    child = kLeafBit + std::uint32_t(size_);
    size_ += std::size_t(shared_.writer.write(items, leaf.items(), words_ + size_));
    batch_[leaves_++] = &child;
    batchEnd_ = leaf.first + std::size_t(leaf.items());
  }

  void finishBatch() {
    const std::size_t place = shared_.wordCount.fetch_add(size_);
    std::copy(words_, words_ + size_, shared_.words + place);
    for (int i = 0; i < leaves_; ++i) *batch_[i] += std::uint32_t(place);
    giveBack(batchBegin_, batchEnd_);
    size_ = 0;
    leaves_ = 0;
    batchBegin_ = batchEnd_;
  }

  /// Items [begin, end) are in leaves. The memory of a large page of items is given back when all
  /// of them are.
  void giveBack(std::size_t begin, std::size_t end) {
    BuildItems& items = shared_.items;
    for (std::size_t next; begin < end; begin = next) {
      const std::size_t page = begin / BuildItems::kPerLargePage;
      const std::size_t first = page * BuildItems::kPerLargePage;
      const std::size_t last = std::min(first + BuildItems::kPerLargePage, items.count());
      next = std::min(end, last);
      const std::size_t done = shared_.doneItems[page] += next - begin;
      if (done == last - first) items.discard(first, last);
    }
  }

  Collapse& shared_;
  int levels_ = 0, frameLevels_ = 0;  // the most that have been met

  // The leaves that have no place yet: their words, who is to be told, and their items.
  std::uint32_t words_[kLeavesPerBatch * kMostLeafWords];
  std::uint32_t* batch_[kLeavesPerBatch];
  std::size_t size_ = 0, batchBegin_ = 0, batchEnd_ = 0;
  int leaves_ = 0;
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
  const BinaryTree tree(items.data(), items.count(), writer, pool);
  const std::size_t mostWords = 1 + tree.mostLeafWords();
  if (mostWords >= kLeafBit) throw std::length_error("too many primitives for one tree");
  bvh.nodeCount = tree.wideNodes();
  const auto bytesWith = [&](std::size_t words) {
    return bvh.nodeCount * sizeof(WideNode) + (words + kWidth) * sizeof(std::uint32_t);
  };
  bvh.memory = PageBuffer(bytesWith(mostWords));
  Collapse collapse{tree, items, writer, bvh};
  std::vector<Job> jobs;
  WideNodeBuilder top(collapse);
  top.makeNode(0, tree.root(), {1, 0, Box4::of(tree.root()).longestSide()}, &jobs);
  top.finish();
  pool.forEachIndex(jobs.size(), [&](std::size_t i) {
    WideNodeBuilder builder(collapse);
    builder.makeChild(jobs[i], nullptr);
    builder.finish();
  });
  assert(collapse.nodeCount == bvh.nodeCount);
  bvh.leafWords = collapse.wordCount;
  bvh.memory.shrink(bytesWith(bvh.leafWords));
  bvh.whole = TreeFrame::of(*bvh.root());
}

}  // namespace accel
