// Inflate: decompresses deflate data (RFC 1951) and the zlib format around it (RFC 1950).
#pragma once
#include <cstddef>
#include <stdexcept>

#include "image/bytes.h"

/// The compressed data is at fault; what() says how.
class InflateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Deflate cannot do better: 258 bytes from two codes of one bit each, that is 2 bits (RFC 1951).
constexpr std::size_t kMostExpansion = 258 * 8 / 2;

/// Decompresses a deflate stream that begins at byte `position` of `input`, and sets `position`
/// behind its last byte. Memory grows with what is decoded. Throws InflateError for data that is
/// at fault or cut off, or that gives more than `most` bytes.
Bytes inflate(const Bytes& input, std::size_t& position, std::size_t most);

/// The same for a zlib stream, which must take up all of `input`: a two-byte head without a preset
/// dictionary, deflate data, Adler-32.
Bytes inflateZlib(const Bytes& input, std::size_t most);
