// The cheapest tokens: the shortest path from each place to the end, from the last place back.
#include "image/cheapest_tokens.h"

namespace deflate {

namespace {

struct Path {
  std::uint64_t cost;  // from here to the end
  Token first;
};

/// Where the longest copies reach, shorter ones are no use: it keeps flat pictures quick.
constexpr unsigned kLongEnough = kLongestCopy;

void useCopies(const CopyLists& lists, const Costs& costs, std::size_t at,
               std::vector<Path>& paths) {
  unsigned length = kShortestCopy;
  const Copy *copy = lists.begin(at), *const end = lists.end(at);
  if (copy != end && (end - 1)->length >= kLongEnough) {
    copy = end - 1;
    length = copy->length;
  }
  for (; copy != end; ++copy) {
    const std::uint32_t distance = costs.distance[distanceRange(copy->distance)];
    for (; length <= copy->length; ++length) {
      const std::uint64_t cost = paths[at + length].cost + costs.length[length] + distance;
      if (cost < paths[at].cost) {
        paths[at] = {cost, {static_cast<std::uint16_t>(length), copy->distance}};
      }
    }
  }
}

std::vector<Path> cheapestPaths(const std::uint8_t* bytes, const CopyLists& lists,
                                const Costs& costs) {
  std::vector<Path> paths(lists.size() + 1);
  for (std::size_t at = lists.size(); at-- > 0;) {
    paths[at] = {paths[at + 1].cost + costs.literal[bytes[at]], {bytes[at], 0}};
    useCopies(lists, costs, at, paths);
  }
  return paths;
}

}  // namespace

void CopyLists::collect(CopyFinder& finder, std::size_t from, std::size_t to) {
  first_.assign(1, 0);
  copies_.clear();
  for (std::size_t at = from; at < to; ++at) {
    finder.find(at, to, copies_);
    finder.add(at);
    first_.push_back(copies_.size());
  }
}

std::vector<Token> cheapestTokens(const std::uint8_t* bytes, const CopyLists& lists,
                                  const Costs& costs) {
  const std::vector<Path> paths = cheapestPaths(bytes, lists, costs);
  std::vector<Token> tokens;
  for (std::size_t at = 0; at < lists.size();) {
    tokens.push_back(paths[at].first);
    at += isLiteral(tokens.back()) ? 1 : tokens.back().length;
  }
  return tokens;
}

std::uint64_t leastCost(const std::uint8_t* bytes, const CopyLists& lists, const Costs& costs) {
  return cheapestPaths(bytes, lists, costs)[0].cost;
}

}  // namespace deflate
