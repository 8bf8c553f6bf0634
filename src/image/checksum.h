// Checksums of PNG: CRC-32 of chunks (RFC 2083, section 3.4), Adler-32 of zlib data (RFC
// 1950, 2.2).
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

/// The remainder of each byte, shifted through the CRC polynomial 0xEDB88320 (bits reversed).
constexpr std::array<std::uint32_t, 256> makeCrcTable() {
  std::array<std::uint32_t, 256> table = {};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder & 1) != 0 ? 0xEDB88320u ^ (remainder >> 1) : remainder >> 1;
    }
    table[byte] = remainder;
  }
  return table;
}

inline std::uint32_t crc32(const std::uint8_t* bytes, std::size_t size) {
  static constexpr std::array<std::uint32_t, 256> kTable = makeCrcTable();
  std::uint32_t crc = 0xFFFFFFFFu;
  for (std::size_t i = 0; i < size; ++i) crc = kTable[(crc ^ bytes[i]) & 255] ^ (crc >> 8);
  return ~crc;
}

/// `before` is the sum of the bytes that come before these: of none at all it is 1.
inline std::uint32_t adler32(const std::uint8_t* bytes, std::size_t size,
                             std::uint32_t before = 1) {
  std::uint32_t sum = before & 0xFFFF, sumOfSums = before >> 16;
  for (std::size_t i = 0; i < size; ++i) {
    sum = (sum + bytes[i]) % 65521;  // the largest prime below 2^16
    sumOfSums = (sumOfSums + sum) % 65521;
  }
  return sumOfSums << 16 | sum;
}
