// Deflate costs.
#include "image/deflate_costs.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "math/functions.h"

namespace deflate {

namespace {

template <std::size_t N>
constexpr std::array<std::uint8_t, kLongestCopy + 1> makeLengthTable(const Range (&ranges)[N]) {
  std::array<std::uint8_t, kLongestCopy + 1> table = {};
  for (unsigned length = kShortestCopy, range = 0; length <= kLongestCopy; ++length) {
    while (range + 1 < N && ranges[range + 1].base <= length) ++range;
    table[length] = static_cast<std::uint8_t>(range);
  }
  return table;
}

/// -log2(counts[i] / sum), in units of 1 / Costs::kBit. A count of 0 is taken for 1 / 4.
template <std::size_t N>
std::array<std::uint32_t, N> informationOf(const std::array<std::uint32_t, N>& counts) {
  const double sum = std::max(1.0, std::accumulate(counts.begin(), counts.end(), 0.0));
  const double unit = Costs::kBit / math::log(2);
  std::array<std::uint32_t, N> costs;
  for (std::size_t i = 0; i < N; ++i) {
    const double count = counts[i] == 0 ? 0.25 : counts[i];
    costs[i] = static_cast<std::uint32_t>(std::max(0.0, unit * math::log(sum / count)));
  }
  return costs;
}

}  // namespace

unsigned lengthRange(unsigned length) {
  static constexpr auto kTable = makeLengthTable(kLengths);
  return kTable[length];
}

unsigned distanceRange(unsigned distance) {
  const unsigned d = distance - 1;
  if (d < 4) return d;
  unsigned high = 2;  // the place of d's highest bit
  while (d >> (high + 1) != 0) ++high;
  return 2 * high + (d >> (high - 1) & 1);
}

void SymbolCounts::add(Token token) {
  if (isLiteral(token)) {
    ++literals[token.length];
  } else {
    ++literals[kEndOfBlock + 1 + lengthRange(token.length)];
    ++distances[distanceRange(token.distance)];
  }
}

SymbolCounts SymbolCounts::of(const std::vector<Token>& tokens, std::size_t first,
                              std::size_t last) {
  SymbolCounts counts;
  counts.literals[kEndOfBlock] = 1;
  for (std::size_t i = first; i < last; ++i) counts.add(tokens[i]);
  return counts;
}

Costs::Costs(const SymbolCounts& counts) {
  const auto literals = informationOf(counts.literals);
  std::copy_n(literals.begin(), literal.size(), literal.begin());
  length.fill(0);
  for (unsigned each = kShortestCopy; each <= kLongestCopy; ++each) {
    const unsigned range = lengthRange(each);
    length[each] = literals[kEndOfBlock + 1 + range] + kBit * kLengths[range].bits;
  }
  distance = informationOf(counts.distances);
  for (unsigned range = 0; range < kDistanceSymbols; ++range) {
    distance[range] += kBit * kDistances[range].bits;
  }
}

}  // namespace deflate
