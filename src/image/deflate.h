// Deflate, the compression of PNG (RFC 1951: Deutsch, DEFLATE Compressed Data Format Specification
// version 1.3, 1996), and the zlib format around it (RFC 1950).
// A stream is a row of blocks. A block says bytes either as they are, or as tokens: a byte (a
// literal), or a copy of 3 to 258 bytes from up to 32768 bytes before. Tokens are said in symbols
// of two prefix codes: literals and lengths share one alphabet, distances have the other. A block's
// codes are the fixed ones, or stand at its head, as nothing but the number of bits of each code.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "image/bytes.h"

namespace deflate {

constexpr unsigned kLongestCode = 15;       // bits of a literal, length or distance code
constexpr unsigned kLongestLengthCode = 7;  // bits of a code for code lengths
constexpr unsigned kEndOfBlock = 256;       // symbols below it are literals, above it lengths
constexpr unsigned kLiteralSymbols = 286;   // literals, end of block, lengths
constexpr unsigned kDistanceSymbols = 30;
constexpr unsigned kLengthCodeSymbols = 19;  // 0..15: a length; 16..18: see kRepeatRanges
constexpr unsigned kWindow = 32768;          // a copy reaches back at most so far
constexpr unsigned kLongestCopy = 258;       // and is of 3 bytes at least

/// A symbol that stands for the 2^bits numbers from `base` on; which of them, so many further bits
/// say.
struct Range {
  unsigned base, bits;
};

/// RFC 1951, 3.2.5: the lengths that the symbols from 257 on stand for, and the distances of those
/// from 0 on. The longest copy has a symbol of its own, although the one before it could say it.
constexpr Range kLengthRanges[] = {
    {3, 0},  {4, 0},  {5, 0},  {6, 0},   {7, 0},   {8, 0},   {9, 0},   {10, 0},  {11, 1}, {13, 1},
    {15, 1}, {17, 1}, {19, 2}, {23, 2},  {27, 2},  {31, 2},  {35, 3},  {43, 3},  {51, 3}, {59, 3},
    {67, 4}, {83, 4}, {99, 4}, {115, 4}, {131, 5}, {163, 5}, {195, 5}, {227, 5}, {258, 0}};
constexpr Range kDistanceRanges[] = {{1, 0},     {2, 0},     {3, 0},      {4, 0},      {5, 1},
                                     {7, 1},     {9, 2},     {13, 2},     {17, 3},     {25, 3},
                                     {33, 4},    {49, 4},    {65, 5},     {97, 5},     {129, 6},
                                     {193, 6},   {257, 7},   {385, 7},    {513, 8},    {769, 8},
                                     {1025, 9},  {1537, 9},  {2049, 10},  {3073, 10},  {4097, 11},
                                     {6145, 11}, {8193, 12}, {12289, 12}, {16385, 13}, {24577, 13}};
/// RFC 1951, 3.2.7: how often the symbols from 16 on of the code for code lengths repeat one: the
/// length before them, zero, zero.
constexpr Range kRepeatRanges[] = {{3, 2}, {3, 3}, {11, 7}};

/// The index of the last range that begins at `number` or below.
template <std::size_t count>
unsigned indexOfRange(unsigned number, const Range (&ranges)[count]) {
  const auto isBelow = [](unsigned value, Range range) { return value < range.base; };
  return unsigned(std::upper_bound(ranges, ranges + count, number, isBelow) - ranges) - 1;
}

/// RFC 1951, 3.2.7: the order in which the lengths of the code for code lengths are stored.
constexpr std::uint8_t kLengthCodeOrder[kLengthCodeSymbols] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                               11, 4,  12, 3, 13, 2, 14, 1, 15};

/// The `count` lowest bits of `value`, the others being 0; written and read with the lowest first.
struct Bits {
  unsigned value, count;
};

/// Bits of the codes of one alphabet, by symbol.
using Lengths = std::vector<std::uint8_t>;

/// The code that has these lengths, by symbol; no bits where the length is 0. RFC 1951, 3.2.2: the
/// codes of one length are consecutive numbers, in the order of their symbols. A code is written
/// with its highest bit first, so that its bits are turned round here. Lengths are at most
/// kLongestCode.
std::vector<Bits> codeOf(const Lengths& lengths);

/// RFC 1951, 3.2.6: the bits of the fixed code of each literal or length (288, the last two of
/// which do not occur), and of each distance (32, likewise).
Lengths fixedLiteralLengths();
Lengths fixedDistanceLengths();

/// A literal, or a copy of the `length` bytes that stand `distance` bytes before.
struct Token {
  unsigned length = 0;    // of a literal: the byte itself
  unsigned distance = 0;  // 1..32768; of a literal: 0
};

/// Where the same four bytes stood before: for each value of their hash the places that had it,
/// chained from the last one back (Katz, US patent 5,051,745, 1991; as in zlib).
class HashChains {
 public:
  /// Of bytes[0..size), which must outlive it.
  HashChains(const std::uint8_t* bytes, std::size_t size);

  /// Adds the place `at`. Each place is added once, from the first one on.
  void add(std::size_t at);
  /// A match for the bytes from `at` on, as a copy of more than `longerThan` bytes (and 4 at
  /// least), among the last `tries` places of its chain within the window; they were all added,
  /// `at` was not. The nearest of the longest; of length 0 where there is none.
  Token longest(std::size_t at, unsigned longerThan, unsigned tries) const;

 private:
  std::size_t hashAt(std::size_t at) const;
  std::size_t matchingBytes(std::size_t place, std::size_t at) const;

  const std::uint8_t* const bytes_;
  const std::size_t size_;
  std::vector<std::uint32_t> last_;      // by hash: the last place; kNoPlace: there is none
  std::vector<std::uint32_t> previous_;  // by place modulo the window: the one before it
};

/// Bits of Huffman codes of at most `longest` bits: each symbol with counts[i] > 0 gets a length of
/// 1 or more, the others 0. They fill the code: nothing is left over, but where a single symbol
/// occurs, which gets 1 bit. The sum of counts[i] * length[i] is the least possible where no such
/// code is longer than `longest`. At most 2^longest symbols may occur.
Lengths codeLengths(std::vector<std::uint32_t> counts, unsigned longest);

/// Writes blocks, and bits in deflate's order: the lowest bit of each byte first.
class BlockWriter {
 public:
  /// Appends tokens[0..), which stand for bytes[0..size), as a block of the kind that is shortest:
  /// with codes of its own, with the fixed ones, or stored. `isLast` ends the stream.
  void write(const std::vector<Token>& tokens, const std::uint8_t* bytes, std::size_t size,
             bool isLast);
  /// Appends the bytes as they are; of no bytes too. Ends with a whole byte.
  void writeStored(const std::uint8_t* bytes, std::size_t size, bool isLast);
  /// All that was written, after zeros to the end of the last byte.
  Bytes take();

 private:
  void put(Bits bits);
  void fillByte() { put({0, (8 - heldCount_) % 8}); }

  Bytes bytes_;
  std::uint64_t held_ = 0;  // bits of the byte that is not whole yet
  unsigned heldCount_ = 0;  // below 8 between calls
};

}  // namespace deflate

/// A piece of a deflate stream that stands for bytes[from..to), or for none, and begins and ends
/// with whole bytes. Its copies reach back to the bytes before `from`, which earlier
/// pieces of the stream stand for: 32768 of them, or as many as there are.
Bytes deflatePiece(const Bytes& bytes, std::size_t from, std::size_t to, bool isLast);

/// RFC 1950, 2.2: the bytes that begin a zlib stream, before its deflate data.
constexpr std::uint8_t kZlibHead[] = {0x78, 0x9C};  // a window of 32768 bytes; a multiple of 31

/// RFC 1950, 2.2: Adler-32, with which it ends. `before` is that of the bytes that come before
/// these; of none at all it is 1.
std::uint32_t adler32(const std::uint8_t* bytes, std::size_t size, std::uint32_t before = 1);

/// The compressed data is at fault; what() says how.
class InflateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Deflate cannot do better: 258 bytes from two codes of one bit each, that is 2 bits.
constexpr std::size_t kMostExpansion = 258 * 8 / 2;

/// Decompresses a deflate stream that begins at byte `position` of `input`, and sets `position`
/// behind its last byte. Memory grows with what is decoded. Throws InflateError for data that is
/// at fault or cut off, or that gives more than `most` bytes. (Public for its test.)
Bytes inflate(const Bytes& input, std::size_t& position, std::size_t most);

/// The same for a zlib stream, which must take up all of `input`: a two-byte head without a preset
/// dictionary, deflate data, Adler-32.
Bytes inflateZlib(const Bytes& input, std::size_t most);
