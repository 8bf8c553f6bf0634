// DeflateWriter: compresses bytes to a zlib stream (RFC 1950 and 1951), stretch by stretch.
#pragma once
#include "image/bit_writer.h"
#include "image/bytes.h"
#include "image/deflate_costs.h"

class DeflateWriter {
 public:
  /// `depth` is how far copies are searched for (see CopyTree), `rounds` >= 0 how often the tokens
  /// are chosen anew by what they cost in the blocks of the round before. The work is shared among
  /// `threads` >= 1 threads at most; the stream does not depend on them.
  DeflateWriter(unsigned depth, int rounds, int threads = 1);

  /// Compresses bytes[from..size). What comes before `from` was compressed by earlier calls: the
  /// last 32768 bytes of that at least, or all where it was less. `costs` is what symbols probably
  /// cost, where something is known of that.
  void append(const Bytes& bytes, std::size_t from,
              const deflate::Costs& costs = deflate::costsAtFirst());
  /// Ends the stream. Nothing can be appended after.
  void finish();

  /// The compressed bytes that are complete, which are then forgotten.
  Bytes take() { return out_.take(); }

 private:
  struct Piece;
  void findTokens(const std::uint8_t* bytes, const deflate::Costs& costs, Piece& piece) const;
  void write(const std::uint8_t* bytes, const Piece& piece);

  unsigned depth_;
  int rounds_, threads_;
  std::uint32_t checksum_ = 1;
  BitWriter out_;
};

/// All at once.
Bytes deflateZlib(const Bytes& bytes);
