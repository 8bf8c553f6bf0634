// GatherCost: the least expected cost of a binary subtree's parts as children of wide nodes.
//
// A subtree may hand its parent one child (itself as a node) or up to seven (the parts it is opened
// into). Costs are surfaces, so proportional to the expected number of visits by a random ray; the
// number of leaves is given, so what a leaf costs against a node does not matter. Source: Ylitie,
// Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs",
// 2017.
#pragma once
#include <algorithm>
#include <cstdint>

#include "accel/wide_bvh.h"

namespace accel {

/// How a binary node is gathered. A leaf: kLeaf and its number of items. Else for each number of
/// slots from 2 to 8 how many of them its first child gets, three bits each, and from which number
/// of slots on it is better opened than left whole.
class GatherPlan {
 public:
  static constexpr std::uint32_t kLeaf = 0x80000000u;

  static constexpr std::uint32_t leaf(std::size_t items) { return kLeaf | std::uint32_t(items); }
  static constexpr bool isLeaf(std::uint32_t plan) { return (plan & kLeaf) != 0; }
  static constexpr int leafItems(std::uint32_t plan) { return int(plan & 15); }
  static constexpr int forFirst(std::uint32_t plan, int slots) {
    return int(plan >> (3 * (slots - 2)) & 7);
  }
  static constexpr int openFrom(std::uint32_t plan) { return int(plan >> 21 & 15); }
};

struct GatherCost {
  float least[kWidth];  ///< [i]: with up to i children, 1 <= i < kWidth; [0] is unused

  /// A leaf of an area.
  static GatherCost ofLeaf(float area) {
    GatherCost cost;
    for (float& c : cost.least) c = area;
    return cost;
  }
  /// A node over two subtrees, where being a node of its own costs `price`; stores its plan.
  static GatherCost ofNode(float price, const GatherCost& first, const GatherCost& second,
                           std::uint32_t& plan) {
    float open[kWidth + 1];
    plan = 0;
    for (int slots = 2; slots <= kWidth; ++slots) {
      int best = 1;
      open[slots] = first.least[1] + second.least[slots - 1];
      for (int k = 2; k < slots; ++k) {
        const float cost = first.least[k] + second.least[slots - k];
        best = cost < open[slots] ? k : best;
        open[slots] = std::min(open[slots], cost);
      }
      plan |= std::uint32_t(best) << (3 * (slots - 2));
    }
    GatherCost cost;
    cost.least[0] = cost.least[1] = open[kWidth] + price;
    std::uint32_t openFrom = kWidth;
    for (int slots = kWidth - 1; slots >= 2; --slots) {
      cost.least[slots] = std::min(cost.least[1], open[slots]);
      if (open[slots] < cost.least[1]) openFrom = std::uint32_t(slots);
    }
    plan |= openFrom << 21;
    return cost;
  }
};

}  // namespace accel
