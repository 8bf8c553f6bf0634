// Deflate blocks: RFC 1951, 3.2.3 to 3.2.7.
#include "image/block_writer.h"

#include <algorithm>

#include "image/prefix_lengths.h"

namespace deflate {

namespace {

constexpr std::size_t kMostStored = 65535;  // bytes in a stored block: 16 bits tell the length
constexpr unsigned kFewestLiterals = 257, kFewestDistances = 1, kFewestLengthCodes = 4;

/// The codes of one alphabet; bits are turned round, for codes are written highest bit first.
template <std::size_t N>
struct Code {
  std::array<std::uint8_t, N> lengths = {};
  std::array<std::uint16_t, N> bits = {};

  /// RFC 1951, 3.2.2: codes of one length are consecutive, in the order of their symbols.
  void numberCodes() {
    unsigned next = 0;
    for (unsigned length = 1; length <= kLongestCode; ++length, next <<= 1) {
      for (std::size_t i = 0; i < N; ++i) {
        if (lengths[i] == length) bits[i] = reversed(next++, length);
      }
    }
  }
  static std::uint16_t reversed(unsigned code, unsigned length) {
    unsigned result = 0;
    for (unsigned i = 0; i < length; ++i) result |= (code >> i & 1) << (length - 1 - i);
    return static_cast<std::uint16_t>(result);
  }
  void put(std::size_t symbol, BitWriter& out) const { out.put(bits[symbol], lengths[symbol]); }
};

/// One entry of the stored code lengths: a length, or a run of them.
struct LengthStep {
  std::uint8_t symbol, more, moreBits;
};

struct BlockCodes {
  Code<288> literals;  // two more than occur: the fixed code numbers them too
  Code<32> distances;
};

BlockCodes fixedCodes() {  // RFC 1951, 3.2.6
  BlockCodes codes;
  auto& lengths = codes.literals.lengths;
  std::fill(lengths.begin(), lengths.begin() + 144, std::uint8_t{8});
  std::fill(lengths.begin() + 144, lengths.begin() + 256, std::uint8_t{9});
  std::fill(lengths.begin() + 256, lengths.begin() + 280, std::uint8_t{7});
  std::fill(lengths.begin() + 280, lengths.end(), std::uint8_t{8});
  codes.distances.lengths.fill(5);
  codes.literals.numberCodes();
  codes.distances.numberCodes();
  return codes;
}

BlockCodes bestCodes(const SymbolCounts& counts) {
  BlockCodes codes;
  findPrefixLengths(counts.literals.data(), counts.literals.size(), kLongestCode,
                    codes.literals.lengths.data());
  findPrefixLengths(counts.distances.data(), counts.distances.size(), kLongestCode,
                    codes.distances.lengths.data());
  codes.literals.numberCodes();
  codes.distances.numberCodes();
  return codes;
}

template <std::size_t N>
std::size_t usedLengths(const std::array<std::uint8_t, N>& lengths, std::size_t least) {
  std::size_t used = N;
  while (used > least && lengths[used - 1] == 0) --used;
  return used;
}

/// Zeros in runs of up to 138 and of up to 10, others repeated 3 to 6 times.
std::vector<LengthStep> stepsOf(const std::vector<std::uint8_t>& lengths) {
  std::vector<LengthStep> steps;
  for (std::size_t at = 0; at < lengths.size();) {
    const std::uint8_t length = lengths[at];
    std::size_t run = 1;
    while (at + run < lengths.size() && lengths[at + run] == length) ++run;
    at += run;
    if (length != 0) {
      steps.push_back({length, 0, 0});
      --run;
    }
    while (run >= 3) {
      const std::size_t part = std::min<std::size_t>(run, length != 0 ? 6 : run <= 10 ? 10 : 138);
      if (length != 0)
        steps.push_back({16, static_cast<std::uint8_t>(part - 3), 2});
      else if (part <= 10)
        steps.push_back({17, static_cast<std::uint8_t>(part - 3), 3});
      else
        steps.push_back({18, static_cast<std::uint8_t>(part - 11), 7});
      run -= part;
    }
    for (; run > 0; --run) steps.push_back({length, 0, 0});
  }
  return steps;
}

/// The head of a dynamic block: the lengths of its codes, themselves in codes.
class DynamicHead {
 public:
  explicit DynamicHead(const BlockCodes& codes)
      : literals_(std::min<std::size_t>(usedLengths(codes.literals.lengths, kFewestLiterals),
                                        kLiteralSymbols)),
        distances_(usedLengths(codes.distances.lengths, kFewestDistances)) {
    std::vector<std::uint8_t> lengths(codes.literals.lengths.begin(),
                                      codes.literals.lengths.begin() + std::ptrdiff_t(literals_));
    lengths.insert(lengths.end(), codes.distances.lengths.begin(),
                   codes.distances.lengths.begin() + std::ptrdiff_t(distances_));
    steps_ = stepsOf(lengths);
    std::array<std::uint32_t, kLengthCodeSymbols> counts = {};
    for (const LengthStep step : steps_) ++counts[step.symbol];
    findPrefixLengths(counts.data(), counts.size(), kLongestLengthCode, code_.lengths.data());
    code_.numberCodes();
    lengthCodes_ = kLengthCodeSymbols;
    while (lengthCodes_ > kFewestLengthCodes &&
           code_.lengths[kLengthCodeOrder[lengthCodes_ - 1]] == 0)
      --lengthCodes_;
  }

  std::uint64_t bits() const {
    std::uint64_t sum = 5 + 5 + 4 + 3 * lengthCodes_;
    for (const LengthStep step : steps_) sum += code_.lengths[step.symbol] + step.moreBits;
    return sum;
  }

  void write(BitWriter& out) const {
    out.put(static_cast<std::uint32_t>(literals_ - kFewestLiterals), 5);
    out.put(static_cast<std::uint32_t>(distances_ - kFewestDistances), 5);
    out.put(static_cast<std::uint32_t>(lengthCodes_ - kFewestLengthCodes), 4);
    for (std::size_t i = 0; i < lengthCodes_; ++i) out.put(code_.lengths[kLengthCodeOrder[i]], 3);
    for (const LengthStep step : steps_) {
      code_.put(step.symbol, out);
      out.put(step.more, step.moreBits);
    }
  }

 private:
  std::size_t literals_, distances_, lengthCodes_ = 0;
  std::vector<LengthStep> steps_;
  Code<kLengthCodeSymbols> code_;
};

/// Bits of all tokens in these codes, with the end of the block.
std::uint64_t bitsOf(const SymbolCounts& counts, const BlockCodes& codes) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < counts.literals.size(); ++i) {
    const unsigned more = i > kEndOfBlock ? kLengths[i - kEndOfBlock - 1].bits : 0;
    sum += std::uint64_t{counts.literals[i]} * (codes.literals.lengths[i] + more);
  }
  for (std::size_t i = 0; i < counts.distances.size(); ++i) {
    sum += std::uint64_t{counts.distances[i]} *
           (codes.distances.lengths[i] + unsigned{kDistances[i].bits});
  }
  return sum;
}

std::uint64_t dynamicBits(const SymbolCounts& counts) {
  const BlockCodes codes = bestCodes(counts);
  return 3 + DynamicHead(codes).bits() + bitsOf(counts, codes);
}

void writeTokens(const std::vector<Token>& tokens, std::size_t first, std::size_t last,
                 const BlockCodes& codes, BitWriter& out) {
  for (std::size_t i = first; i < last; ++i) {
    const Token token = tokens[i];
    if (isLiteral(token)) {
      codes.literals.put(token.length, out);
      continue;
    }
    const unsigned length = lengthRange(token.length), distance = distanceRange(token.distance);
    codes.literals.put(kEndOfBlock + 1 + length, out);
    out.put(token.length - unsigned{kLengths[length].base}, kLengths[length].bits);
    codes.distances.put(distance, out);
    out.put(token.distance - unsigned{kDistances[distance].base}, kDistances[distance].bits);
  }
  codes.literals.put(kEndOfBlock, out);
}

void writeStored(const std::uint8_t* bytes, std::size_t size, bool isLast, BitWriter& out) {
  do {
    const std::size_t part = std::min(size, kMostStored);
    out.put(isLast && part == size, 1);
    out.put(0, 2);
    out.fillByte();
    out.put(static_cast<std::uint32_t>(part), 16);
    out.put(static_cast<std::uint32_t>(part ^ 0xFFFF), 16);
    for (std::size_t i = 0; i < part; ++i) out.put(bytes[i], 8);
    bytes += part;
    size -= part;
  } while (size > 0);
}

constexpr std::size_t kFewestTokens = 512;  // in a block that is worth a head of its own
constexpr std::size_t kTries = 8;           // places at which a stretch is tried to be cut

/// Cuts tokens[first..last), whose symbols are `counts` and which take `whole` bits, where that
/// saves most, and both parts in turn.
void split(const std::vector<Token>& tokens, std::size_t first, std::size_t last,
           const SymbolCounts& counts, std::uint64_t whole, std::vector<std::size_t>& cuts) {
  const std::size_t step = std::max(kFewestTokens, (last - first) / (kTries + 1));
  std::size_t best = first;
  std::uint64_t least = whole, bestLeft = 0;
  SymbolCounts left = SymbolCounts::of(tokens, first, first), bestCounts;
  for (std::size_t cut = first + step; cut + kFewestTokens <= last; cut += step) {
    for (std::size_t i = cut - step; i < cut; ++i) left.add(tokens[i]);
    const std::uint64_t leftBits = dynamicBits(left);
    const std::uint64_t both = leftBits + dynamicBits(counts.without(left));
    if (both >= least) continue;
    least = both;
    bestLeft = leftBits;
    bestCounts = left;
    best = cut;
  }
  if (best == first) return;
  split(tokens, first, best, bestCounts, bestLeft, cuts);
  cuts.push_back(best);
  split(tokens, best, last, counts.without(bestCounts), least - bestLeft, cuts);
}

}  // namespace

std::vector<std::size_t> splitIntoBlocks(const std::vector<Token>& tokens) {
  std::vector<std::size_t> cuts = {0};
  const SymbolCounts counts = SymbolCounts::of(tokens, 0, tokens.size());
  split(tokens, 0, tokens.size(), counts, dynamicBits(counts), cuts);
  cuts.push_back(tokens.size());
  return cuts;
}

void writeBlock(const std::vector<Token>& tokens, std::size_t first, std::size_t last,
                const std::uint8_t* bytes, std::size_t size, bool isLast, BitWriter& out) {
  const SymbolCounts counts = SymbolCounts::of(tokens, first, last);
  const BlockCodes best = bestCodes(counts), fixed = fixedCodes();
  const DynamicHead head(best);
  const std::uint64_t dynamic = head.bits() + bitsOf(counts, best);
  const std::uint64_t plain = bitsOf(counts, fixed);
  const std::uint64_t stored = 8 * (size + 5 * (size / kMostStored + 1));
  if (stored <= std::min(dynamic, plain)) return writeStored(bytes, size, isLast, out);
  const bool isFixed = plain <= dynamic;
  out.put(isLast, 1);
  out.put(isFixed ? 1 : 2, 2);
  if (!isFixed) head.write(out);
  writeTokens(tokens, first, last, isFixed ? fixed : best, out);
}

}  // namespace deflate
