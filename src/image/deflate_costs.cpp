// Deflate costs.
#include "image/deflate_costs.h"

#include <algorithm>
#include <functional>
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

/// Two ranges for every power of two: those of 128 times as far come 14 ranges later.
constexpr unsigned kNearDistances = 256, kRangesFurther = 14;

constexpr std::array<std::uint8_t, kNearDistances> makeDistanceTable() {
  std::array<std::uint8_t, kNearDistances> table = {};
  for (unsigned d = 0, range = 0; d < kNearDistances; ++d) {
    while (kDistances[range + 1].base <= d + 1) ++range;
    table[d] = static_cast<std::uint8_t>(range);
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
  static constexpr auto kTable = makeDistanceTable();
  const unsigned d = distance - 1;
  return d < kNearDistances ? kTable[d] : kTable[d / (kNearDistances / 2)] + kRangesFurther;
}

void SymbolCounts::add(Token token) {
  if (isLiteral(token)) {
    ++literals[token.length];
  } else {
    ++literals[kEndOfBlock + 1 + lengthRange(token.length)];
    ++distances[distanceRange(token.distance)];
  }
}

SymbolCounts SymbolCounts::without(const SymbolCounts& part) const {
  SymbolCounts rest;
  const auto minus = std::minus<std::uint32_t>();
  std::transform(literals.begin(), literals.end(), part.literals.begin(), rest.literals.begin(),
                 minus);
  std::transform(distances.begin(), distances.end(), part.distances.begin(), rest.distances.begin(),
                 minus);
  rest.literals[kEndOfBlock] = 1;
  return rest;
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

std::uint64_t Costs::of(const SymbolCounts& counts) const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < literal.size(); ++i) {
    sum += std::uint64_t{counts.literals[i]} * literal[i];
  }
  for (std::size_t i = 0; i < std::size(kLengths); ++i) {
    sum += std::uint64_t{counts.literals[kEndOfBlock + 1 + i]} * length[kLengths[i].base];
  }
  for (std::size_t i = 0; i < distance.size(); ++i) {
    sum += std::uint64_t{counts.distances[i]} * distance[i];
  }
  return sum;
}

Costs costsAtFirst() {
  SymbolCounts counts;
  counts.literals.fill(1);
  counts.distances.fill(1);
  return Costs(counts);
}

}  // namespace deflate
