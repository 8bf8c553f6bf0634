// Deflate: checksums, codes of least length, and that what is written is read back.
#include "image/deflate.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "check.h"
#include "image/block_writer.h"
#include "image/checksum.h"
#include "image/inflate.h"
#include "image/prefix_lengths.h"
#include "random.h"

namespace {

Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

std::uint64_t costOf(const std::vector<std::uint32_t>& counts,
                     const std::vector<std::uint8_t>& lengths) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) sum += std::uint64_t{counts[i]} * lengths[i];
  return sum;
}

/// The least cost of all lengths 1..longest that fulfil Kraft's inequality (sum of 2^-length at
/// most 1), each of which some prefix code has.
std::uint64_t leastByTrial(const std::vector<std::uint32_t>& counts, unsigned longest) {
  std::uint64_t least = ~std::uint64_t{0};
  const std::function<void(std::size_t, unsigned, std::uint64_t)> next =
      [&](std::size_t i, unsigned room, std::uint64_t cost) {
        if (i == counts.size()) {
          least = std::min(least, cost);
          return;
        }
        for (unsigned length = 1; length <= longest; ++length) {
          const unsigned share = 1u << (longest - length);
          if (share <= room) next(i + 1, room - share, cost + std::uint64_t{counts[i]} * length);
        }
      };
  next(0, 1u << longest, 0);
  return least;
}

Bytes inflated(const Bytes& packed) { return inflateZlib(packed, std::size_t{1} << 26); }

}  // namespace

TEST("checksums of known texts") {
  const Bytes digits = bytesOf("123456789");
  // The check value of CRC-32 (Cook, Catalogue of parametrised CRC algorithms, "CRC-32/ISO-HDLC").
  CHECK_EQUAL(crc32(digits.data(), digits.size()), 0xCBF43926u);
  CHECK_EQUAL(crc32(nullptr, 0), 0u);
  // Sums by hand: 1 + 49 + ... + 57 = 478 = 0x1DE; the partial sums add up to 2334 = 0x91E.
  CHECK_EQUAL(adler32(digits.data(), digits.size()), 0x091E01DEu);
  CHECK_EQUAL(adler32(digits.data() + 4, 5, adler32(digits.data(), 4)), 0x091E01DEu);
  CHECK_EQUAL(adler32(nullptr, 0), 1u);
}

TEST("code lengths cost as little as any that fit, for small alphabets and tight bounds") {
  Random random(11);
  for (int round = 0; round < 300; ++round) {
    const auto symbols = std::size_t(2 + random.index(5));
    const unsigned fewest = symbols <= 2 ? 1 : symbols <= 4 ? 2 : 3;
    const unsigned longest = fewest + unsigned(random.index(3));
    std::vector<std::uint32_t> counts(symbols);
    for (std::uint32_t& count : counts) {
      count = std::uint32_t(1 + random.logUniform(1, round % 2 == 0 ? 10 : 1e6));
    }
    std::vector<std::uint8_t> lengths(symbols, 99);
    findPrefixLengths(counts.data(), symbols, longest, lengths.data());
    CHECK(*std::max_element(lengths.begin(), lengths.end()) <= longest);
    CHECK_EQUAL(costOf(counts, lengths), leastByTrial(counts, longest));
  }
}

TEST("code lengths of counts that grow like Fibonacci's numbers keep to their bound") {
  // Without a bound the longest of n such codes has n - 1 bits.
  std::vector<std::uint32_t> counts = {1, 1};
  while (counts.size() < 40)
    counts.push_back(counts[counts.size() - 1] + counts[counts.size() - 2]);
  std::vector<std::uint8_t> lengths(counts.size());
  findPrefixLengths(counts.data(), counts.size(), 15, lengths.data());
  double kraft = 0;
  for (const std::uint8_t length : lengths) {
    CHECK(length >= 1 && length <= 15);
    kraft += std::ldexp(1.0, -length);
  }
  CHECK_EQUAL(kraft, 1.0);  // nothing is left over
}

TEST("one symbol gets one bit, and none gets none") {
  const std::uint32_t one[] = {0, 7, 0}, none[] = {0, 0, 0};
  std::uint8_t lengths[3];
  findPrefixLengths(one, 3, 15, lengths);
  CHECK_EQUAL(int(lengths[0]) * 100 + lengths[1] * 10 + lengths[2], 10);
  findPrefixLengths(none, 3, 15, lengths);
  CHECK_EQUAL(int(lengths[0]) + lengths[1] + lengths[2], 0);
}

TEST("lengths and distances fall into the ranges of the tables") {
  using namespace deflate;
  for (unsigned length = kShortestCopy; length <= kLongestCopy; ++length) {
    const unsigned range = lengthRange(length);
    // 258 has a symbol of its own, although the range before could say it too.
    CHECK(kLengths[range].base <= length && (range == 28 || length < kLengths[range + 1].base));
  }
  for (unsigned distance = 1; distance <= kWindow; ++distance) {
    const unsigned range = distanceRange(distance);
    const bool fits = kDistances[range].base <= distance &&
                      distance < kDistances[range].base + (1u << kDistances[range].bits);
    if (!fits) CHECK_EQUAL(distance, 0u);
  }
}

TEST("what is compressed is read back, whatever it is") {
  Random random(12);
  for (int round = 0; round < 60; ++round) {
    const auto size = std::size_t(random.logUniform(1, 60000)) - 1;
    const int alphabet = 1 + random.index(round % 3 == 0 ? 256 : 4);
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) {
      // Every other stretch of 100 repeats what stood up to 40000 bytes before.
      const auto back = std::size_t(1 + (i / 100 * 7919) % 40000);
      bytes[i] =
          i / 100 % 2 == 1 && back <= i ? bytes[i - back] : std::uint8_t(random.index(alphabet));
    }
    const Bytes packed = deflateZlib(bytes);
    if (inflated(packed) != bytes) CHECK_EQUAL("round " + std::to_string(round), "equal bytes");
    CHECK(packed.size() <= size + size / 1000 + 20);  // at worst stored: 5 bytes for each 65535
  }
}

TEST("a stream written in stretches is one stream, and copies reach over their borders") {
  Random random(13);
  Bytes part(1000);
  for (std::uint8_t& byte : part) byte = std::uint8_t(random.index(256));
  DeflateWriter writer(64, 1);
  Bytes all, packed;
  for (int i = 0; i < 5; ++i) {
    const std::size_t from = all.size();
    all.insert(all.end(), part.begin(), part.end());
    writer.append(all, from);
    const Bytes piece = writer.take();
    packed.insert(packed.end(), piece.begin(), piece.end());
  }
  writer.finish();
  const Bytes last = writer.take();
  packed.insert(packed.end(), last.begin(), last.end());
  CHECK(inflated(packed) == all);
  CHECK(packed.size() < 1300);  // noise once, and four copies of it
}

TEST("long runs cost next to nothing, and noise no more than itself") {
  // Two bits for 258 bytes at best: 1 MB in 1 kB, and the heads of blocks.
  CHECK(deflateZlib(Bytes(1 << 20)).size() < 1200);
  CHECK(inflated(deflateZlib(Bytes(1 << 20))) == Bytes(1 << 20));
  CHECK(inflated(deflateZlib({})).empty());
}
