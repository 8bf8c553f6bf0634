// Deflate: which bytes are said as copies of earlier ones, and the checksum of zlib.
// The bytes are walked through once. At each place the longest stretch that stood before is looked
// for: every place is entered into a chain of those whose next four bytes have the same hash, and
// the chain of the place at hand is followed back from the nearest one, kTries links at most.
// A match is not taken at once (lazy matching: Gailly and Adler, zlib, 1995): if the place one byte
// further on has a longer one, a literal is said instead, and so on from there.
// Tokens are cut into blocks by their number alone, so that each block has codes of its own.
#include "image/deflate.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace deflate {

namespace {

constexpr unsigned kHashed = 4;  // bytes; copies of 3 save too little to look for them
constexpr unsigned kHashBits = 15;
constexpr std::uint32_t kNoPlace = 0xFFFFFFFF;

// Measured with the pictures of the scenes: twice these three make files that are 2 % smaller, in
// 1.6 times the time; half of them 2 % larger ones in 0.85 of it.
constexpr unsigned kTries = 16;
constexpr unsigned kGoodLength = 8;   // a match that is worth a quarter of the tries to beat it
constexpr unsigned kBestLength = 32;  // and one that nothing is tried to beat
constexpr std::size_t kBlockTokens = 16384;

/// The next tokens for bytes[at..to), about kBlockTokens of them. `at` goes on behind what they
/// stand for; the places that it passes are added to the chains, so that these hold all before it.
std::vector<Token> takeTokens(const std::uint8_t* bytes, std::size_t& at, std::size_t to,
                              HashChains& chains) {
  std::vector<Token> tokens;
  while (at < to && tokens.size() < kBlockTokens) {
    Token match = chains.longest(at, 0, kTries);
    chains.add(at);
    while (match.length > 0 && match.length < kBestLength) {
      const unsigned tries = match.length < kGoodLength ? kTries : kTries / 4;
      const Token later = chains.longest(at + 1, match.length, tries);
      if (later.length == 0) break;
      tokens.push_back({bytes[at], 0});
      chains.add(++at);
      match = later;
    }
    const bool isFound = match.length > 0;
    tokens.push_back(isFound ? match : Token{bytes[at], 0});
    for (const std::size_t next = at + (isFound ? match.length : 1); ++at < next;) chains.add(at);
  }
  return tokens;
}

}  // namespace

HashChains::HashChains(const std::uint8_t* bytes, std::size_t size)
    : bytes_(bytes), size_(size), last_(1 << kHashBits, kNoPlace), previous_(kWindow) {
  assert(size < kNoPlace);
}

/// Multiplied by a number without a pattern, the highest bits depend on all four bytes (Knuth, The
/// Art of Computer Programming, volume 3, 6.4). The order of the bytes is the same on every
/// processor, since chains, and with them what is found in few tries, depend on the hash.
std::size_t HashChains::hashAt(std::size_t at) const {
  return littleEndian32(bytes_ + at) * 2654435761u >> (32 - kHashBits);
}

void HashChains::add(std::size_t at) {
  if (size_ - at < kHashed) return;
  std::uint32_t& last = last_[hashAt(at)];
  previous_[at % kWindow] = last;
  last = static_cast<std::uint32_t>(at);
}

/// How many bytes from `place` and from `at` on agree, kLongestCopy at most.
std::size_t HashChains::matchingBytes(std::size_t place, std::size_t at) const {
  const std::size_t most = std::min<std::size_t>(size_ - at, kLongestCopy);
  const std::uint8_t *const a = bytes_ + place, *const b = bytes_ + at;
  std::size_t length = 0;
  while (length + 8 <= most && std::memcmp(a + length, b + length, 8) == 0) length += 8;
  while (length < most && a[length] == b[length]) ++length;
  return length;
}

Token HashChains::longest(std::size_t at, unsigned longerThan, unsigned tries) const {
  Token best;
  std::size_t longest = std::max(longerThan, kHashed - 1);
  if (at + longest >= size_ || longest >= kLongestCopy) return best;
  std::uint32_t place = last_[hashAt(at)];
  for (; tries > 0 && place != kNoPlace && at - place <= kWindow; --tries) {
    // What is to be longer agrees in the byte where the longest one ended.
    if (bytes_[place + longest] == bytes_[at + longest]) {
      const std::size_t length = matchingBytes(place, at);
      if (length > longest) {
        longest = length;
        best = {static_cast<unsigned>(length), static_cast<unsigned>(at - place)};
        if (at + longest == size_ || longest == kLongestCopy) break;
      }
    }
    place = previous_[place % kWindow];
  }
  return best;
}

}  // namespace deflate

Bytes deflatePiece(const Bytes& bytes, std::size_t from, std::size_t to, bool isLast) {
  const std::size_t window = std::min<std::size_t>(from, deflate::kWindow);
  const std::uint8_t* const first = bytes.data() + from - window;
  const std::size_t end = window + to - from;
  deflate::HashChains chains(first, end);
  for (std::size_t place = 0; place < window; ++place) chains.add(place);
  deflate::BlockWriter writer;
  std::size_t at = window;
  do {  // of no bytes there is a block too
    const std::size_t begin = at;
    const std::vector<deflate::Token> tokens = deflate::takeTokens(first, at, end, chains);
    writer.write(tokens, first + begin, at - begin, isLast && at == end);
  } while (at < end);
  // An empty stored block fills the last byte (as pigz does: Adler, 2007).
  if (!isLast) writer.writeStored(nullptr, 0, false);
  return writer.take();
}

std::uint32_t adler32(const std::uint8_t* bytes, std::size_t size, std::uint32_t before) {
  constexpr std::uint32_t kPrime = 65521;  // the largest below 2^16
  constexpr std::size_t kStep = 5552;      // so many bytes keep both sums below 2^32
  std::uint32_t sum = before & 0xFFFF, sumOfSums = before >> 16;
  for (const std::uint8_t* const end = bytes + size; bytes != end;) {
    const std::uint8_t* const stop = bytes + std::min<std::size_t>(kStep, std::size_t(end - bytes));
    while (bytes != stop) sumOfSums += sum += *bytes++;
    sum %= kPrime;
    sumOfSums %= kPrime;
  }
  return sumOfSums << 16 | sum;
}
