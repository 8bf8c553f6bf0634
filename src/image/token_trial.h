// TokenTrial: quickly found tokens, to see about what bytes would cost compressed.
#pragma once
#include "image/bytes.h"
#include "image/copy_finder.h"
#include "image/deflate_costs.h"

namespace deflate {

/// Tries bytes behind others: each token is the literal or the copy that saves most at its place,
/// whatever comes after. For two ways to filter a row that tells the cheaper one about as well as
/// the cheapest tokens do, in a fraction of the time.
class TokenTrial {
 public:
  /// `bytes` must stay where they are; those that are not yet passed may change. `depth` as for
  /// CopyFinder.
  TokenTrial(const Bytes& bytes, unsigned depth)
      : bytes_(bytes.data()), finder_(bytes.data(), bytes.size(), depth) {}

  /// The bytes before place `to` stay, and copies may be made of them from now on.
  void passTo(std::size_t to);
  /// The symbols of bytes[passed..to), without the end of a block, where symbols cost `costs`.
  SymbolCounts tryTo(std::size_t to, const Costs& costs);

 private:
  Token bestAt(std::size_t at, std::size_t end, const Costs& costs);

  const std::uint8_t* bytes_;
  CopyFinder finder_;
  std::size_t passed_ = 0;
  std::vector<Copy> copies_;  // of one place; kept for its memory
};

}  // namespace deflate
