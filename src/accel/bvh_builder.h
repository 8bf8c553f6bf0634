// The builder: makes a WideBvh over boxes. It knows no shape: leaves are written by the caller.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>

#include "accel/thread_pool.h"
#include "accel/wide_bvh.h"

namespace accel {

/// Primitives id to id + primitives - 1, one or two, to be sorted into the tree together: their box
/// in the normalised space, rounded outwards, finite.
struct BuildItem {
  float low[3];
  std::uint32_t id;
  float high[3];
  LeafKind kind;
  std::uint16_t primitives = 1;
};
static_assert(sizeof(BuildItem) == 32, "two to a cache line");

/// Room for the items of a tree.
class BuildItems {
 public:
  /// Items to a large page.
  static constexpr std::size_t kPerLargePage = (std::size_t(1) << 21) / sizeof(BuildItem);

  /// Room for `capacity` items; memory is taken only as they are written.
  explicit BuildItems(std::size_t capacity) : memory_(capacity * sizeof(BuildItem)) {}

  BuildItem* data() { return static_cast<BuildItem*>(memory_.data()); }
  std::size_t count() const { return count_; }
  /// Room for `count` more, behind the others.
  BuildItem* append(std::size_t count) { return data() + std::exchange(count_, count_ + count); }
  /// Gives back unused room, but for the rest of the last item's large page: in small pages it
  /// would be slower to read (build time 1.03).
  void trim() { memory_.shrink((count_ / kPerLargePage + 1) * kPerLargePage * sizeof(BuildItem)); }
  void add(const BuildItem& item) { *append(1) = item; }
  /// Gives back the memory of items [begin, end) as far as it fills pages. Thread-safe. Less than
  /// large pages should not be: reading what is left of one is slow (build time 1.3).
  void discard(std::size_t begin, std::size_t end) {
    memory_.discard(begin * sizeof(BuildItem), end * sizeof(BuildItem));
  }

 private:
  PageBuffer memory_;
  std::size_t count_ = 0;
};

/// Writes leaves; called from several threads at once.
class LeafWriter {
 public:
  virtual ~LeafWriter() = default;
  /// Writes a leaf of `count` items, which are all of one kind, to `words`, where there is room for
  /// kMostLeafWords; returns how many it took.
  virtual int write(const BuildItem* items, int count, std::uint32_t* words) const = 0;
  /// Of `count` items that no split can tell apart, moves those to the front that the tree is to
  /// hold, and returns how many. What is alike in many items may be held by one of them.
  virtual std::size_t dropCopies(BuildItem* /*items*/, std::size_t count) const { return count; }
};

/// The head of a leaf: `edge` rounded up a little; see LeafKind.
std::uint32_t leafHead(float edge, LeafKind kind, int count, int vertices = 0);

/// The most words of a triangle, which shares no vertex, of an object, and of a leaf.
constexpr int kMostTriangleWords = 10, kMostObjectWords = 34,
              kMostLeafWords = kFirstRow + 8 * kMostTriangleWords;

/// The most primitives a leaf may hold.
constexpr int mostInLeaf(LeafKind kind) { return kind == LeafKind::objects ? 1 : 8; }

/// Builds nodes and leaves of `bvh`, whose anchor and scale are set and whose box this sets, over
/// `items` (where they are too many for 31 bits to tell leaves apart: std::length_error), whose
/// memory is given back as the leaves are written. The tree is a function of the items alone, but
/// where its nodes and leaves are is not. Binary splits by the binned surface area heuristic,
/// collapsed into nodes of eight at the least expected cost. Sources: Wald, "On fast Construction
/// of SAH-based Bounding Volume Hierarchies", 2007; Ylitie, Karras and Laine, "Efficient Incoherent
/// Ray Traversal on GPUs Through Compressed Wide BVHs", 2017.
void buildWideBvh(WideBvh& bvh, BuildItems items, const LeafWriter& writer, ThreadPool& pool);

}  // namespace accel
