// DeflateWriter.
#include "image/deflate.h"

#include <algorithm>

#include "image/block_writer.h"
#include "image/cheapest_tokens.h"
#include "image/checksum.h"
#include "system/worker_threads.h"

namespace {

using deflate::CopyLists;
using deflate::Costs;
using deflate::CostsFrom;
using deflate::SymbolCounts;
using deflate::Token;

/// Bytes that threads work on apart, at most: each has blocks of its own, and begins with a look at
/// the window before it.
constexpr std::size_t kPiece = std::size_t(1) << 18;
constexpr std::size_t kStack = std::size_t(1) << 18;  // bytes
static_assert(kPiece <= deflate::kLongestStretch, "sums of costs fit 32 bits");

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

/// A part of the bytes that blocks of its own stand for.
struct DeflateWriter::Piece {
  std::size_t from, to;
  std::vector<Token> tokens;
  std::vector<std::size_t> cuts;  // see splitIntoBlocks
};

DeflateWriter::DeflateWriter(unsigned depth, int rounds, int threads)
    : depth_(depth), rounds_(rounds), threads_(threads) {
  out_.put(0x78, 8);  // deflate with a window of 32768 bytes
  out_.put(0xDA, 8);  // compressed as well as it could; 0x78DA is a multiple of 31
}

void DeflateWriter::append(const Bytes& bytes, std::size_t from, const Costs& costs) {
  checksum_ = adler32(bytes.data() + from, bytes.size() - from, checksum_);
  const std::size_t size = bytes.size() - from, count = (size + kPiece - 1) / kPiece;
  std::vector<Piece> pieces(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t share = (size + count - 1) / count;
    pieces[i].from = from + std::min(size, share * i);
    pieces[i].to = from + std::min(size, share * (i + 1));
  }
  shareOnThreads(threads_, kStack, count,
                 [&](std::size_t i) { findTokens(bytes.data(), costs, pieces[i]); });
  for (const Piece& piece : pieces) write(bytes.data() + piece.from, piece);
}

void DeflateWriter::findTokens(const std::uint8_t* bytes, const Costs& costs, Piece& piece) const {
  const CopyLists lists(bytes, piece.from, piece.to, depth_);
  const std::uint8_t* first = bytes + piece.from;
  piece.tokens = deflate::cheapestTokens(first, lists, {{0, costs}});
  piece.cuts = deflate::splitIntoBlocks(piece.tokens);
  for (int i = 0; i < rounds_; ++i) {
    piece.tokens = deflate::cheapestTokens(first, lists, costsOf(piece.tokens, piece.cuts));
    piece.cuts = deflate::splitIntoBlocks(piece.tokens);
  }
}

/// `at` is where the piece begins.
void DeflateWriter::write(const std::uint8_t* at, const Piece& piece) {
  for (std::size_t i = 0; i + 1 < piece.cuts.size(); ++i) {
    const std::size_t first = piece.cuts[i], last = piece.cuts[i + 1];
    const std::size_t size = bytesOf(piece.tokens, first, last);
    deflate::writeBlock(piece.tokens, first, last, at, size, false, out_);
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
