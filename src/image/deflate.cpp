// DeflateWriter.
#include "image/deflate.h"

#include <algorithm>

#include "image/block_writer.h"
#include "image/checksum.h"

namespace {

using deflate::CopyLists;
using deflate::Costs;
using deflate::SymbolCounts;
using deflate::Token;

CopyLists listsFor(const Bytes& bytes, std::size_t from, unsigned depth) {
  CopyFinder finder(bytes.data(), bytes.size(), depth);
  for (std::size_t at = from - std::min<std::size_t>(from, deflate::kWindow); at < from; ++at) {
    finder.add(at);
  }
  CopyLists lists;
  lists.collect(finder, from, bytes.size());
  return lists;
}

std::size_t bytesOf(const std::vector<Token>& tokens, std::size_t first, std::size_t last) {
  std::size_t sum = 0;
  for (std::size_t i = first; i < last; ++i) {
    sum += deflate::isLiteral(tokens[i]) ? 1 : tokens[i].length;
  }
  return sum;
}

Costs costsOf(const std::vector<Token>& tokens) {
  return Costs(SymbolCounts::of(tokens, 0, tokens.size()));
}

void putBigEndian(std::uint32_t value, BitWriter& out) {
  for (int shift = 24; shift >= 0; shift -= 8) out.put(value >> shift & 255, 8);
}

}  // namespace

DeflateWriter::DeflateWriter(unsigned depth, int rounds) : depth_(depth), rounds_(rounds) {
  out_.put(0x78, 8);  // deflate with a window of 32768 bytes
  out_.put(0xDA, 8);  // compressed as well as it could; 0x78DA is a multiple of 31
}

void DeflateWriter::append(const Bytes& bytes, std::size_t from) {
  if (from == bytes.size()) return;
  checksum_ = adler32(bytes.data() + from, bytes.size() - from, checksum_);
  const CopyLists lists = listsFor(bytes, from, depth_);
  const std::uint8_t* at = bytes.data() + from;
  std::vector<Token> tokens = deflate::cheapestTokens(at, lists, deflate::costsAtFirst());
  for (int i = 0; i < rounds_; ++i) tokens = deflate::cheapestTokens(at, lists, costsOf(tokens));
  const std::vector<std::size_t> cuts = deflate::splitIntoBlocks(tokens);
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

namespace deflate {

Costs costsAtFirst() {
  SymbolCounts counts;
  counts.literals.fill(1);
  counts.distances.fill(1);
  return Costs(counts);
}

Estimate estimate(const Bytes& bytes, std::size_t from, unsigned depth, const Costs& costs) {
  const CopyLists lists = listsFor(bytes, from, depth);
  const std::vector<Token> tokens = cheapestTokens(bytes.data() + from, lists, costs);
  Estimate result = {0, costsOf(tokens)};
  for (const Token token : tokens) result.total += result.costs.of(token);
  return result;
}

}  // namespace deflate

Bytes deflateZlib(const Bytes& bytes) {
  DeflateWriter writer(256, 2);
  writer.append(bytes, 0);
  writer.finish();
  return writer.take();
}
