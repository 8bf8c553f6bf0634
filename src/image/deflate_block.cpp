// Deflate blocks: Huffman codes, and how they and the tokens are written (RFC 1951, 3.2.3
// to 3.2.7). For each block the symbols are counted, and Huffman's method gives each a code length:
// the two lightest trees are joined until one is left, and the depth of a leaf is its length. The
// lengths say the code, for codes of one length are numbered in the order of their symbols. What
// the block would take with these codes (with the lengths at its head), with the fixed codes, and
// stored, is known before a bit of it is written; the least is taken.
#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "image/deflate.h"

namespace deflate {

namespace {

constexpr std::size_t kMostStored = 65535;  // bytes in a stored block: 16 bits tell the length

/// Of one alphabet, by symbol.
using Lengths = std::vector<std::uint8_t>;
using Counts = std::vector<std::uint32_t>;

enum Alphabet { kLiterals, kDistances };

/// Calls visit(alphabet, symbol, more) for each symbol of a block; `more` are the bits behind it.
template <class Visit>
void forEachSymbol(const std::vector<Token>& tokens, const Visit& visit) {
  for (const Token token : tokens) {
    if (token.distance == 0) {
      visit(kLiterals, token.length, Bits{0, 0});
      continue;
    }
    const unsigned length = lengthSymbol(token.length), distance = distanceSymbol(token.distance);
    const Range lengths = lengthRange(length), distances = distanceRange(distance);
    visit(kLiterals, length, Bits{token.length - lengths.base, lengths.bits});
    visit(kDistances, distance, Bits{token.distance - distances.base, distances.bits});
  }
  visit(kLiterals, kEndOfBlock, Bits{0, 0});
}

/// The two codes of a block.
struct Codes {
  Lengths lengths[2];
  std::vector<Bits> bits[2] = {codeOf(lengths[kLiterals]), codeOf(lengths[kDistances])};

  std::uint64_t bitsFor(const Counts (&counts)[2]) const {
    std::uint64_t sum = 0;
    for (const Alphabet alphabet : {kLiterals, kDistances}) {
      for (std::size_t i = 0; i < counts[alphabet].size(); ++i) {
        sum += std::uint64_t{counts[alphabet][i]} * bits[alphabet][i].count;
      }
    }
    return sum;
  }
};

/// One entry of the stored code lengths: a length, or (16, 17, 18) a run of them.
struct LengthStep {
  std::uint8_t symbol;
  Bits more;  // the run's length less its least
};

/// Zeros in runs of 11 to 138 (symbol 18) and of 3 to 10 (17), others repeated 3 to 6 times (16).
std::vector<LengthStep> stepsOf(const Lengths& lengths) {
  std::vector<LengthStep> steps;
  for (std::size_t at = 0; at < lengths.size();) {
    const std::uint8_t length = lengths[at];
    std::size_t run = 1;
    while (at + run < lengths.size() && lengths[at + run] == length) ++run;
    at += run;
    if (length != 0) {  // 16 repeats the length before it
      steps.push_back({length, {0, 0}});
      --run;
    }
    while (run >= 3) {
      const auto count = static_cast<unsigned>(std::min<std::size_t>(run, length != 0 ? 6 : 138));
      steps.push_back(length != 0   ? LengthStep{16, {count - 3, 2}}
                      : count <= 10 ? LengthStep{17, {count - 3, 3}}
                                    : LengthStep{18, {count - 11, 7}});
      run -= count;
    }
    steps.insert(steps.end(), run, {length, {0, 0}});
  }
  return steps;
}

/// Cuts off the symbols at the end that do not occur, but leaves `least`.
void trim(Lengths& lengths, std::size_t least) {
  while (lengths.size() > least && lengths.back() == 0) lengths.pop_back();
}

/// RFC 1951, 3.2.7: the head of a block with codes of its own. The lengths of both codes follow
/// each other as one list of steps; steps are said in a code of their own, and its lengths come
/// first.
std::vector<Bits> headOf(const Codes& codes) {
  Lengths literals = codes.lengths[kLiterals], distances = codes.lengths[kDistances];
  trim(literals, 257);
  trim(distances, 1);
  std::vector<Bits> head = {{unsigned(literals.size()) - 257, 5},
                            {unsigned(distances.size()) - 1, 5}};
  literals.insert(literals.end(), distances.begin(), distances.end());
  const std::vector<LengthStep> steps = stepsOf(literals);
  Counts counts(kLengthCodeSymbols);
  for (const LengthStep& step : steps) ++counts[step.symbol];
  const Lengths lengths = codeLengths(counts, kLongestLengthCode);
  Lengths inOrder;
  for (const std::uint8_t symbol : kLengthCodeOrder) inOrder.push_back(lengths[symbol]);
  trim(inOrder, 4);
  head.push_back({unsigned(inOrder.size()) - 4, 4});
  for (const std::uint8_t length : inOrder) head.push_back({length, 3});
  const std::vector<Bits> code = codeOf(lengths);
  for (const LengthStep& step : steps) head.insert(head.end(), {code[step.symbol], step.more});
  return head;
}

/// The depth of each symbol in a Huffman tree of these weights; 0: the symbol is not in it, or it
/// is the only one. Nodes are numbered: first the symbols, then the joints in the order of their
/// making, so that a parent has a greater number than its children. Among equal weights the lower
/// number is joined first.
std::vector<std::size_t> depthsInTree(const Counts& weights) {
  using Tree = std::pair<std::uint64_t, std::size_t>;  // weight, number of the root
  std::priority_queue<Tree, std::vector<Tree>, std::greater<Tree>> trees;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0) trees.push({weights[i], i});
  }
  constexpr std::size_t kNone = 0;  // no symbol is a parent
  std::vector<std::size_t> parents(weights.size(), kNone);
  while (trees.size() > 1) {
    const Tree first = trees.top();
    trees.pop();
    const Tree second = trees.top();
    trees.pop();
    parents[first.second] = parents[second.second] = parents.size();
    trees.push({first.first + second.first, parents.size()});
    parents.push_back(kNone);
  }
  std::vector<std::size_t> depths(parents.size());
  for (std::size_t node = parents.size(); node-- > 0;) {  // from the root down
    if (parents[node] != kNone) depths[node] = depths[parents[node]] + 1;
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
  std::vector<std::size_t> depths = depthsInTree(counts);
  while (*std::max_element(depths.begin(), depths.end()) > longest) {
    for (std::uint32_t& count : counts) count -= count / 2;  // none that occurs becomes 0
    depths = depthsInTree(counts);
  }
  Lengths lengths(depths.begin(), depths.end());
  const auto occurs = [](std::uint32_t count) { return count > 0; };
  if (std::count_if(counts.begin(), counts.end(), occurs) == 1) {
    lengths[std::size_t(std::find_if(counts.begin(), counts.end(), occurs) - counts.begin())] = 1;
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
  Counts counts[2] = {Counts(kLiteralSymbols), Counts(kDistanceSymbols)};
  std::uint64_t moreBits = 0;  // which are the same with any codes
  forEachSymbol(tokens, [&](Alphabet alphabet, unsigned symbol, Bits more) {
    ++counts[alphabet][symbol];
    moreBits += more.count;
  });
  const Codes fixed = {{fixedLiteralLengths(), fixedDistanceLengths()}};
  const Codes own = {{codeLengths(counts[kLiterals], kLongestCode),
                      codeLengths(counts[kDistances], kLongestCode)}};
  std::vector<Bits> head = headOf(own);
  std::uint64_t ownBits = own.bitsFor(counts) + moreBits;
  for (const Bits bits : head) ownBits += bits.count;
  const std::uint64_t fixedBits = fixed.bitsFor(counts) + moreBits;
  const std::uint64_t storedBits = 8 * (size + 5 * (size / kMostStored + 1));
  if (storedBits <= std::min(ownBits, fixedBits)) return writeStored(bytes, size, isLast);
  const bool isFixed = fixedBits <= ownBits;
  if (isFixed) head.clear();
  put({isLast, 1});
  put({isFixed ? 1u : 2u, 2});
  for (const Bits bits : head) put(bits);
  const Codes& codes = isFixed ? fixed : own;
  forEachSymbol(tokens, [&](Alphabet alphabet, unsigned symbol, Bits more) {
    put(codes.bits[alphabet][symbol]);
    put(more);
  });
}

}  // namespace deflate
