// Writes tokens as deflate blocks.
#pragma once
#include "image/bit_writer.h"
#include "image/deflate_costs.h"

namespace deflate {

/// Where to begin new blocks, so that each has codes that suit it: rising places in `tokens`, the
/// first 0 and the last tokens.size().
std::vector<std::size_t> splitIntoBlocks(const std::vector<Token>& tokens);

/// Writes tokens[first..last), which stand for `size` bytes from `bytes` on, as one block of the
/// kind that is shortest: dynamic codes, fixed codes, or stored (several blocks where it is long).
/// `isLast` marks the end of the stream.
void writeBlock(const std::vector<Token>& tokens, std::size_t first, std::size_t last,
                const std::uint8_t* bytes, std::size_t size, bool isLast, BitWriter& out);

}  // namespace deflate
