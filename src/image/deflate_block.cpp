// Deflate blocks: Huffman codes, and how they and the tokens are written (RFC 1951, 3.2.3
// to 3.2.7). For each block the symbols are counted, and Huffman's method gives each a code length:
// the two lightest trees are joined until one is left, and the depth of a leaf is its length. The
// lengths say the code, for codes of one length are numbered in the order of their symbols. The
// block is said with these codes (and their lengths at its head), and with the fixed codes; which
// of them is written, or the bytes as they are, is the one of the fewest bits.
#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <utility>

#include "image/deflate.h"

namespace deflate {

namespace {

constexpr std::size_t kMostStored = 65535;  // bytes in a stored block: 16 bits tell the length

/// Of one alphabet, by symbol.
using Counts = std::vector<std::uint32_t>;
using Code = std::vector<Bits>;

/// Each has a code of its own in a block.
enum Alphabet { kLiterals, kDistances, kCodeLengths };

struct Symbol {
  Alphabet alphabet;
  unsigned number;
  Bits more;  // the bits behind it
};

/// The symbol of `first` + n that stands for the n-th range, the one that `value` is in.
template <std::size_t count>
Symbol symbolOf(Alphabet alphabet, unsigned first, unsigned value, const Range (&ranges)[count]) {
  const unsigned index = indexOfRange(value, ranges);
  return {alphabet, first + index, {value - ranges[index].base, ranges[index].bits}};
}

/// What a block says behind its codes.
std::vector<Symbol> symbolsOf(const std::vector<Token>& tokens) {
  std::vector<Symbol> symbols;
  symbols.reserve(2 * tokens.size() + 1);
  for (const Token token : tokens) {
    if (token.distance == 0) {
      symbols.push_back({kLiterals, token.length, {0, 0}});
      continue;
    }
    symbols.push_back(symbolOf(kLiterals, kEndOfBlock + 1, token.length, kLengthRanges));
    symbols.push_back(symbolOf(kDistances, 0, token.distance, kDistanceRanges));
  }
  symbols.push_back({kLiterals, kEndOfBlock, {0, 0}});
  return symbols;
}

/// What says the lengths of codes: each in a symbol of its own, but zeros in runs of 11 to 138
/// (symbol 18) and of 3 to 10 (17), and 3 to 6 that repeat the one before them (16).
std::vector<Symbol> symbolsOf(const Lengths& lengths) {
  std::vector<Symbol> symbols;
  for (auto at = lengths.begin(); at != lengths.end();) {
    const std::uint8_t length = *at;
    const auto isOther = [length](std::uint8_t other) { return other != length; };
    const auto first = std::exchange(at, std::find_if(at, lengths.end(), isOther));
    auto run = unsigned(at - first);
    if (length != 0) {
      symbols.push_back({kCodeLengths, length, {0, 0}});
      --run;
    }
    // Fewer than three are no shorter in a run: they follow one by one.
    while (run >= 3) {
      const unsigned number = length != 0 ? 16 : run <= 10 ? 17 : 18;
      const Range repeats = kRepeatRanges[number - 16];
      const unsigned count = std::min(run, repeats.base + (1u << repeats.bits) - 1);
      symbols.push_back({kCodeLengths, number, {count - repeats.base, repeats.bits}});
      run -= count;
    }
    symbols.insert(symbols.end(), run, {kCodeLengths, length, {0, 0}});
  }
  return symbols;
}

/// Of the best code for those symbols that are of this alphabet, which has `size` of them.
Lengths lengthsFor(const std::vector<Symbol>& symbols, Alphabet alphabet, std::size_t size,
                   unsigned longest) {
  Counts counts(size);
  for (const Symbol& symbol : symbols) {
    if (symbol.alphabet == alphabet) ++counts[symbol.number];
  }
  return codeLengths(counts, longest);
}

/// The codes of all alphabets that a block uses, and what stands before the first symbol.
struct Codes {
  std::array<Code, 3> codes;
  std::vector<Bits> head;

  /// A symbol in the code of its alphabet, and the bits behind it.
  Bits operator()(const Symbol& symbol) const {
    const Bits code = codes[symbol.alphabet][symbol.number];
    return {code.value | symbol.more.value << code.count, code.count + symbol.more.count};
  }

  /// The bits of a block of these symbols.
  std::uint64_t countOf(const std::vector<Symbol>& symbols) const {
    std::uint64_t sum = 0;
    for (const Bits bits : head) sum += bits.count;
    for (const Symbol& symbol : symbols) sum += (*this)(symbol).count;
    return sum;
  }
};

/// Cuts off the symbols at the end that do not occur, but leaves `least`.
void trim(Lengths& lengths, std::size_t least) {
  while (lengths.size() > least && lengths.back() == 0) lengths.pop_back();
}

/// RFC 1951, 3.2.7: the best codes. Their lengths follow each other as one list, which is said in a
/// code of its own; and the lengths of that come first.
Codes ownCodes(const std::vector<Symbol>& symbols) {
  Lengths literals = lengthsFor(symbols, kLiterals, kLiteralSymbols, kLongestCode);
  Lengths distances = lengthsFor(symbols, kDistances, kDistanceSymbols, kLongestCode);
  trim(literals, 257);
  trim(distances, 1);
  Lengths both = literals;
  both.insert(both.end(), distances.begin(), distances.end());
  const std::vector<Symbol> said = symbolsOf(both);
  const Lengths lengths = lengthsFor(said, kCodeLengths, kLengthCodeSymbols, kLongestLengthCode);
  Lengths inOrder;
  for (const std::uint8_t symbol : kLengthCodeOrder) inOrder.push_back(lengths[symbol]);
  trim(inOrder, 4);
  Codes codes = {{codeOf(literals), codeOf(distances), codeOf(lengths)},
                 {{unsigned(literals.size()) - 257, 5},
                  {unsigned(distances.size()) - 1, 5},
                  {unsigned(inOrder.size()) - 4, 4}}};
  for (const std::uint8_t length : inOrder) codes.head.push_back({length, 3});
  for (const Symbol& symbol : said) codes.head.push_back(codes(symbol));
  return codes;
}

/// The depth of each symbol in a Huffman tree of these weights; 0: the symbol is not in it. Nodes
/// are numbered: first the symbols, then the joints in the order of their making, so that a parent
/// has a greater number than its children. Among equal weights the lower number is joined first. A
/// single symbol is joined with nothing.
Lengths depthsInTree(const Counts& weights) {
  using Tree = std::pair<std::uint64_t, std::size_t>;  // weight, number of the root
  std::priority_queue<Tree, std::vector<Tree>, std::greater<Tree>> trees;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0) trees.push({weights[i], i});
  }
  std::vector<std::size_t> parents(weights.size());  // 0: none, for no symbol is a parent
  // Each joint takes the two lightest trees; the last one is put back nowhere.
  while (!trees.empty()) {
    std::uint64_t weight = 0;
    for (int child = 0; child < 2 && !trees.empty(); ++child, trees.pop()) {
      weight += trees.top().first;
      parents[trees.top().second] = parents.size();
    }
    if (!trees.empty()) trees.push({weight, parents.size()});
    parents.push_back(0);
  }
  Lengths depths(parents.size());  // below 64, as weights double with every second joint
  for (std::size_t node = parents.size(); node-- > 0;) {  // from the root down
    if (parents[node] != 0) depths[node] = std::uint8_t(depths[parents[node]] + 1);
  }
  depths.resize(weights.size());
  return depths;
}

}  // namespace

std::vector<Bits> codeOf(const Lengths& lengths) {
  std::vector<Bits> code(lengths.size(), Bits{0, 0});
  unsigned next = 0;
  for (unsigned length = 1; length <= kLongestCode; ++length, next <<= 1) {
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      if (lengths[i] != length) continue;
      code[i].count = length;
      for (unsigned bit = 0; bit < length; ++bit) {
        code[i].value |= (next >> bit & 1) << (length - 1 - bit);
      }
      ++next;
    }
  }
  return code;
}

/// Huffman, A Method for the Construction of Minimum-Redundancy Codes, 1952. Where a code comes out
/// too long, the counts are halved, which makes them more alike, until it does not.
Lengths codeLengths(Counts counts, unsigned longest) {
  Lengths lengths = depthsInTree(counts);
  while (*std::max_element(lengths.begin(), lengths.end()) > longest) {
    for (std::uint32_t& count : counts) count -= count / 2;  // none that occurs becomes 0
    lengths = depthsInTree(counts);
  }
  return lengths;
}

Lengths fixedLiteralLengths() {
  Lengths lengths(288, 8);
  std::fill(lengths.begin() + 144, lengths.begin() + 256, std::uint8_t{9});
  std::fill(lengths.begin() + 256, lengths.begin() + 280, std::uint8_t{7});
  return lengths;
}

Lengths fixedDistanceLengths() { return Lengths(32, 5); }

void BlockWriter::put(Bits bits) {
  held_ |= std::uint64_t{bits.value} << heldCount_;
  for (heldCount_ += bits.count; heldCount_ >= 8; heldCount_ -= 8, held_ >>= 8) {
    bytes_.push_back(static_cast<std::uint8_t>(held_ & 255));
  }
}

Bytes BlockWriter::take() {
  fillByte();
  return std::move(bytes_);
}

void BlockWriter::writeStored(const std::uint8_t* bytes, std::size_t size, bool isLast) {
  do {
    const auto count = static_cast<unsigned>(std::min(size, kMostStored));
    put({isLast && count == size, 1});
    put({0, 2});
    fillByte();
    put({count, 16});
    put({count ^ 0xFFFF, 16});
    bytes_.insert(bytes_.end(), bytes, bytes + count);
    bytes += count;
    size -= count;
  } while (size > 0);
}

void BlockWriter::write(const std::vector<Token>& tokens, const std::uint8_t* bytes,
                        std::size_t size, bool isLast) {
  const std::vector<Symbol> symbols = symbolsOf(tokens);
  // What each kind would take is known before a bit is written.
  const Codes own = ownCodes(symbols);
  const Codes fixed = {{codeOf(fixedLiteralLengths()), codeOf(fixedDistanceLengths())}, {}};
  const std::uint64_t ownBits = own.countOf(symbols), fixedBits = fixed.countOf(symbols);
  const std::uint64_t storedBits = 8 * (size + 5 * (size / kMostStored + 1));
  if (storedBits <= std::min(ownBits, fixedBits)) return writeStored(bytes, size, isLast);
  const bool isFixed = fixedBits <= ownBits;
  const Codes& codes = isFixed ? fixed : own;
  put({isLast, 1});
  put({isFixed ? 1u : 2u, 2});
  for (const Bits bits : codes.head) put(bits);
  for (const Symbol& symbol : symbols) put(codes(symbol));
}

}  // namespace deflate
