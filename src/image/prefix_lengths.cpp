// Package-merge.
#include "image/prefix_lengths.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace {

/// A symbol, or a package of two items of the list below.
struct Item {
  std::uint64_t weight;
  int symbol;  // -1: a package
};

using Row = std::vector<Item>;

/// The symbols that occur, the rarest first; among equals the order of the symbols decides.
Row sortedSymbols(const std::uint32_t* counts, std::size_t symbols) {
  Row row;
  for (std::size_t i = 0; i < symbols; ++i) {
    if (counts[i] > 0) row.push_back({counts[i], static_cast<int>(i)});
  }
  std::stable_sort(row.begin(), row.end(),
                   [](const Item& a, const Item& b) { return a.weight < b.weight; });
  return row;
}

/// Neighbours of `row` in pairs, merged with the symbols; a last item without partner is dropped.
Row packaged(const Row& row, const Row& symbols) {
  Row packages;
  for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
    packages.push_back({row[i].weight + row[i + 1].weight, -1});
  }
  Row merged(packages.size() + symbols.size());
  std::merge(symbols.begin(), symbols.end(), packages.begin(), packages.end(), merged.begin(),
             [](const Item& a, const Item& b) { return a.weight < b.weight; });
  return merged;
}

}  // namespace

void findPrefixLengths(const std::uint32_t* counts, std::size_t symbols, unsigned longest,
                       std::uint8_t* lengths) {
  std::fill_n(lengths, symbols, std::uint8_t{0});
  const Row leaves = sortedSymbols(counts, symbols);
  if (leaves.empty()) return;
  if (leaves.size() == 1) {
    lengths[leaves[0].symbol] = 1;
    return;
  }
  assert(leaves.size() <= std::size_t{1} << longest);
  std::vector<Row> rows = {leaves};
  while (rows.size() < longest) rows.push_back(packaged(rows.back(), leaves));
  // The first 2n - 2 items of the last row are chosen; a chosen package chooses the two first
  // items not yet taken of the row before. A symbol's length is the number of times it is chosen.
  std::size_t chosen = 2 * leaves.size() - 2;
  for (std::size_t row = rows.size(); row-- > 0;) {
    std::size_t packages = 0;
    for (std::size_t i = 0; i < chosen; ++i) {
      const int symbol = rows[row][i].symbol;
      if (symbol >= 0) ++lengths[symbol];
      packages += symbol < 0;
    }
    chosen = 2 * packages;
  }
}
