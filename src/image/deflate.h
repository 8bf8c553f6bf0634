// DeflateWriter: compresses bytes to a zlib stream (RFC 1950 and 1951), stretch by stretch.
#pragma once
#include "image/bit_writer.h"
#include "image/cheapest_tokens.h"

class DeflateWriter {
 public:
  /// `depth` is how many earlier places are looked at for a copy (see CopyFinder), `rounds` >= 1
  /// how often the tokens are chosen anew by what they cost in the round before.
  DeflateWriter(unsigned depth, int rounds);

  /// Compresses bytes[from..size). What comes before `from` was compressed by earlier calls: the
  /// last 32768 bytes of that at least, or all where it was less.
  void append(const Bytes& bytes, std::size_t from);
  /// Ends the stream. Nothing can be appended after.
  void finish();

  /// The compressed bytes that are complete, which are then forgotten.
  Bytes take() { return out_.take(); }

 private:
  unsigned depth_;
  int rounds_;
  std::uint32_t checksum_ = 1;
  BitWriter out_;
};

namespace deflate {

/// Costs before anything is known of the bytes.
Costs costsAtFirst();

/// What bytes cost, and what the symbols of that cost.
struct Estimate {
  std::uint64_t total;  // in the units of Costs
  Costs costs;
};

/// For bytes[from..size), compressed with the tokens that `costs` make cheapest; `depth` as for
/// DeflateWriter.
Estimate estimate(const Bytes& bytes, std::size_t from, unsigned depth, const Costs& costs);

}  // namespace deflate

/// All at once.
Bytes deflateZlib(const Bytes& bytes);
