// The tables of deflate that its reader and its writer share (RFC 1951: Deutsch, DEFLATE Compressed
// Data Format Specification, 1996).
#pragma once
#include <cstddef>
#include <cstdint>

namespace deflate {

constexpr unsigned kLongestCode = 15;       // bits of a literal, length or distance code
constexpr unsigned kLongestLengthCode = 7;  // bits of a code for code lengths
constexpr unsigned kEndOfBlock = 256;       // symbols below it are literal bytes
constexpr unsigned kLiteralSymbols = 286;   // literals, end of block, lengths
constexpr unsigned kDistanceSymbols = 30;
constexpr unsigned kLengthCodeSymbols = 19;  // 0..15 a length, 16 repeat, 17 and 18 zeros
constexpr unsigned kWindow = 32768;          // a copy reaches back at most so far
constexpr unsigned kShortestCopy = 3, kLongestCopy = 258;

/// RFC 1951, 3.2.5: what a length or distance symbol starts from, and its further bits.
struct Range {
  std::uint16_t base;
  std::uint8_t bits;
};
constexpr Range kLengths[] = {
    {3, 0},  {4, 0},  {5, 0},  {6, 0},   {7, 0},   {8, 0},   {9, 0},   {10, 0},  {11, 1}, {13, 1},
    {15, 1}, {17, 1}, {19, 2}, {23, 2},  {27, 2},  {31, 2},  {35, 3},  {43, 3},  {51, 3}, {59, 3},
    {67, 4}, {83, 4}, {99, 4}, {115, 4}, {131, 5}, {163, 5}, {195, 5}, {227, 5}, {258, 0}};
constexpr Range kDistances[] = {{1, 0},     {2, 0},     {3, 0},      {4, 0},      {5, 1},
                                {7, 1},     {9, 2},     {13, 2},     {17, 3},     {25, 3},
                                {33, 4},    {49, 4},    {65, 5},     {97, 5},     {129, 6},
                                {193, 6},   {257, 7},   {385, 7},    {513, 8},    {769, 8},
                                {1025, 9},  {1537, 9},  {2049, 10},  {3073, 10},  {4097, 11},
                                {6145, 11}, {8193, 12}, {12289, 12}, {16385, 13}, {24577, 13}};

/// RFC 1951, 3.2.7: the order in which the lengths of the code for code lengths are stored.
constexpr std::uint8_t kLengthCodeOrder[kLengthCodeSymbols] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                               11, 4,  12, 3, 13, 2, 14, 1, 15};

}  // namespace deflate
