// The builder: every item in one leaf, boxes that hold, bounded depth, the same tree for any number
// of threads.
#include "accel/bvh_builder.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <vector>

#include "accel/wide_bvh.h"
#include "check.h"
#include "patience.h"
#include "random.h"

namespace {

using accel::BuildItem;
using accel::LeafKind;
using accel::WideBvh;
using accel::WideNode;

/// A leaf's words: its head and the items' numbers.
class PlainWriter : public accel::LeafWriter {
 public:
  int write(const BuildItem* items, int count, std::uint32_t* words) const override {
    words[0] = accel::leafHead(0, items[0].kind, count);
    for (int i = 0; i < count; ++i) words[1 + i] = items[i].id;
    return 1 + count;
  }
};

BuildItem itemAt(const Vec3d& center, double radius, std::size_t id,
                 LeafKind kind = LeafKind::meshTriangles) {
  BuildItem item{};
  for (int axis = 0; axis < 3; ++axis) {
    item.low[axis] = float(center[axis] - radius);
    item.high[axis] = float(center[axis] + radius);
  }
  item.id = std::uint32_t(id);
  item.kind = kind;
  return item;
}

WideBvh treeOf(const std::vector<BuildItem>& list, int threads) {
  accel::BuildItems items(list.size());
  for (const BuildItem& item : list) items.add(item);
  WideBvh bvh;
  accel::ThreadPool::run(threads, list.size(), [&](accel::ThreadPool& pool) {
    accel::buildWideBvh(bvh, std::move(items), PlainWriter(), pool);
  });
  return bvh;
}

/// Walks a tree and counts what is wrong with it.
struct Inspection {
  const WideBvh& bvh;
  const std::vector<BuildItem>& items;
  std::vector<int> seen;
  std::size_t outside = 0, mixed = 0, nodes = 0;
  int depth = 0, frames = 0, frameDepth = 0;  // a frame is a level of its own

  Inspection(const WideBvh& tree, const std::vector<BuildItem>& list)
      : bvh(tree), items(list), seen(list.size()) {
    if (!bvh.isEmpty()) visit(0, 1, 0, bvh.whole.low, bvh.whole.high);
  }

  void visit(std::uint32_t index, int level, int inFrames, const double* low, const double* high) {
    const WideNode& node = bvh.root()[index];
    ++nodes;
    depth = std::max(depth, level);
    frameDepth = std::max(frameDepth, inFrames);
    for (int slot = 0; slot < accel::kWidth; ++slot) {
      if (!(node.planes[0][slot] <= node.planes[1][slot])) continue;  // empty
      double childLow[3], childHigh[3];
      for (int axis = 0; axis < 3; ++axis) {
        childLow[axis] = node.planes[2 * axis][slot];
        childHigh[axis] = node.planes[2 * axis + 1][slot];
        if (childLow[axis] < low[axis] || childHigh[axis] > high[axis]) ++outside;
      }
      const std::uint32_t child = node.child[slot];
      if ((child & accel::kLeafBit) != 0) {
        visitLeaf(bvh.words() + (child & ~accel::kLeafBit), childLow, childHigh);
      } else {
        const int frame = (child & accel::kFrameBit) != 0 ? 1 : 0;
        frames += frame;
        visit(child & ~accel::kFrameBit, level + 1 + frame, inFrames + frame, childLow, childHigh);
      }
    }
  }
  void visitLeaf(const std::uint32_t* words, const double* low, const double* high) {
    const LeafKind kind = accel::kindOf(*words);
    const int count = accel::countOf(*words);
    CHECK(count >= 1 && count <= accel::mostInLeaf(kind));
    for (int i = 0; i < count; ++i) {
      const std::uint32_t id = words[1 + i];
      ++seen.at(id);
      if (items[id].kind != kind) ++mixed;
      for (int axis = 0; axis < 3; ++axis) {
        if (items[id].low[axis] < low[axis] || items[id].high[axis] > high[axis]) ++outside;
      }
    }
  }
  std::size_t notOnce() const {
    std::size_t count = 0;
    for (const int times : seen) count += times != 1;
    return count;
  }
};

/// Builds with one thread, checks everything, and returns nodes and depth.
Inspection checkTree(const char* name, const std::vector<BuildItem>& items, const WideBvh& bvh) {
  Inspection found(bvh, items);
  const std::string where = name;
  CHECK_EQUAL(where + ": not once " + check::show(found.notOnce()), where + ": not once 0");
  CHECK_EQUAL(where + ": outside " + check::show(found.outside), where + ": outside 0");
  CHECK_EQUAL(where + ": mixed " + check::show(found.mixed), where + ": mixed 0");
  CHECK_EQUAL(found.nodes, bvh.nodeCount);
  CHECK_EQUAL(found.depth, bvh.levels);  // from which follows how long a stream's stack is
  CHECK_EQUAL(found.frameDepth, bvh.frameLevels);
  return found;
}

/// Appends node `index` and all below it: planes and frames, leaves' words, but not where they are.
void appendContent(const WideBvh& bvh, std::uint32_t index, std::vector<std::uint32_t>& content) {
  const WideNode& node = bvh.root()[index];
  std::uint32_t planes[6 * accel::kWidth];
  std::memcpy(planes, node.planes, sizeof planes);
  content.insert(content.end(), planes, planes + 6 * accel::kWidth);
  for (int slot = 0; slot < accel::kWidth; ++slot) {
    if (!(node.planes[0][slot] <= node.planes[1][slot])) continue;  // empty
    const std::uint32_t child = node.child[slot];
    content.push_back(child & (accel::kLeafBit | accel::kFrameBit));
    if ((child & accel::kLeafBit) == 0) {
      appendContent(bvh, child & ~accel::kFrameBit, content);
    } else {
      const std::uint32_t* words = bvh.words() + (child & ~accel::kLeafBit);
      content.back() = accel::kLeafBit;
      content.insert(content.end(), words, words + 1 + accel::countOf(*words));
    }
  }
}

std::vector<std::uint32_t> contentOf(const WideBvh& bvh) {
  std::vector<std::uint32_t> content;
  appendContent(bvh, 0, content);
  return content;
}

double secondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<BuildItem> randomItems(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<BuildItem> items;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d center = random.inCube(-1, 1);
    items.push_back(itemAt(center, random.uniform(0, 0.01), i));
  }
  return items;
}

/// Three nests of `count` items, each 2^-14 of the size of the one around it.
std::vector<BuildItem> nestedItems(std::size_t count, LeafKind kind) {
  Random random(8);
  std::vector<BuildItem> items;
  for (std::size_t i = 0; i < 3 * count; ++i) {
    const double size = std::ldexp(1.0, -14 * int(i / count));
    const Vec3d center = random.inCube(-1, 1) * size;
    items.push_back(itemAt(center, size * 0.01, i, kind));
  }
  return items;
}

std::vector<BuildItem> itemsFrom(std::size_t count,
                                 const std::function<BuildItem(std::size_t)>& item) {
  std::vector<BuildItem> items;
  for (std::size_t i = 0; i < count; ++i) items.push_back(item(i));
  return items;
}

}  // namespace

TEST("every item is in exactly one leaf, inside all boxes above it, for 0 to 200 items") {
  for (std::size_t count = 0; count <= 200; ++count) {
    const std::vector<BuildItem> items = randomItems(count, 1000 + count);
    const WideBvh bvh = treeOf(items, 1);
    CHECK_EQUAL(bvh.isEmpty(), count == 0);
    checkTree(("random " + check::show(count)).c_str(), items, bvh);
  }
}

TEST("up to eight triangles are one leaf, and up to 64 need one node") {
  // Eight slots of up to eight triangles; 64 in a cube of 4 x 4 x 4 split evenly six times.
  const auto grid = [](std::size_t i) {
    return itemAt(Vec3d(double(i % 4), double(i / 4 % 4), double(i / 16)) * 0.25, 0.1, i);
  };
  CHECK_EQUAL(treeOf(itemsFrom(8, grid), 1).leafWords, std::size_t(1 + 1 + 8));
  const WideBvh bvh = treeOf(itemsFrom(64, grid), 1);
  CHECK_EQUAL(bvh.nodeCount, std::size_t(1));
  CHECK_EQUAL(bvh.leafWords, std::size_t(1 + 8 * 9));
}

TEST("leaves are of one kind, and other objects are alone") {
  constexpr LeafKind kKinds[] = {LeafKind::looseTriangles, LeafKind::spheres, LeafKind::objects};
  Random random(7);
  std::vector<BuildItem> items;
  for (std::size_t i = 0; i < 3000; ++i) {
    const Vec3d center = random.inCube(-1, 1);
    items.push_back(itemAt(center, 0.02, i, kKinds[random.index(3)]));
  }
  checkTree("mixed", items, treeOf(items, 1));
  // All at one place, too, where no split by centres can tell them apart.
  for (BuildItem& item : items) item = itemAt({0.5, 0, 0}, 0.1, item.id, item.kind);
  checkTree("mixed at one place", items, treeOf(items, 2));
}

TEST("a million identical triangles build in time that does not grow with the square") {
  const auto same = [](std::size_t i) { return itemAt({0.25, 0.5, -0.5}, 0.1, i); };
  const std::vector<BuildItem> items = itemsFrom(1000000, same);
  WideBvh bvh;
  CHECK(secondsOf([&] { bvh = treeOf(items, 2); }) < 20 * kPatience);
  // Halved 17 times (8 < 10^6 / 2^17 + 1), three levels to a node, one more for uneven ones.
  CHECK(checkTree("identical", items, bvh).depth <= 8);
}

TEST("a line of a million spheres builds") {
  const auto onLine = [](std::size_t i) {
    return itemAt({double(i) * 0x1p-20, 0, 0}, 0x1p-24, i, LeafKind::spheres);
  };
  const std::vector<BuildItem> items = itemsFrom(1000000, onLine);
  WideBvh bvh;
  CHECK(secondsOf([&] { bvh = treeOf(items, 2); }) < 20 * kPatience);
  CHECK(checkTree("line", items, bvh).depth <= 12);
}

TEST("sizes over all that floats hold, nested boxes and flat ones build to a bounded depth") {
  const auto shrinking = [](std::size_t i) {
    const double x = std::ldexp(1.0, -int(i % 140));
    return itemAt({x, -x, x * 0.5}, x * 0.1, i);
  };
  const auto nested = [](std::size_t i) { return itemAt({}, std::ldexp(1.0, -int(i % 126)), i); };
  const auto growing = [](std::size_t i) { return itemAt({}, double(i) * 1e-5, i); };
  const auto points = [](std::size_t i) { return itemAt({double(i % 300) * 1e-30, 0, 0}, 0, i); };
  const auto tiny = [](std::size_t i) { return itemAt({double(i) * 1e-42, 0, 0}, 1e-44, i); };
  const std::function<BuildItem(std::size_t)> cases[] = {shrinking, nested, growing, points, tiny};
  const char* names[] = {"shrinking", "nested", "growing", "points", "tiny"};
  for (int i = 0; i < 5; ++i) {
    const std::vector<BuildItem> items = itemsFrom(50000, cases[i]);
    WideBvh bvh;
    CHECK(secondsOf([&] { bvh = treeOf(items, 2); }) < 10 * kPatience);
    checkTree(names[i], items, bvh);
  }
}

TEST("nodes of a mesh that are 4096 times smaller than what is around them begin frames") {
  for (const LeafKind kind : {LeafKind::meshTriangles, LeafKind::spheres}) {
    const std::vector<BuildItem> items = nestedItems(64, kind);
    const Inspection found = checkTree("nests", items, treeOf(items, 1));
    CHECK_EQUAL(found.frames, kind == LeafKind::meshTriangles ? 2 : 0);
    CHECK_EQUAL(found.frameDepth, found.frames);
  }
  const std::vector<BuildItem> usual = randomItems(20000, 9);
  CHECK_EQUAL(checkTree("usual", usual, treeOf(usual, 1)).frames, 0);
}

TEST("the tree is the same, but for the places of nodes and leaves, for 1, 2, 3 and 16 threads") {
  // 300,000 items are divided by all threads together at the top, and in chunks. Below the nests'
  // own roots, other threads make nodes that are in frames.
  for (const auto& items : {randomItems(100, 1), randomItems(20000, 2), randomItems(300000, 3),
                            nestedItems(40000, LeafKind::meshTriangles)}) {
    const WideBvh one = treeOf(items, 1);
    checkTree("one thread", items, one);
    for (const int threads : {2, 3, 16}) {
      const WideBvh several = treeOf(items, threads);
      CHECK_EQUAL(several.nodeCount, one.nodeCount);
      CHECK_EQUAL(several.leafWords, one.leafWords);
      CHECK_EQUAL(several.levels, one.levels);
      CHECK_EQUAL(several.frameLevels, one.frameLevels);
      if (several.nodeCount != one.nodeCount || several.leafWords != one.leafWords) continue;
      CHECK(contentOf(several) == contentOf(one));
    }
  }
}

TEST("leaves of many triangles are nearly full") {
  // Splits near the bottom count begun blocks of eight, so most leaves have 7 or 8; halving alone
  // would spread them from 4 to 8, 6 on average. A leaf's words are its head and its numbers.
  const std::vector<BuildItem> items = randomItems(100000, 5);
  const double leaves = double(treeOf(items, 2).leafWords - 1) - 100000;
  CHECK(100000 / leaves > 6.5);
}

TEST("nearby items share nodes: the expected number of visits is that of a good tree") {
  // A sheet of n x n flat squares of side 1/n. With eight squares to a leaf and 64 leaves' worth of
  // squares to a bottom node, ideal nodes are rectangles without overlap: on each of log8(n n / 8)
  // levels their areas sum to that of the sheet. Real splits overlap at borders: half as much
  // again.
  constexpr std::size_t kSide = 256;
  std::vector<BuildItem> items;
  for (std::size_t i = 0; i < kSide * kSide; ++i) {
    items.push_back(
        itemAt({double(i % kSide) / kSide, double(i / kSide) / kSide, 0}, 0.5 / kSide, i));
    items.back().low[2] = items.back().high[2] = 0;
  }
  const WideBvh bvh = treeOf(items, 2);
  double area = 0;
  for (std::size_t i = 0; i < bvh.nodeCount; ++i) {
    for (int slot = 0; slot < accel::kWidth; ++slot) {
      const float(*planes)[accel::kWidth] = bvh.root()[i].planes;
      if (!(planes[0][slot] <= planes[1][slot])) continue;
      area += double(planes[1][slot] - planes[0][slot]) * double(planes[3][slot] - planes[2][slot]);
    }
  }
  CHECK(area < 1.5 * std::log2(double(kSide * kSide) / 8) / 3 + 1);
}
