// HashChains: against a search of all places.
#include <algorithm>

#include "check.h"
#include "image/deflate.h"
#include "random.h"

namespace {

using deflate::HashChains;
using deflate::kLongestCopy;
using deflate::kWindow;
using deflate::Token;

constexpr unsigned kShortest = 4;  // shorter ones are not looked for
constexpr unsigned kEndless = 1000000;

/// By looking at every place of the window, the nearest first.
Token matchBySearch(const Bytes& bytes, std::size_t at) {
  Token match;
  const std::size_t most = std::min<std::size_t>(bytes.size() - at, kLongestCopy);
  std::size_t longest = kShortest - 1;
  for (std::size_t distance = 1; distance <= std::min<std::size_t>(at, kWindow); ++distance) {
    std::size_t length = 0;
    while (length < most && bytes[at + length] == bytes[at + length - distance]) ++length;
    if (length <= longest) continue;
    longest = length;
    match = {unsigned(length), unsigned(distance)};
  }
  return match;
}

bool isEqual(Token a, Token b) { return a.length == b.length && a.distance == b.distance; }

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

TEST("a hash chain finds the nearest of the longest matches") {
  Random random(31);
  for (const int alphabet : {1, 2, 3, 20, 256}) {
    const Bytes bytes = randomBytes(3000, alphabet, random);
    HashChains chains(bytes.data(), bytes.size());
    std::size_t differences = 0, found = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      const Token match = chains.longest(at, 0, kEndless), expected = matchBySearch(bytes, at);
      found += match.length > 0;
      differences += !isEqual(match, expected);
      // One that must be longer than it is, is not found; one that may be as long is the same.
      if (expected.length > 0) {
        differences += chains.longest(at, expected.length, kEndless).length != 0;
        differences += !isEqual(chains.longest(at, expected.length - 1, kEndless), expected);
      }
      chains.add(at);
    }
    check::report(differences == 0 && found > 100, __FILE__, __LINE__,
                  "alphabet " + std::to_string(alphabet) + ": " + std::to_string(differences) +
                      " places differ, " + std::to_string(found) + " matches");
  }
}

TEST("matches reach back a window, and no further") {
  for (const std::size_t distance : {kWindow - 1, kWindow, kWindow + 1, 2 * kWindow}) {
    Bytes bytes(distance + 4);  // four bytes that are seen twice, and zeros between
    for (std::size_t i = 0; i < 4; ++i) bytes[i] = bytes[distance + i] = std::uint8_t(i + 1);
    HashChains chains(bytes.data(), bytes.size());
    for (std::size_t at = 0; at < distance; ++at) chains.add(at);
    const Token match = chains.longest(distance, 0, kEndless);
    CHECK(isEqual(match, distance <= kWindow ? Token{4, unsigned(distance)} : Token{}));
  }
}

TEST("as many places are looked at as tries are given") {
  const std::string text = "abcdeX abcdY abcdZ abcde";
  const Bytes bytes(text.begin(), text.end());
  HashChains chains(bytes.data(), bytes.size());
  for (std::size_t at = 0; at < 19; ++at) chains.add(at);
  CHECK(isEqual(chains.longest(19, 0, 1), {4, 6}));   // of abcdZ
  CHECK(isEqual(chains.longest(19, 0, 2), {4, 6}));   // of two as long, the nearer
  CHECK(isEqual(chains.longest(19, 0, 3), {5, 19}));  // of abcdeX
  CHECK(isEqual(chains.longest(19, 4, 3), {5, 19}));
  CHECK(isEqual(chains.longest(19, 4, 2), {0, 0}));
  CHECK(isEqual(chains.longest(19, 0, 0), {0, 0}));
}
