// Inflate, as RFC 1951 (Deutsch, DEFLATE Compressed Data Format Specification, 1996) describes it.
#include "image/inflate.h"

#include <algorithm>
#include <array>

#include "image/byte_reader.h"
#include "image/checksum.h"
#include "image/deflate_tables.h"

namespace {

using deflate::kEndOfBlock;
using deflate::kLongestCode;

/// The bits of the input, the lowest bit of each byte first.
class BitReader {
 public:
  BitReader(const Bytes& input, std::size_t position) : input_(input), position_(position) {}

  /// A number of 0 to 16 bits, its lowest bit first.
  unsigned take(unsigned count) {
    while (held_ < count) {
      bits_ |= unsigned{takeByte()} << held_;
      held_ += 8;
    }
    const unsigned value = bits_ & ((1u << count) - 1);
    bits_ >>= count;
    held_ -= count;
    return value;
  }

  void dropRestOfByte() { bits_ = held_ = 0; }  // fewer than 8 are ever held
  std::size_t position() const { return position_; }

  /// Whole bytes, after dropRestOfByte.
  std::uint8_t takeByte() {
    if (position_ >= input_.size()) throw InflateError("compressed data ends too early");
    return input_[position_++];
  }

 private:
  const Bytes& input_;
  std::size_t position_;
  unsigned bits_ = 0, held_ = 0;
};

/// A canonical prefix code (RFC 1951, 3.2.2): codes of one length are consecutive numbers in the
/// order of their symbols, and the first code of a length follows from the shorter ones.
class PrefixCode {
 public:
  /// lengths[symbol] is 1 to 15 bits, or 0 for a symbol that does not occur. A code must be
  /// complete, except that it may have no symbol, or a single one of 1 bit.
  PrefixCode(const std::uint8_t* lengths, std::size_t symbols) {
    for (std::size_t i = 0; i < symbols; ++i) ++count_[lengths[i]];
    count_[0] = 0;
    std::array<std::uint16_t, kLongestCode + 2> next = {};  // first symbol of each length
    int unused = 1;                                         // codes left at this length
    for (unsigned length = 1; length <= kLongestCode; ++length) {
      unused = 2 * unused - count_[length];
      if (unused < 0) throw InflateError("more codes than their lengths allow");
      next[length + 1] = static_cast<std::uint16_t>(next[length] + count_[length]);
    }
    const unsigned used = next[kLongestCode + 1];
    const bool single = used == 0 || (used == 1 && count_[1] == 1);
    if (unused > 0 && !single) throw InflateError("fewer codes than their lengths need");
    for (std::size_t i = 0; i < symbols; ++i) {
      if (lengths[i] != 0) symbol_[next[lengths[i]]++] = static_cast<std::uint16_t>(i);
    }
  }

  unsigned decode(BitReader& bits) const {
    unsigned code = 0, first = 0, index = 0;  // first code of this length, and its symbol's place
    for (unsigned length = 1; length <= kLongestCode; ++length) {
      code = code << 1 | bits.take(1);
      if (code - first < count_[length]) return symbol_[index + code - first];
      index += count_[length];
      first = (first + count_[length]) << 1;
    }
    throw InflateError("a code that stands for nothing");
  }

 private:
  std::array<std::uint16_t, kLongestCode + 1> count_ = {};  // symbols by code length
  std::array<std::uint16_t, 288> symbol_ = {};              // by code
};

template <std::size_t N>
unsigned takeRange(const deflate::Range (&table)[N], unsigned symbol, BitReader& bits) {
  if (symbol >= N) throw InflateError("a length or distance that does not exist");
  return table[symbol].base + bits.take(table[symbol].bits);
}

class Inflater {
 public:
  Inflater(const Bytes& input, std::size_t position, std::size_t most)
      : bits_(input, position), most_(most) {}

  Bytes run() {
    for (bool last = false; !last;) {
      last = bits_.take(1) != 0;
      switch (bits_.take(2)) {
        case 0:
          copyStored();
          break;
        case 1:
          decodeFixed();
          break;
        case 2:
          decodeDynamic();
          break;
        default:
          throw InflateError("a block of the reserved type 3");
      }
    }
    return std::move(output_);
  }
  std::size_t position() const { return bits_.position(); }

 private:
  void checkRoom(std::size_t count) const {
    if (count > most_ - output_.size()) {
      throw InflateError("more than the expected " + std::to_string(most_) + " bytes");
    }
  }

  void copyStored() {
    bits_.dropRestOfByte();
    const unsigned size = bits_.take(16);
    if ((bits_.take(16) ^ size) != 0xFFFF) throw InflateError("a stored block of unclear length");
    checkRoom(size);
    for (unsigned i = 0; i < size; ++i) output_.push_back(bits_.takeByte());
  }

  void decodeFixed() {  // RFC 1951, 3.2.6
    std::array<std::uint8_t, 288> lengths;
    std::fill_n(lengths.begin(), 144, std::uint8_t{8});
    std::fill_n(lengths.begin() + 144, 112, std::uint8_t{9});
    std::fill_n(lengths.begin() + 256, 24, std::uint8_t{7});
    std::fill_n(lengths.begin() + 280, 8, std::uint8_t{8});
    std::array<std::uint8_t, 32> distances;
    distances.fill(5);
    decodeBlock({lengths.data(), lengths.size()}, {distances.data(), distances.size()});
  }

  void decodeDynamic() {  // RFC 1951, 3.2.7
    const unsigned literals = bits_.take(5) + 257;
    const unsigned distances = bits_.take(5) + 1;
    if (literals > 286 || distances > 30) throw InflateError("more symbols than there are");
    std::array<std::uint8_t, 286 + 30> lengths = {};
    readCodeLengths(lengths.data(), literals + distances);
    if (lengths[kEndOfBlock] == 0) throw InflateError("a block that cannot end");
    decodeBlock({lengths.data(), literals}, {lengths.data() + literals, distances});
  }

  PrefixCode readLengthCode() {
    std::array<std::uint8_t, deflate::kLengthCodeSymbols> lengths = {};
    const unsigned count = bits_.take(4) + 4;
    for (unsigned i = 0; i < count; ++i) {
      lengths[deflate::kLengthCodeOrder[i]] = static_cast<std::uint8_t>(bits_.take(3));
    }
    return {lengths.data(), lengths.size()};
  }

  void readCodeLengths(std::uint8_t* lengths, unsigned count) {
    const PrefixCode code = readLengthCode();
    for (unsigned done = 0; done < count;) {
      const unsigned symbol = code.decode(bits_);
      std::uint8_t length = 0;
      unsigned times = 1;
      if (symbol < 16) length = static_cast<std::uint8_t>(symbol);
      if (symbol == 16) {
        if (done == 0) throw InflateError("a code length that repeats nothing");
        length = lengths[done - 1];
        times = 3 + bits_.take(2);
      }
      if (symbol == 17) times = 3 + bits_.take(3);
      if (symbol == 18) times = 11 + bits_.take(7);
      if (times > count - done) throw InflateError("more code lengths than symbols");
      std::fill_n(lengths + done, times, length);
      done += times;
    }
  }

  void decodeBlock(const PrefixCode& literals, const PrefixCode& distances) {
    for (;;) {
      const unsigned symbol = literals.decode(bits_);
      if (symbol == kEndOfBlock) return;
      if (symbol < kEndOfBlock) {
        checkRoom(1);
        output_.push_back(static_cast<std::uint8_t>(symbol));
        continue;
      }
      const std::size_t length = takeRange(deflate::kLengths, symbol - kEndOfBlock - 1, bits_);
      const std::size_t distance = takeRange(deflate::kDistances, distances.decode(bits_), bits_);
      if (distance > output_.size()) throw InflateError("a copy from before the beginning");
      checkRoom(length);
      // Byte by byte: a copy may overlap itself.
      for (std::size_t i = 0; i < length; ++i)
        output_.push_back(output_[output_.size() - distance]);
    }
  }

  BitReader bits_;
  std::size_t most_;
  Bytes output_;
};

}  // namespace

Bytes inflate(const Bytes& input, std::size_t& position, std::size_t most) {
  Inflater inflater(input, position, most);
  Bytes output = inflater.run();
  position = inflater.position();
  return output;
}

Bytes inflateZlib(const Bytes& input, std::size_t most) {
  if (input.size() < 2) throw InflateError("compressed data ends too early");
  const unsigned method = input[0] & 15u, window = input[0] >> 4;
  if (method != 8 || window > 7 || (input[0] * 256 + input[1]) % 31 != 0) {
    throw InflateError("expected the head of zlib data");
  }
  if ((input[1] & 0x20) != 0) throw InflateError("a preset dictionary is not supported");
  std::size_t position = 2;
  Bytes output = inflate(input, position, most);
  if (input.size() - position != 4) {
    throw InflateError("expected 4 bytes after the compressed data, found " +
                       std::to_string(input.size() - position));
  }
  if (bigEndian32(input.data() + position) != adler32(output.data(), output.size())) {
    throw InflateError("the Adler-32 checksum is wrong");
  }
  return output;
}
