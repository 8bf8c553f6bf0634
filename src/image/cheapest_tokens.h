// The cheapest way to say a stretch of bytes in literals and copies.
#pragma once
#include "image/copy_finder.h"
#include "image/deflate_costs.h"

namespace deflate {

constexpr std::size_t kLongestStretch = std::size_t{1} << 21;

/// The copies that each place of a stretch could be said with.
class CopyLists {
 public:
  /// For bytes[from..to), with copies of what stands up to a window before; `depth` as for
  /// CopyTree.
  CopyLists(const std::uint8_t* bytes, std::size_t from, std::size_t to, unsigned depth);

  std::size_t size() const { return first_.size() - 1; }
  const Copy* begin(std::size_t place) const { return copies_.data() + first_[place]; }
  const Copy* end(std::size_t place) const { return copies_.data() + first_[place + 1]; }

 private:
  std::vector<std::uint32_t> first_;  // by place, and one more
  std::vector<Copy> copies_;
};

/// What symbols cost from a place of the stretch on, until the next such place.
struct CostsFrom {
  std::size_t place;
  Costs costs;
};

/// Tokens for the bytes that `lists` are about, `bytes` being the first of them, whose costs have
/// the least sum. Each copy is also used shortened. `costs` are by rising places, the first 0.
/// At most kLongestStretch bytes, so that the sum fits 32 bits.
std::vector<Token> cheapestTokens(const std::uint8_t* bytes, const CopyLists& lists,
                                  const std::vector<CostsFrom>& costs);

}  // namespace deflate
