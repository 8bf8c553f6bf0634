// DeflateWriter.
#include "image/deflate.h"

#include <algorithm>

#include "image/block_writer.h"
#include "image/cheapest_tokens.h"
#include "image/checksum.h"

namespace {

using deflate::CopyLists;
using deflate::Costs;
using deflate::CostsFrom;
using deflate::SymbolCounts;
using deflate::Token;

std::size_t bytesOf(const std::vector<Token>& tokens, std::size_t first, std::size_t last) {
  std::size_t sum = 0;
  for (std::size_t i = first; i < last; ++i) {
    sum += deflate::isLiteral(tokens[i]) ? 1 : tokens[i].length;
  }
  return sum;
}

/// What symbols cost in the blocks tokens[cuts[i]..cuts[i + 1]).
std::vector<CostsFrom> costsOf(const std::vector<Token>& tokens,
                               const std::vector<std::size_t>& cuts) {
  std::vector<CostsFrom> costs;
  std::size_t place = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    costs.push_back({place, Costs(SymbolCounts::of(tokens, cuts[i], cuts[i + 1]))});
    place += bytesOf(tokens, cuts[i], cuts[i + 1]);
  }
  return costs;
}

void putBigEndian(std::uint32_t value, BitWriter& out) {
  for (int shift = 24; shift >= 0; shift -= 8) out.put(value >> shift & 255, 8);
}

}  // namespace

DeflateWriter::DeflateWriter(unsigned depth, int rounds) : depth_(depth), rounds_(rounds) {
  out_.put(0x78, 8);  // deflate with a window of 32768 bytes
  out_.put(0xDA, 8);  // compressed as well as it could; 0x78DA is a multiple of 31
}

void DeflateWriter::append(const Bytes& bytes, std::size_t from, const Costs& costs) {
  checksum_ = adler32(bytes.data() + from, bytes.size() - from, checksum_);
  while (from < bytes.size()) {
    const std::size_t to = from + std::min(bytes.size() - from, deflate::kLongestStretch);
    appendStretch(bytes.data(), from, to, costs);
    from = to;
  }
}

void DeflateWriter::appendStretch(const std::uint8_t* bytes, std::size_t from, std::size_t to,
                                  const Costs& costs) {
  const CopyLists lists(bytes, from, to, depth_);
  const std::uint8_t* at = bytes + from;
  std::vector<Token> tokens = deflate::cheapestTokens(at, lists, {{0, costs}});
  std::vector<std::size_t> cuts = deflate::splitIntoBlocks(tokens);
  for (int i = 0; i < rounds_; ++i) {
    tokens = deflate::cheapestTokens(at, lists, costsOf(tokens, cuts));
    cuts = deflate::splitIntoBlocks(tokens);
  }
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const std::size_t size = bytesOf(tokens, cuts[i], cuts[i + 1]);
    deflate::writeBlock(tokens, cuts[i], cuts[i + 1], at, size, false, out_);
    at += size;
  }
}

void DeflateWriter::finish() {
  deflate::writeBlock({}, 0, 0, nullptr, 0, true, out_);  // an empty block: 10 bits
  out_.fillByte();
  putBigEndian(checksum_, out_);
}

Bytes deflateZlib(const Bytes& bytes) {
  DeflateWriter writer(100, 2);
  writer.append(bytes, 0);
  writer.finish();
  return writer.take();
}
