// Collapsing follows the plans of the binary nodes from the root down.
//
// The children of one wide node lie side by side, then comes all that is below the first of them,
// then all below the next: so counting what is below a node tells every number, whichever thread
// makes the nodes. Leaves are met in the order of the items. They are written in batches, each of
// which gets its place when its size is known.
#include "accel/collapse.h"

#include <algorithm>
#include <limits>

namespace accel {
namespace {

/// Leaves that are written in one go, to a place of their own.
constexpr int kLeavesPerBatch = 64;

/// A node so much smaller than the frame that it is in begins another.
constexpr float kFrameStep = 0x1p-12f;

/// The binary nodes that become the children of a wide one.
struct Children {
  std::uint32_t nodes[kWidth];
  int count = 0;

  Children(const BinaryTree& tree, std::uint32_t index) { open(tree, index, kWidth); }

 private:
  /// Adds what becomes of `index` in `slots` slots; eight slots open any node that is no leaf.
  void open(const BinaryTree& tree, std::uint32_t index, int slots) {
    const BinaryNode& node = tree.node(index);
    if (CollapsePlan::isLeaf(node.plan) || slots < CollapsePlan::openFrom(node.plan)) {
      nodes[count++] = index;
      return;
    }
    const int first = CollapsePlan::forFirst(node.plan, slots);
    open(tree, node.children, first);
    open(tree, node.children + 1, slots - first);
  }
};

void countBelow(const BinaryTree& tree, std::uint32_t index, Job& job, std::vector<Job>* others) {
  const Children children(tree, index);
  for (int i = 0; i < children.count; ++i) {
    const std::uint32_t child = children.nodes[i];
    if (tree.isLeaf(child)) {
      job.items += tree.node(child).children;
      continue;
    }
    ++job.nodes;
    if (others && !tree.isTop(child)) {
      others->emplace_back(child);
    } else {
      countBelow(tree, child, job, others);
    }
  }
}

/// Does one job.
class WideNodeBuilder {
 public:
  WideNodeBuilder(Collapse& shared, Job& job, Job* others)
      : shared_(shared), tree_(shared.tree), job_(job), others_(others), batchItem_(job.nextItem) {}

  void run() {
    makeNode(job_.number, job_.binary, job_.place);
    finishBatch();
  }

 private:
  /// Makes wide node `number` of binary node `index`. Recursion is as deep as the wide tree.
  void makeNode(std::uint32_t number, std::uint32_t index, const Place& place) {
    job_.levels = std::max(job_.levels, place.level);
    job_.frameLevels = std::max(job_.frameLevels, place.frames);
    const Children children(tree_, index);
    WideNode& target = shared_.nodes[number];
    setBoxes(target, children);
    for (int i = 0; i < children.count; ++i) {  // nodes of one parent lie side by side
      if (!tree_.isLeaf(children.nodes[i])) target.child[i] = std::uint32_t(job_.nextNode++);
    }
    for (int i = 0; i < children.count; ++i) {
      const std::uint32_t child = children.nodes[i];
      if (tree_.isLeaf(child)) {
        addLeaf(int(tree_.node(child).children), target.child[i]);
        continue;
      }
      const std::uint32_t childNumber = target.child[i];
      Place inside = {place.level + 1, place.frames, place.frameSize};
      if (beginsFrame(child, place.frameSize)) {
        target.child[i] |= kFrameBit;
        inside = {place.level + 2, place.frames + 1, tree_.longestSide(child)};
      }
      if (others_ && !tree_.isTop(child)) {
        handOver(childNumber, inside);
      } else {
        makeNode(childNumber, child, inside);
      }
    }
  }

  /// Tells the next of the others where it begins, and goes on behind it.
  void handOver(std::uint32_t number, const Place& place) {
    finishBatch();
    Job& other = *others_++;
    other.number = number;
    other.place = place;
    other.nextNode = job_.nextNode;
    other.nextItem = job_.nextItem;
    job_.nextNode += other.nodes;
    job_.nextItem += other.items;
    batchItem_ = job_.nextItem;
  }

  /// Writes a leaf of the next `count` items; `child` is told where it is when the batch ends.
  void addLeaf(int count, std::uint32_t& child) {
    const BuildItem* items = shared_.items.data() + job_.nextItem;
    shared_.writer.prepare(items, count, shared_.items.count() - job_.nextItem);
    child = kLeafBit + std::uint32_t(size_);
    size_ += std::size_t(shared_.writer.write(items, count, words_ + size_));
    job_.nextItem += std::size_t(count);
    batch_[leaves_++] = &child;
    if (leaves_ == kLeavesPerBatch) finishBatch();
  }

  void finishBatch() {
    const std::size_t place = shared_.wordCount.fetch_add(size_);
    std::copy(words_, words_ + size_, shared_.words + place);
    for (int i = 0; i < leaves_; ++i) *batch_[i] += std::uint32_t(place);
    giveBack(batchItem_, job_.nextItem);
    batchItem_ = job_.nextItem;
    size_ = 0;
    leaves_ = 0;
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

  bool beginsFrame(std::uint32_t index, float around) const {
    const float size = tree_.longestSide(index);
    return shared_.hasFrames && size < around * kFrameStep && size > TreeFrame::kLeast;
  }

  Collapse& shared_;
  const BinaryTree& tree_;
  Job& job_;
  Job* others_;

  // The leaves that have no place yet: their words, and who is to be told.
  std::uint32_t words_[kLeavesPerBatch * kMostLeafWords];
  std::uint32_t* batch_[kLeavesPerBatch];
  std::size_t size_ = 0, batchItem_;
  int leaves_ = 0;
};

}  // namespace

void countNodes(const BinaryTree& tree, Job& job, std::vector<Job>* others) {
  countBelow(tree, job.binary, job, others);
}

void Collapse::run(Job& job, Job* others) { WideNodeBuilder(*this, job, others).run(); }

}  // namespace accel
