// What the symbols of a deflate block cost, so that cheap ways to say the same can be found.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "image/copy_finder.h"
#include "image/deflate_tables.h"

namespace deflate {

/// A literal byte (distance 0, `length` being the byte) or a copy.
using Token = Copy;
inline bool isLiteral(Token token) { return token.distance == 0; }

/// The place in kLengths of a length of 3..258, and in kDistances of a distance of 1..32768.
unsigned lengthRange(unsigned length);
unsigned distanceRange(unsigned distance);

/// How often each symbol occurs in a block.
struct SymbolCounts {
  std::array<std::uint32_t, kLiteralSymbols> literals = {};
  std::array<std::uint32_t, kDistanceSymbols> distances = {};

  void add(Token token);
  /// Those of the rest of a block when `part` is made a block of its own: both have an end.
  SymbolCounts without(const SymbolCounts& part) const;
  /// Of tokens[first..last), and the end of the block.
  static SymbolCounts of(const std::vector<Token>& tokens, std::size_t first, std::size_t last);
};

/// In units of 1/64 bit, further bits included.
struct Costs {
  static constexpr std::uint32_t kBit = 64;

  std::array<std::uint32_t, 256> literal;
  std::array<std::uint32_t, kLongestCopy + 1> length;  // from kShortestCopy on
  std::array<std::uint32_t, kDistanceSymbols> distance;

  /// -log2 of each symbol's share in `counts`; symbols that do not occur are taken to occur a
  /// little.
  explicit Costs(const SymbolCounts& counts);

  std::uint32_t of(Token token) const {
    return isLiteral(token) ? literal[token.length]
                            : length[token.length] + distance[distanceRange(token.distance)];
  }
  /// Of all symbols but the end of a block.
  std::uint64_t of(const SymbolCounts& counts) const;
};

/// Costs before anything is known of the bytes: all symbols cost the same.
Costs costsAtFirst();

}  // namespace deflate
