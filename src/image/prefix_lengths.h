// Lengths of the codes of an optimal prefix code whose longest code is bounded.
#pragma once
#include <cstddef>
#include <cstdint>

/// Gives each symbol with counts[i] > 0 a code of 1 to `longest` bits, and the others length 0, so
/// that the sum of counts[i] * lengths[i] is the least that any prefix code with that bound has.
/// A single symbol gets 1 bit; none at all leaves every length 0. At most 2^longest symbols may
/// occur, and the sum of the counts stays below 2^63.
/// Source: Larmore and Hirschberg, A Fast Algorithm for Optimal Length-Limited Huffman Codes, 1990
/// ("package-merge").
void findPrefixLengths(const std::uint32_t* counts, std::size_t symbols, unsigned longest,
                       std::uint8_t* lengths);
