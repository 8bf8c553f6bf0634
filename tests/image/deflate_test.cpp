// Deflate: checksums, codes of least length, and that what is written is read back.
#include "image/deflate.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "check.h"
#include "encoded.h"
#include "image/png_format.h"
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
  CHECK_EQUAL(png::crc32(digits.data(), digits.size()), 0xCBF43926u);
  CHECK_EQUAL(png::crc32(nullptr, 0), 0u);
  // Sums by hand: 1 + 49 + ... + 57 = 478 = 0x1DE; the partial sums add up to 2334 = 0x91E.
  CHECK_EQUAL(adler32(digits.data(), digits.size()), 0x091E01DEu);
  CHECK_EQUAL(adler32(digits.data() + 4, 5, adler32(digits.data(), 4)), 0x091E01DEu);
  CHECK_EQUAL(adler32(nullptr, 0), 1u);
  // Of the largest bytes, whose sums grow fastest: with the remainders taken at every step.
  const Bytes large(20000, 255);
  std::uint32_t sum = 1, sumOfSums = 0;
  for (const std::uint8_t byte : large) {
    sum = (sum + byte) % 65521;
    sumOfSums = (sumOfSums + sum) % 65521;
  }
  CHECK_EQUAL(adler32(large.data(), large.size()), sumOfSums << 16 | sum);
}

TEST("code lengths cost as little as any that fit, for small alphabets") {
  Random random(11);
  for (int round = 0; round < 300; ++round) {
    const auto symbols = std::size_t(2 + random.index(5));
    const unsigned longest = unsigned(symbols) - 1;  // no code of so few symbols needs more
    std::vector<std::uint32_t> counts(symbols);
    for (std::uint32_t& count : counts) {
      count = std::uint32_t(1 + random.logUniform(1, round % 2 == 0 ? 10 : 1e6));
    }
    const std::vector<std::uint8_t> lengths = deflate::codeLengths(counts, longest);
    CHECK(*std::max_element(lengths.begin(), lengths.end()) <= longest);
    CHECK_EQUAL(costOf(counts, lengths), leastByTrial(counts, longest));
  }
}

TEST("code lengths keep to their bound and leave nothing over, whatever the counts") {
  // Fibonacci's numbers: without a bound the longest of n such codes has n - 1 bits.
  std::vector<std::uint32_t> counts = {1, 1};
  while (counts.size() < 40) {
    counts.push_back(counts[counts.size() - 1] + counts[counts.size() - 2]);
  }
  Random random(14);
  for (int round = 0; round < 300; ++round) {
    const unsigned longest = round % 3 == 0 ? 7 : 15;
    const std::vector<std::uint8_t> lengths = deflate::codeLengths(counts, longest);
    double kraft = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      CHECK_EQUAL(lengths[i] > 0, counts[i] > 0);
      CHECK(lengths[i] <= longest);
      if (lengths[i] > 0) kraft += std::ldexp(1.0, -lengths[i]);
    }
    CHECK_EQUAL(kraft, 1.0);
    counts.assign(std::size_t(2 + random.index(round % 3 == 2 ? 100 : 285)), 0);
    for (std::uint32_t& count : counts) {
      if (random.index(4) > 0) count = std::uint32_t(random.logUniform(1, 1e9));
    }
    counts[0] = counts[1] = 1;  // at least two occur
  }
}

TEST("one symbol gets one bit, and none gets none") {
  using Lengths = std::vector<std::uint8_t>;
  CHECK((deflate::codeLengths({0, 7, 0}, 15) == Lengths{0, 1, 0}));
  CHECK((deflate::codeLengths({0, 0, 0}, 15) == Lengths{0, 0, 0}));
}

TEST("codes of one length are numbered in the order of their symbols, and turned round") {
  // The example of RFC 1951, 3.2.2: A to H of 3, 3, 3, 3, 3, 2, 4 and 4 bits are 010, 011, 100,
  // 101, 110, 00, 1110 and 1111.
  const std::vector<deflate::Bits> code = deflate::codeOf({3, 3, 3, 3, 3, 2, 4, 4});
  const unsigned expected[] = {2, 6, 1, 5, 3, 0, 7, 15};  // the first bit is the lowest here
  for (std::size_t i = 0; i < 8; ++i) CHECK_EQUAL(code[i].value, expected[i]);
  CHECK_EQUAL(deflate::codeOf({0, 1})[0].count, 0u);
}

TEST("lengths and distances fall into the ranges of RFC 1951, 3.2.5") {
  using namespace deflate;
  std::size_t misfits = 0;
  for (unsigned length = 3; length <= kLongestCopy; ++length) {
    const Range range = kLengthRanges[indexOfRange(length, kLengthRanges)];
    misfits += length < range.base || length >= range.base + (1u << range.bits);
  }
  for (unsigned distance = 1; distance <= kWindow; ++distance) {
    const Range range = kDistanceRanges[indexOfRange(distance, kDistanceRanges)];
    misfits += distance < range.base || distance >= range.base + (1u << range.bits);
  }
  CHECK_EQUAL(misfits, 0u);
  // Some of the RFC's entries: symbol, first length or distance, further bits.
  const unsigned lengths[][3] = {{257, 3, 0},   {264, 10, 0},  {265, 11, 1},
                                 {268, 17, 1},  {269, 19, 2},  {277, 67, 4},
                                 {281, 131, 5}, {284, 227, 5}, {285, 258, 0}};
  for (const auto& row : lengths) {
    const Range range = kLengthRanges[row[0] - 257];
    CHECK(range.base == row[1] && range.bits == row[2]);
    CHECK_EQUAL(indexOfRange(row[1], kLengthRanges), row[0] - 257);
  }
  const unsigned distances[][3] = {{0, 1, 0},    {3, 4, 0},      {4, 5, 1},       {7, 13, 2},
                                   {16, 257, 7}, {23, 3073, 10}, {28, 16385, 13}, {29, 24577, 13}};
  for (const auto& row : distances) {
    const Range range = kDistanceRanges[row[0]];
    CHECK(range.base == row[1] && range.bits == row[2]);
    CHECK_EQUAL(indexOfRange(row[1], kDistanceRanges), row[0]);
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
    const Bytes packed = encoded::zlib(bytes);
    if (inflated(packed) != bytes) CHECK_EQUAL("round " + std::to_string(round), "equal bytes");
    CHECK(packed.size() <= size + size / 1000 + 20);  // at worst stored: 5 bytes for each 65535
  }
}

TEST("a stream written in pieces is one stream, and copies reach over their borders") {
  Random random(13);
  Bytes noise(1000), all;
  for (std::uint8_t& byte : noise) byte = std::uint8_t(random.index(256));
  for (int i = 0; i < 5; ++i) all.insert(all.end(), noise.begin(), noise.end());
  const Bytes packed = encoded::zlib(all, noise.size());
  CHECK(inflated(packed) == all);
  CHECK(packed.size() < 1300);  // noise once, and four copies of it
  for (const std::size_t piece : {1u, 2u, 7u, 999u, 4999u, 5000u}) {
    CHECK(inflated(encoded::zlib(all, piece)) == all);
  }
}

TEST("the sizes around every limit come back: none, one, the window, a stored block, tokens") {
  Random random(15);
  // A copy's longest, the window, what a stored block holds, and the tokens of a block.
  const std::size_t limits[] = {0, 1, 2, 258, 16384, 32768, 65535, 131072};
  for (const std::size_t limit : limits) {
    for (const std::size_t size : {limit, limit + 1, limit - std::min<std::size_t>(limit, 1)}) {
      Bytes equal(size, 200), noise(size), alternating(size);
      for (std::size_t i = 0; i < size; ++i) {
        noise[i] = std::uint8_t(random.index(256));
        alternating[i] = std::uint8_t(i % 2 * 77);
      }
      for (const Bytes& bytes : {equal, noise, alternating}) {
        const Bytes packed = encoded::zlib(bytes);
        check::report(inflated(packed) == bytes, __FILE__, __LINE__, std::to_string(size));
        CHECK(packed.size() <= size + 5 * (size / 16384 + 1) + 6);  // at worst stored
      }
    }
  }
}

TEST("copies reach back a window and no further") {
  Random random(16);
  for (const std::size_t distance : {std::size_t{32767}, std::size_t{32768}, std::size_t{32769}}) {
    Bytes bytes(distance + 200);  // noise, and its first 200 bytes again
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = i < distance ? std::uint8_t(random.index(256)) : bytes[i - distance];
    }
    const Bytes packed = encoded::zlib(bytes);
    CHECK(inflated(packed) == bytes);
    CHECK_EQUAL(packed.size() < distance + 100, distance <= 32768);
  }
}

TEST("long runs cost next to nothing, and noise no more than itself") {
  // Two bits for 258 bytes at best: 1 MB in 1 kB, and the heads of blocks.
  CHECK(encoded::zlib(Bytes(1 << 20)).size() < 1200);
  CHECK(inflated(encoded::zlib(Bytes(1 << 20))) == Bytes(1 << 20));
  CHECK(inflated(encoded::zlib({})).empty());
}
