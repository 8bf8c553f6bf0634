// The cheapest tokens: the shortest path from each place to the end, from the last place back.
#include "image/cheapest_tokens.h"

#include <algorithm>
#include <cassert>

#include "image/copy_tree.h"

namespace deflate {

namespace {

struct Path {
  std::uint32_t cost;  // from here to the end
  Token first;
};

/// Where copies reach as far as this, shorter ones are no use: it keeps flat pictures quick.
constexpr unsigned kLongEnough = 80;

void useCopies(const CopyLists& lists, const Costs& costs, std::size_t at,
               std::vector<Path>& paths) {
  unsigned length = kShortestCopy;
  const Copy *copy = lists.begin(at), *const end = lists.end(at);
  if (copy != end && (end - 1)->length >= kLongEnough) {
    copy = end - 1;
    length = copy->length;
  }
  Path best = paths[at];
  for (; copy != end; ++copy) {
    const std::uint32_t distance = costs.distance[distanceRange(copy->distance)];
    for (; length <= copy->length; ++length) {
      const std::uint32_t cost = paths[at + length].cost + costs.length[length] + distance;
      if (cost < best.cost) best = {cost, {static_cast<std::uint16_t>(length), copy->distance}};
    }
  }
  paths[at] = best;
}

std::vector<Path> cheapestPaths(const std::uint8_t* bytes, const CopyLists& lists,
                                const std::vector<CostsFrom>& parts) {
  std::vector<Path> paths(lists.size() + 1);
  std::size_t at = lists.size();
  for (std::size_t part = parts.size(); part-- > 0;) {
    const Costs& costs = parts[part].costs;
    while (at > parts[part].place) {
      --at;
      paths[at] = {paths[at + 1].cost + costs.literal[bytes[at]], {bytes[at], 0}};
      useCopies(lists, costs, at, paths);
    }
  }
  return paths;
}

}  // namespace

CopyLists::CopyLists(const std::uint8_t* bytes, std::size_t from, std::size_t to, unsigned depth) {
  CopyTree tree(bytes, to, depth);
  for (std::size_t at = from - std::min<std::size_t>(from, kWindow); at < from; ++at) {
    tree.findAndAdd(at, copies_);
    copies_.clear();
  }
  first_.reserve(to - from + 1);
  first_.push_back(0);
  for (std::size_t at = from; at < to; ++at) {
    tree.findAndAdd(at, copies_);
    first_.push_back(static_cast<std::uint32_t>(copies_.size()));
  }
}

std::vector<Token> cheapestTokens(const std::uint8_t* bytes, const CopyLists& lists,
                                  const std::vector<CostsFrom>& costs) {
  assert(lists.size() <= kLongestStretch);
  const std::vector<Path> paths = cheapestPaths(bytes, lists, costs);
  std::vector<Token> tokens;
  for (std::size_t at = 0; at < lists.size();) {
    tokens.push_back(paths[at].first);
    at += isLiteral(tokens.back()) ? 1 : tokens.back().length;
  }
  return tokens;
}

}  // namespace deflate
