// CopyTree: for every length the nearest earlier place whose bytes stand at a place too.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/copy_finder.h"

/// The places of the window in binary search trees, one for each hash of the first three bytes,
/// ordered by the bytes that stand there. A node is always newer than those below it, so that on
/// the way to where a place belongs lies, for each length, the newest place that shares so much:
/// it roots the subtree of all that do (Seidel and Aragon, Randomized Search Trees, 1996: a treap
/// whose priority is the time).
class CopyTree {
 public:
  /// `bytes`, fewer than 2^32 - 1, must stay where they are while the tree is used. `depth` bounds
  /// the nodes that are looked at for a place; what is below them is then forgotten.
  CopyTree(const std::uint8_t* bytes, std::size_t size, unsigned depth);

  /// Puts the copies for place `at` at the end of `copies`, longer and longer, each at the least
  /// distance that such a length is found at; then adds the place. Places come one after the other.
  void findAndAdd(std::size_t at, std::vector<Copy>& copies);

 private:
  static constexpr unsigned kHashBits = 15;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  struct Node {
    std::uint32_t less = kNone, more = kNone;  // the newest places of either side
  };

  std::size_t hashAt(std::size_t at) const;
  bool isInWindow(std::uint32_t place, std::size_t at) const;

  const std::uint8_t* bytes_;
  std::size_t size_;
  unsigned depth_;
  std::vector<std::uint32_t> newest_;  // by hash of three bytes
  std::vector<Node> nodes_;            // by place modulo the window
};
