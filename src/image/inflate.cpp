// Inflate: decompresses deflate data, block after block.
// A code is looked up by the next bits, as many as the longest code has: a table has the symbol and
// length of each code at all places that begin with it. What a code says is a byte, or how long and
// how far back the copy is that follows; both end up behind the output.
#include <algorithm>

#include "image/deflate.h"

namespace {

using deflate::kEndOfBlock;
using deflate::Lengths;

/// Throws InflateError where the claim does not hold.
void check(bool claim, const char* otherwise) {
  if (!claim) throw InflateError(otherwise);
}

/// The bits of the input, the lowest bit of each byte first.
class BitReader {
 public:
  BitReader(const Bytes& input, std::size_t position) : input_(input), position_(position) {}

  /// A number of 0 to 16 bits, its lowest bit first.
  unsigned take(unsigned count) {
    const unsigned value = peek(count);
    drop(count);
    return value;
  }
  /// That number, but leaves it; beyond the end of the input are zeros.
  unsigned peek(unsigned count) {
    while (held_ < count && position_ < input_.size()) {
      bits_ |= std::uint32_t{input_[position_++]} << held_;
      held_ += 8;
    }
    return bits_ & ((1u << count) - 1);
  }
  void drop(unsigned count) {
    check(count <= held_, "compressed data ends too early");
    bits_ >>= count;
    held_ -= count;
  }

  void dropRestOfByte() { drop(held_ % 8); }
  /// Of the byte behind the one that the last bit taken is in.
  std::size_t position() const { return position_ - held_ / 8; }

 private:
  const Bytes& input_;
  std::size_t position_;
  std::uint32_t bits_ = 0;
  unsigned held_ = 0;  // at most 23
};

/// Decodes the symbols of one alphabet.
class Decoder {
 public:
  /// lengths[symbol] is 1 to 15 bits, or 0 for a symbol that does not occur. A code must be
  /// complete, except that it may have no symbol, or a single one of 1 bit.
  explicit Decoder(const Lengths& lengths)
      : longest_(*std::max_element(lengths.begin(), lengths.end())), table_(1u << longest_) {
    // Kraft's sum, counted in places: a code is complete where it takes up all of the table.
    const std::vector<deflate::Bits> code = deflate::codeOf(lengths);
    std::size_t taken = 0;  // places of the table; a code of n bits has one in 2^n of them
    for (const deflate::Bits bits : code) taken += bits.count > 0 ? table_.size() >> bits.count : 0;
    check(taken <= table_.size(), "more codes than their lengths allow");
    check(taken == table_.size() || longest_ <= 1, "fewer codes than their lengths need");
    // The first bit of a code is the lowest one of a place, so that its places are 2^n apart.
    for (std::size_t symbol = 0; symbol < code.size(); ++symbol) {
      if (code[symbol].count == 0) continue;
      for (unsigned at = code[symbol].value; at < table_.size(); at += 1u << code[symbol].count) {
        table_[at] = {static_cast<std::uint16_t>(symbol), lengths[symbol]};
      }
    }
  }

  /// The next symbol. At the end of the input zeros are looked up, but cannot be dropped.
  unsigned take(BitReader& bits) const {
    const Entry entry = table_[bits.peek(longest_)];
    check(entry.length > 0, "a code that stands for nothing");
    bits.drop(entry.length);
    return entry.symbol;
  }

 private:
  struct Entry {
    std::uint16_t symbol;
    std::uint8_t length;  // 0: no code
  };

  unsigned longest_;
  std::vector<Entry> table_;
};

/// One stream: its bits, and what they have given so far, in which copies look back.
class Inflater {
 public:
  Inflater(const Bytes& input, std::size_t position, std::size_t most)
      : bits_(input, position), most_(most) {
    output_.reserve(std::min(most, kMostExpansion * input.size()));  // growing takes as long again
  }

  Bytes run() {
    for (bool isLast = false; !isLast;) {
      isLast = bits_.take(1) != 0;
      const unsigned type = bits_.take(2);
      check(type < 3, "a block of the reserved type 3");
      if (type == 0) copyStored();
      if (type == 1) decodeBlock(deflate::fixedLiteralLengths(), deflate::fixedDistanceLengths());
      if (type == 2) decodeDynamic();
    }
    return std::move(output_);
  }
  std::size_t position() const { return bits_.position(); }

 private:
  /// Before anything is put out: memory must not grow with what a hostile stream promises.
  void checkRoom(std::size_t count) const {
    if (count > most_ - output_.size()) {
      throw InflateError("more than the expected " + std::to_string(most_) + " bytes");
    }
  }

  /// RFC 1951, 3.2.4: from the next whole byte on the size, its complement, and the bytes.
  void copyStored() {
    bits_.dropRestOfByte();
    const unsigned size = bits_.take(16);
    check((bits_.take(16) ^ size) == 0xFFFF, "a stored block of unclear length");
    checkRoom(size);
    for (unsigned i = 0; i < size; ++i) output_.push_back(std::uint8_t(bits_.take(8)));
  }

  /// RFC 1951, 3.2.7: the lengths of both codes come first, as one list, then what they say.
  void decodeDynamic() {
    const unsigned literals = bits_.take(5) + 257, distances = bits_.take(5) + 1;
    check(literals <= deflate::kLiteralSymbols && distances <= deflate::kDistanceSymbols,
          "more symbols than there are");
    const Lengths lengths = readCodeLengths(literals + distances);
    check(lengths[kEndOfBlock] > 0, "a block that cannot end");
    const auto middle = lengths.begin() + literals;
    decodeBlock({lengths.begin(), middle}, {middle, lengths.end()});
  }

  /// That list of `count` lengths. It is in a code of its own, whose lengths, 3 bits each, come
  /// before it in an order that lets the rare ones at the end be left out.
  Lengths readCodeLengths(std::size_t count) {
    Lengths codeLengths(deflate::kLengthCodeSymbols);
    const unsigned stored = bits_.take(4) + 4;
    for (unsigned i = 0; i < stored; ++i) {
      codeLengths[deflate::kLengthCodeOrder[i]] = static_cast<std::uint8_t>(bits_.take(3));
    }
    const Decoder code(codeLengths);
    Lengths lengths;
    while (lengths.size() < count) {
      const unsigned symbol = code.take(bits_);
      check(symbol != 16 || !lengths.empty(), "a code length that repeats nothing");
      const unsigned length = symbol < 16 ? symbol : symbol == 16 ? lengths.back() : 0;
      const std::size_t times = symbol < 16 ? 1 : takeFrom(deflate::kRepeatRanges, symbol - 16);
      check(times <= count - lengths.size(), "more code lengths than symbols");
      lengths.insert(lengths.end(), times, static_cast<std::uint8_t>(length));
    }
    return lengths;
  }

  /// Symbols up to the end of the block: a literal is put out, a length begins a copy.
  void decodeBlock(const Lengths& literalLengths, const Lengths& distanceLengths) {
    const Decoder distances(distanceLengths), literals(literalLengths);
    unsigned symbol = 0;
    while ((symbol = literals.take(bits_)) != kEndOfBlock) {
      if (symbol > kEndOfBlock) {
        copy(symbol, distances);
        continue;
      }
      checkRoom(1);
      output_.push_back(static_cast<std::uint8_t>(symbol));
    }
  }

  /// Behind the length come its further bits, then the distance in its own code, and its bits.
  void copy(unsigned symbol, const Decoder& distances) {
    const std::size_t length = takeFrom(deflate::kLengthRanges, symbol - kEndOfBlock - 1);
    const std::size_t distance = takeFrom(deflate::kDistanceRanges, distances.take(bits_));
    check(distance <= output_.size(), "a copy from before the beginning");
    checkRoom(length);
    // A copy may overlap itself: what stands from `from` on repeats itself as far as it goes.
    const std::size_t start = output_.size(), from = start - distance;
    output_.resize(start + length);
    for (std::size_t done = 0, count = 0; done < length; done += count) {
      count = std::min(length - done, distance + done);
      std::copy_n(&output_[from], count, &output_[start + done]);
    }
  }

  /// The number that the range at this index and the next bits stand for.
  template <std::size_t count>
  std::size_t takeFrom(const deflate::Range (&ranges)[count], unsigned index) {
    check(index < count, "a length or distance that does not exist");
    return ranges[index].base + bits_.take(ranges[index].bits);
  }

  BitReader bits_;
  const std::size_t most_;
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
  check(input.size() >= 2, "compressed data ends too early");
  const unsigned method = input[0] & 15u, window = input[0] >> 4;
  check(method == 8 && window <= 7 && (input[0] * 256 + input[1]) % 31 == 0,
        "expected the head of zlib data");
  check((input[1] & 0x20) == 0, "a preset dictionary is not supported");
  std::size_t position = 2;
  Bytes output = inflate(input, position, most);
  const std::size_t rest = input.size() - position;
  if (rest != 4) {
    throw InflateError("expected 4 bytes after the compressed data, found " + std::to_string(rest));
  }
  check(bigEndian32(&input[position]) == adler32(output.data(), output.size()),
        "the Adler-32 checksum is wrong");
  return output;
}
