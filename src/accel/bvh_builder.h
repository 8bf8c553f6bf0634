// The builder: makes a WideBvh over boxes. It knows no shape: leaves are written by the caller.
#pragma once
#include <cstddef>
#include <cstdint>

#include "accel/wide_bvh.h"

namespace accel {

/// A primitive to be sorted into the tree: its box in the normalised space, rounded outwards.
struct BuildItem {
  float low[3];
  std::uint32_t id;
  float high[3];
  LeafKind kind;
};
static_assert(sizeof(BuildItem) == 32, "two to a cache line");

class LeafWriter {
 public:
  virtual ~LeafWriter() = default;
  /// Writes the leaf of `count` items, all of one kind, into wordsOf(kind, count) words. Called
  /// from several threads at once.
  virtual void write(const BuildItem* items, int count, std::uint32_t* words) const = 0;
};

/// The head of a leaf: `edge` rounded up a little, kind and count in its low byte.
std::uint32_t leafHead(float edge, LeafKind kind, int count);

/// The most primitives a leaf may hold.
constexpr int mostInLeaf(LeafKind kind) { return kind == LeafKind::objects ? 1 : 8; }

/// Builds nodes and leaves of `bvh`, whose anchor and scale are set and whose box this sets, over
/// `count` >= 0 items, which are reordered on the way. Binned surface area heuristic.
/// Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007; eight
/// children by opening the largest first: Wald, Benthin and Boulos, "Getting Rid of Packets", 2008.
void buildWideBvh(WideBvh& bvh, BuildItem* items, std::size_t count, const LeafWriter& writer,
                  int threads);

}  // namespace accel
