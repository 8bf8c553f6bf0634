// The cheapest way to say a stretch of bytes in literals and copies.
#pragma once
#include "image/copy_finder.h"
#include "image/deflate_costs.h"

namespace deflate {

/// The copies that each place of a stretch could be said with.
class CopyLists {
 public:
  /// For bytes[from..to), of which copies do not go beyond `to`. Gives every place to `finder`,
  /// which has been given those before.
  void collect(CopyFinder& finder, std::size_t from, std::size_t to);

  std::size_t size() const { return first_.size() - 1; }
  const Copy* begin(std::size_t place) const { return copies_.data() + first_[place]; }
  const Copy* end(std::size_t place) const { return copies_.data() + first_[place + 1]; }

 private:
  std::vector<std::size_t> first_;  // by place, and one more
  std::vector<Copy> copies_;
};

/// Tokens for the bytes that `lists` are about, `bytes` being the first of them, whose costs have
/// the least sum. Each copy is also used shortened.
std::vector<Token> cheapestTokens(const std::uint8_t* bytes, const CopyLists& lists,
                                  const Costs& costs);

/// Only what they cost.
std::uint64_t leastCost(const std::uint8_t* bytes, const CopyLists& lists, const Costs& costs);

}  // namespace deflate
