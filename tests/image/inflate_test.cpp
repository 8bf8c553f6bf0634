// Inflate: streams made with python3's zlib or bit by bit, and every way to be at fault.
#include <array>
#include <random>

#include "check.h"
#include "image/deflate.h"
#include "image/png_format.h"

namespace {

/// Writes bits as RFC 1951 packs them.
class BitWriter {
 public:
  /// A number, its lowest bit first.
  BitWriter& number(unsigned value, unsigned bits) {
    for (unsigned i = 0; i < bits; ++i) bit(value >> i & 1);
    return *this;
  }
  /// A code of the given zeros and ones, the first one first.
  BitWriter& code(const char* bits) {
    for (; *bits != '\0'; ++bits) bit(*bits == '1');
    return *this;
  }
  const Bytes& bytes() const { return bytes_; }

 private:
  void bit(unsigned value) {
    if (used_ % 8 == 0) bytes_.push_back(0);
    bytes_.back() = std::uint8_t(bytes_.back() | value << used_ % 8);
    ++used_;
  }
  Bytes bytes_;
  unsigned used_ = 0;
};

constexpr std::size_t kPlenty = 1 << 20;

Bytes inflateAll(const Bytes& input, std::size_t most = kPlenty) {
  std::size_t position = 0;
  return inflate(input, position, most);
}

std::string text(const Bytes& bytes) { return std::string(bytes.begin(), bytes.end()); }

/// What is wrong with the stream; empty when nothing is.
std::string faultOf(const Bytes& input, std::size_t most = kPlenty) {
  try {
    inflateAll(input, most);
  } catch (const InflateError& error) {
    return error.what();
  }
  return "";
}

void checkPrefixes(const Bytes& whole) {
  CHECK_EQUAL(faultOf(whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes prefix(whole.begin(), whole.begin() + std::ptrdiff_t(size));
    CHECK_EQUAL(faultOf(prefix), "compressed data ends too early");
  }
}

// "abc" stored: last block of type 0, length 3, its complement, the bytes.
const Bytes kStored = {0x01, 0x03, 0x00, 0xFC, 0xFF, 'a', 'b', 'c'};

// zlib.compressobj(9, zlib.DEFLATED, -15, 9, zlib.Z_FIXED) of kFixedText.
const char* const kFixedText = "spheres reflect spheres that reflect spheres";
const Bytes kFixed = {0x2B, 0x2E, 0xC8, 0x48, 0x2D, 0x4A, 0x2D, 0x56, 0x28, 0x4A, 0x4D, 0xCB, 0x49,
                      0x4D, 0x2E, 0x51, 0x28, 0x86, 0xF2, 0x4B, 0x32, 0x12, 0x4B, 0xD0, 0x05, 0x01};

// zlib.compressobj(9, zlib.DEFLATED, -15, 9, 0) of 200 bytes (i * i // 7) % 23 + 65: one dynamic
// block.
const Bytes kDynamic = {
    0x8D, 0xCE, 0x81, 0x11, 0xC3, 0x20, 0x08, 0x40, 0xD1, 0xD9, 0x10, 0x21, 0x2A, 0x88, 0x51,
    0x82, 0xEE, 0xBF, 0x49, 0xD3, 0xBB, 0x0E, 0xD0, 0x3F, 0xC0, 0xBB, 0x0F, 0x00, 0x09, 0x33,
    0x97, 0xA6, 0x63, 0x45, 0xE2, 0x66, 0x0E, 0xAC, 0x0B, 0x2E, 0x0B, 0xEA, 0xC1, 0x76, 0xEA,
    0xA2, 0x91, 0xF4, 0xC8, 0x96, 0xA3, 0x60, 0x79, 0x96, 0xDD, 0xB3, 0x0B, 0xBA, 0x52, 0x8C,
    0x8A, 0x71, 0x0B, 0xA7, 0x98, 0x26, 0x85, 0x10, 0x76, 0x3C, 0xBE, 0xDE, 0xFC, 0x89, 0x0D,
    0x48, 0x45, 0x6C, 0xBE, 0xA2, 0xDC, 0x81, 0x75, 0x04, 0xA9, 0xA3, 0x78, 0xEE, 0xBB, 0xCC,
    0x6C, 0xF0, 0x03, 0xD3, 0xA0, 0x55, 0x8F, 0x71, 0x74, 0x0A, 0xBB, 0x60, 0x29, 0x83, 0x5B,
    0x7B, 0xC5, 0x35, 0xB4, 0x15, 0xCE, 0x98, 0xE0, 0xDB, 0x3F, 0x83, 0x1F};

// zlib.compress(b'a' * 300).
const Bytes kZlib = {0x78, 0x9C, 0x4B, 0x4C, 0x1C, 0x05, 0xC4, 0x02, 0x00, 0xD8, 0xA8, 0x71, 0xAD};

/// The head of a last dynamic block: literals and distances as counts, and the code lengths
/// (3 bits each) of the symbols 16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1.
BitWriter dynamicHead(unsigned literals, unsigned distances, std::array<unsigned, 18> lengths) {
  BitWriter bits;
  bits.number(1, 1).number(2, 2);
  bits.number(literals - 257, 5).number(distances - 1, 5).number(18 - 4, 4);
  for (const unsigned length : lengths) bits.number(length, 3);
  return bits;
}

/// A block in which 'a' is 0, end of block 10, length 3 is 11, and the only distance, 1, is 0.
/// Code lengths are written with 18 = "0", 1 = "10" and 2 = "11".
BitWriter tinyBlock() {
  BitWriter bits = dynamicHead(258, 1, {0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2});
  bits.code("0").number(97 - 11, 7);  // 97 zeros: symbols 0..96
  bits.code("10");                    // 'a'
  bits.code("0").number(127, 7);      // 138 zeros: 98..235
  bits.code("0").number(20 - 11, 7);  // 20 zeros: 236..255
  bits.code("11").code("11");         // 256, 257
  bits.code("10");                    // distance symbol 0
  return bits;
}

}  // namespace

TEST("the checksums have their published check values") {
  const std::string digits = "123456789";  // the usual check string of CRC catalogues
  CHECK_EQUAL(png::crc32(reinterpret_cast<const std::uint8_t*>(digits.data()), 9), 0xCBF43926u);
  CHECK_EQUAL(png::crc32(nullptr, 0), 0u);
  // By hand for "ab": sum 1 + 97 + 98 = 196, sums 98 + 196 = 294.
  CHECK_EQUAL(adler32(reinterpret_cast<const std::uint8_t*>("ab"), 2), 294u << 16 | 196u);
  CHECK_EQUAL(adler32(nullptr, 0), 1u);
}

TEST("a stored block gives its bytes") {
  CHECK_EQUAL(text(inflateAll(kStored)), "abc");
  const Bytes two = {0x00, 0x01, 0x00, 0xFE, 0xFF, 'x', 0x01, 0x00, 0x00, 0xFF, 0xFF};
  CHECK_EQUAL(text(inflateAll(two)), "x");  // the second block is the last, and empty
}

TEST("a fixed block is decoded") { CHECK_EQUAL(text(inflateAll(kFixed)), kFixedText); }

TEST("a dynamic block is decoded") {
  std::string expected;
  for (int i = 0; i < 200; ++i) expected += char((i * i / 7) % 23 + 65);
  CHECK_EQUAL(text(inflateAll(kDynamic)), expected);
}

TEST("a copy may overlap itself, and a single distance code of one bit is allowed") {
  BitWriter bits = tinyBlock();
  bits.code("0").code("11").code("0").code("10");  // a, 3 from 1 back, end
  CHECK_EQUAL(text(inflateAll(bits.bytes())), "aaaa");
  BitWriter other = tinyBlock();
  other.code("0").code("11").code("1111111111111111");  // the other one-bit distance is none
  CHECK_EQUAL(faultOf(other.bytes()), "a code that stands for nothing");
}

TEST("the longest length, 258, and the furthest distance, 32768, are reached") {
  Bytes input = {0x00, 0x00, 0x80, 0xFF, 0x7F};  // 32768 bytes stored, not the last block
  for (int i = 0; i < 32768; ++i) input.push_back(std::uint8_t(i * 7 + i / 256));
  const Bytes stored(input.begin() + 5, input.end());
  BitWriter bits;
  bits.number(1, 1).number(1, 2);
  bits.code("11000101");                // 285: length 258, no further bits
  bits.code("11101").number(8191, 13);  // 29: 24577 + 8191
  bits.code("0000000");
  input.insert(input.end(), bits.bytes().begin(), bits.bytes().end());
  const Bytes output = inflateAll(input);
  CHECK_EQUAL(output.size(), 32768u + 258u);
  CHECK(Bytes(output.begin() + 32768, output.end()) == Bytes(stored.begin(), stored.begin() + 258));
}

TEST("position ends up behind the last byte") {
  Bytes input = {9, 9};
  input.insert(input.end(), kFixed.begin(), kFixed.end());
  input.push_back(7);
  std::size_t position = 2;
  CHECK_EQUAL(text(inflate(input, position, kPlenty)), kFixedText);
  CHECK_EQUAL(position, 2 + kFixed.size());
}

TEST("data cut off anywhere is an error") {
  checkPrefixes(kStored);
  checkPrefixes(kFixed);
  checkPrefixes(kDynamic);
}

TEST("more bytes than expected are an error in each kind of block") {
  CHECK_EQUAL(faultOf(kStored, 3), "");
  CHECK_EQUAL(faultOf(kStored, 2), "more than the expected 2 bytes");
  CHECK_EQUAL(faultOf(kFixed, 44), "");
  CHECK_EQUAL(faultOf(kFixed, 43), "more than the expected 43 bytes");
  CHECK_EQUAL(faultOf(kFixed, 0), "more than the expected 0 bytes");  // at a literal
  CHECK_EQUAL(faultOf(kDynamic, 199), "more than the expected 199 bytes");
}

TEST("each fault of a block is found") {
  CHECK_EQUAL(faultOf({0x07}), "a block of the reserved type 3");
  CHECK_EQUAL(faultOf({0x01, 0x03, 0x00, 0xFC, 0xFE, 1, 2, 3}), "a stored block of unclear length");
  const auto fixed = [] { return BitWriter().number(1, 1).number(1, 2); };
  // 257 (length 3), distance 1, with nothing before.
  CHECK_EQUAL(faultOf(fixed().code("0000001").code("00000").bytes()),
              "a copy from before the beginning");
  const char* const kNone = "a length or distance that does not exist";
  CHECK_EQUAL(faultOf(fixed().code("11000110").bytes()), kNone);  // 286
  CHECK_EQUAL(faultOf(fixed().code("11000111").bytes()), kNone);  // 287
  // 'a' is 0x30 + 97 = 0x91; then length 3 at distance symbol 30.
  CHECK_EQUAL(faultOf(fixed().code("10010001").code("0000001").code("11110").bytes()), kNone);
}

TEST("each fault of a dynamic block's codes is found") {
  const char* const kSymbols = "more symbols than there are";
  CHECK_EQUAL(faultOf(dynamicHead(287, 1, {}).bytes()), kSymbols);
  CHECK_EQUAL(faultOf(dynamicHead(257, 31, {}).bytes()), kSymbols);
  // Three codes of one bit; two codes of two bits.
  CHECK_EQUAL(faultOf(dynamicHead(257, 1, {1, 1, 1}).bytes()),
              "more codes than their lengths allow");
  CHECK_EQUAL(faultOf(dynamicHead(257, 1, {2, 2}).bytes()), "fewer codes than their lengths need");
  // 16 = "0", 18 = "1".
  CHECK_EQUAL(faultOf(dynamicHead(257, 1, {1, 0, 1}).code("0").number(0, 2).bytes()),
              "a code length that repeats nothing");
  BitWriter tooMany = dynamicHead(257, 1, {1, 0, 1});  // 138 + 138 zeros for 258 symbols
  tooMany.code("1").number(127, 7).code("1").number(127, 7);
  CHECK_EQUAL(faultOf(tooMany.bytes()), "more code lengths than symbols");
  BitWriter endless = dynamicHead(257, 1, {1, 0, 1});  // 138 + 120 zeros: no 256
  endless.code("1").number(127, 7).code("1").number(120 - 11, 7);
  CHECK_EQUAL(faultOf(endless.bytes()), "a block that cannot end");
}

TEST("zlib data is decompressed, and its head, length and checksum are checked") {
  CHECK_EQUAL(text(inflateZlib(kZlib, 300)), std::string(300, 'a'));
  for (std::size_t size = 0; size < kZlib.size(); ++size) {
    CHECK_THROWS(inflateZlib(Bytes(kZlib.begin(), kZlib.begin() + std::ptrdiff_t(size)), 300),
                 InflateError);
  }
  Bytes longer = kZlib;
  longer.push_back(0);
  CHECK_THROWS(inflateZlib(longer, 300), InflateError);
  CHECK_THROWS(inflateZlib(kZlib, 299), InflateError);
  Bytes head = kZlib;
  head[1] = 0x9D;  // 0x789D is no multiple of 31
  CHECK_THROWS(inflateZlib(head, 300), InflateError);
  Bytes dictionary = kZlib;
  dictionary[1] = 0xBB;  // 0x78BB = 30907 = 31 * 997, with the preset dictionary bit
  CHECK_THROWS(inflateZlib(dictionary, 300), InflateError);
  Bytes window = kZlib;
  window[0] = 0x88;  // a window of 64 kB does not exist
  window[1] = 0x1C;  // 0x881C = 34844 = 31 * 1124
  CHECK_THROWS(inflateZlib(window, 300), InflateError);
}

TEST("a single wrong bit never gets through zlib's checks as other bytes") {
  for (std::size_t bit = 0; bit < 8 * kZlib.size(); ++bit) {
    Bytes changed = kZlib;
    changed[bit / 8] = std::uint8_t(changed[bit / 8] ^ (1u << bit % 8));
    try {
      CHECK_EQUAL(text(inflateZlib(changed, 300)), std::string(300, 'a'));
    } catch (const InflateError&) {
      CHECK(true);
    }
  }
}

TEST("random bytes and damaged streams end in an error or in bounded output") {
  std::mt19937 random(20);
  int decoded = 0, refused = 0;
  for (int round = 0; round < 20000; ++round) {
    Bytes input = kDynamic;
    if (round % 2 == 0) input.assign(1 + random() % 60, 0);
    for (std::size_t i = 0; i < input.size(); ++i) {
      if (round % 2 == 0 || random() % 40 == 0) input[i] = std::uint8_t(random());
    }
    try {
      const std::size_t size = inflateAll(input, 5000).size();
      ++decoded;
      if (size > 5000) CHECK_EQUAL("round " + std::to_string(round), "at most 5000 bytes");
    } catch (const InflateError&) {
      ++refused;
    }
  }
  CHECK(decoded > 100);
  CHECK(refused > 100);
}
