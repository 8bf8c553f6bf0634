// CopyTree and TokenTrial: against a search of all places.
#include "image/copy_tree.h"

#include <algorithm>

#include "check.h"
#include "image/deflate_tables.h"
#include "image/token_trial.h"
#include "random.h"

namespace {

using deflate::kLongestCopy;
using deflate::kShortestCopy;
using deflate::kWindow;

/// By looking at every place of the window but the farthest, the nearest first.
std::vector<Copy> copiesBySearch(const Bytes& bytes, std::size_t at) {
  std::vector<Copy> copies;
  const std::size_t most = std::min<std::size_t>(bytes.size() - at, kLongestCopy);
  std::size_t longest = kShortestCopy - 1;
  for (std::size_t distance = 1; distance <= at && distance < kWindow; ++distance) {
    std::size_t length = 0;
    while (length < most && bytes[at + length] == bytes[at + length - distance]) ++length;
    if (length <= longest) continue;
    longest = length;
    copies.push_back({std::uint16_t(length), std::uint16_t(distance)});
  }
  return copies;
}

bool isEqual(Copy a, Copy b) { return a.length == b.length && a.distance == b.distance; }

Bytes randomBytes(std::size_t size, int alphabet, Random& random) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t back = 1 + i / 60 * 7919 % 3000;  // every other 60 bytes repeat others
    bytes[i] =
        i / 60 % 2 == 1 && back <= i ? bytes[i - back] : std::uint8_t(random.index(alphabet));
  }
  return bytes;
}

}  // namespace

TEST("for every length the nearest copy is found") {
  Random random(31);
  for (const int alphabet : {1, 2, 3, 20, 256}) {
    const Bytes bytes = randomBytes(3000, alphabet, random);
    CopyTree tree(bytes.data(), bytes.size(), 100000);
    std::size_t differences = 0, found = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      std::vector<Copy> copies;
      tree.findAndAdd(at, copies);
      const std::vector<Copy> expected = copiesBySearch(bytes, at);
      found += copies.size();
      differences +=
          !std::equal(copies.begin(), copies.end(), expected.begin(), expected.end(), isEqual);
    }
    check::report(differences == 0 && found > 100, __FILE__, __LINE__,
                  "alphabet " + std::to_string(alphabet) + ": " + std::to_string(differences) +
                      " places differ, " + std::to_string(found) + " copies");
  }
}

TEST("copies reach back a window less one, and no further") {
  for (const std::size_t distance : {kWindow - 1, kWindow, 2 * kWindow}) {
    Bytes bytes(distance + 4);  // four bytes that are seen twice, and zeros between
    for (std::size_t i = 0; i < 4; ++i) bytes[i] = bytes[distance + i] = std::uint8_t(i + 1);
    CopyTree tree(bytes.data(), bytes.size(), 100);
    std::vector<Copy> copies;
    for (std::size_t at = 0; at <= distance; ++at) {
      copies.clear();
      tree.findAndAdd(at, copies);
    }
    CHECK_EQUAL(copies.size(), std::size_t{distance < kWindow});
    if (!copies.empty()) CHECK(isEqual(copies[0], {4, std::uint16_t(distance)}));
  }
}

TEST("a trial stands for all bytes and leaves no trace") {
  Random random(32);
  for (const int alphabet : {1, 3, 256}) {
    const Bytes bytes = randomBytes(2000, alphabet, random);
    const deflate::Costs costs = deflate::costsAtFirst();
    deflate::TokenTrial trial(bytes, 8);
    trial.passTo(1000);
    const deflate::SymbolCounts first = trial.tryTo(2000, costs), again = trial.tryTo(2000, costs);
    CHECK(first.literals == again.literals && first.distances == again.distances);
    // What is said in literals alone is an upper bound; equal costs make 1000 times the same.
    CHECK(costs.of(first) <= 1000 * std::uint64_t{costs.literal[0]});
    std::size_t copies = 0, distances = 0;
    for (std::size_t i = deflate::kEndOfBlock + 1; i < first.literals.size(); ++i) {
      copies += first.literals[i];
    }
    for (const std::uint32_t count : first.distances) distances += count;
    CHECK(copies > 0 && copies == distances);
    CHECK_EQUAL(first.literals[deflate::kEndOfBlock], 0u);
  }
}
