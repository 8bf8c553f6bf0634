// BinaryTree: large ranges are split by all threads together, the others are tasks for one each.
//
// From the root down ranges are split, each by all threads, until they are small enough to be
// tasks; then the threads take the tasks, the largest first. Which ranges become tasks depends on
// the number of threads, but the tree does not: each split is a function of its items alone. On the
// way back up every node learns what its subtree costs as 1 to 7 children of a wide node, from the
// costs of its two halves. Tasks take nodes in blocks, so that they need no lock, and memory is
// filled from the front.
#include "accel/binary_tree.h"

#include <algorithm>
#include <cassert>

#include "accel/split_range.h"
#include "accel/thread_pool.h"

namespace accel {
namespace {

/// Tasks for each thread: enough that none waits long for the last one.
constexpr std::size_t kTasksPerThread = 8;

/// The plan of nodes above the tasks until these are done; no other plan has this bit.
constexpr std::uint32_t kTopPlan = 0x40000000u;

std::size_t mostInTask(std::size_t count, int threads) {
  return threads == 1
             ? count
             : std::max(count / (std::size_t(threads) * kTasksPerThread), ThreadPool::kLeastShared);
}

/// Nodes that a task takes at a time.
constexpr std::uint32_t kBlock = 64;

/// Every item has room for two nodes, and what is above the tasks for as many; there a level has at
/// most one node for each mostInTask items. Each task may leave a block unfinished.
std::size_t nodesFor(std::size_t count, int threads) {
  return 2 * count +
         (kBlock + 2) * std::size_t(kMostSplits) * (count / mostInTask(count, threads) + 1);
}

void setBox(BinaryNode& node, const Box4& box) {
  // The fourth lanes land in `children` and `plan`, which are written later.
  box.low.store(node.low);
  box.high.store(node.high);
}

/// What a node costs beyond its surface, for its memory: so small that the expected visits stay
/// the same within 0.1 %, it saves 4 % of the nodes. Where surfaces vanish, the fewest nodes win.
float memoryPrice(const Box4& whole, std::size_t count) {
  return 20 * halfArea(whole) / float(count) + 0x1p-100f;
}

Box4 boxOf(const BinaryNode& node) { return {Float4::load(node.low), Float4::load(node.high)}; }

}  // namespace

/// Builds one range with one thread.
class BinaryTree::Subtree {
 public:
  Subtree(BinaryTree& tree, Task& task)
      : nodes_(tree.nodes()),
        used_(tree.used_),
        uniform_(tree.uniform_),
        memoryPrice_(tree.memoryPrice_),
        task_(task) {}

  /// The depth of recursion is at most kMostSplits.
  CollapseCost build(const BuildRange& range, std::uint32_t index) {
    BinaryNode& node = nodes_[index];
    setBox(node, range.box);
    if (const int primitives = fittingLeaf(range, uniform_)) {
      node.plan = CollapsePlan::kLeaf;
      node.children = std::uint32_t(range.count);
      task_.mostLeafWords += std::size_t(kFirstRow + kMostTriangleWords * primitives);
      return CollapseCost::ofLeaf(halfArea(range.box));
    }
    assert(range.splits < kMostSplits);
    BuildRange left, right;
    splitRange(range, uniform_, alone_, left, right);
    if (next_ % kBlock == 0) next_ = used_.fetch_add(kBlock);
    const std::uint32_t pair = next_;
    next_ += 2;
    node.children = pair;
    const CollapseCost first = build(left, pair), second = build(right, pair + 1);
    return CollapseCost::ofNode(halfArea(range.box) + memoryPrice_, first, second, node.plan);
  }

 private:
  BinaryNode* nodes_;
  std::atomic<std::uint32_t>& used_;
  std::uint32_t next_ = 0;
  const bool uniform_;
  const float memoryPrice_;
  ThreadPool alone_;
  Task& task_;
};

BinaryTree::BinaryTree(BuildItem* items, std::size_t count, ThreadPool& pool)
    : memory_(nodesFor(count, pool.threads()) * sizeof(BinaryNode)),
      used_(kRoot + 2),  // the root's pair is not used
      pool_(pool),
      mostInTask_(mostInTask(count, pool.threads())) {
  const BuildRange whole = wholeRange(items, count);
  memoryPrice_ = memoryPrice(whole.box, count);
  // A part for each thread, or more; then each thread splits its own, without waiting for others.
  std::vector<Task> parts;
  const std::size_t mostInPart = std::max(count / std::size_t(pool.threads()), mostInTask_);
  splitTop(whole, kRoot, mostInPart, pool, parts);
  std::vector<std::vector<Task>> tasks(parts.size());
  pool.forEachIndex(parts.size(), [&](std::size_t i) {
    ThreadPool alone;
    splitTop(parts[i].range, parts[i].node, mostInTask_, alone, tasks[i]);
  });
  for (const std::vector<Task>& part : tasks) tasks_.insert(tasks_.end(), part.begin(), part.end());
  used_ = topEnd_ = (used_ + kBlock - 1) / kBlock * kBlock;
  runTasks();
  std::size_t task = 0;
  finishTop(kRoot, task);
}

std::size_t BinaryTree::mostLeafWords() const {
  std::size_t words = 0;
  for (const Task& task : tasks_) words += task.mostLeafWords;
  return words;
}

BuildRange BinaryTree::wholeRange(BuildItem* items, std::size_t count) {
  constexpr std::size_t kChunk = 65536;
  const std::size_t chunks = (count + kChunk - 1) / kChunk;
  std::vector<BuildRange> ranges(chunks);
  std::vector<char> uniform(chunks);
  pool_.forEachIndex(chunks, [&](std::size_t i) {
    BuildItem* first = items + i * kChunk;
    const std::size_t size = std::min(kChunk, count - i * kChunk);
    ranges[i] = rangeOf(first, size, 0);
    uniform[i] = std::all_of(first, first + size,
                             [&](const BuildItem& item) { return item.kind == items[0].kind; });
  });
  BuildRange whole{items, count, Box4::empty(), Box4::empty(), 0};
  for (std::size_t i = 0; i < chunks; ++i) {
    whole.box.extend(ranges[i].box);
    whole.centers.extend(ranges[i].centers);
    uniform_ = uniform_ && uniform[i] != 0;
  }
  return whole;
}

void BinaryTree::splitTop(const BuildRange& range, std::uint32_t index, std::size_t mostInTask,
                          ThreadPool& pool, std::vector<Task>& tasks) {
  BinaryNode& node = nodes()[index];
  if (range.count <= mostInTask) {
    tasks.push_back({range, index, {}, 0});
    return;
  }
  BuildRange left, right;
  splitRange(range, uniform_, pool, left, right);
  setBox(node, range.box);
  node.children = used_.fetch_add(2);
  node.plan = kTopPlan;
  splitTop(left, node.children, mostInTask, pool, tasks);
  splitTop(right, node.children + 1, mostInTask, pool, tasks);
}

void BinaryTree::runTasks() {
  std::vector<Task*> bySize;
  for (Task& task : tasks_) bySize.push_back(&task);
  std::sort(bySize.begin(), bySize.end(),
            [](const Task* a, const Task* b) { return a->range.count > b->range.count; });
  pool_.forEachIndex(bySize.size(), [&](std::size_t i) {
    Task& task = *bySize[i];
    Subtree subtree(*this, task);
    task.cost = subtree.build(task.range, task.node);
  });
}

CollapseCost BinaryTree::finishTop(std::uint32_t index, std::size_t& task) {
  BinaryNode& node = nodes()[index];
  if (node.plan != kTopPlan) return tasks_[task++].cost;  // tasks are in the order of the walk
  const CollapseCost first = finishTop(node.children, task);
  const CollapseCost second = finishTop(node.children + 1, task);
  return CollapseCost::ofNode(halfArea(boxOf(node)) + memoryPrice_, first, second, node.plan);
}

}  // namespace accel
