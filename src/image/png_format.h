// What the PNG reader and writer share: signature, colour types, filters, checksum of chunks.
// A file is a signature and chunks; a chunk is its length, four letters, data and a checksum. The
// data of all IDAT chunks is one zlib stream of the rows from the top, each behind a byte that
// names its filter: the row then holds, instead of each byte, how far that is from a guess. Source:
// Boutell et al., PNG Specification, version 1.0 (RFC 2083), 1997.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace png {

constexpr std::uint8_t kSignature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

/// RFC 2083, 4.1.1.
enum ColorType : std::uint8_t { kGrey = 0, kRgb = 2, kPalette = 3, kGreyAlpha = 4, kRgba = 6 };

constexpr unsigned kFilters = 5;  // none, left, above, mean of both, Paeth

/// RFC 2083, 6.6: whichever of left, above and corner is nearest to left + above - corner.
inline int paeth(int left, int above, int corner) {
  const int toLeft = std::abs(above - corner);
  const int toAbove = std::abs(left - corner);
  const int toCorner = std::abs(left + above - 2 * corner);
  const int nearer = toAbove <= toCorner ? above : corner;
  return toLeft <= toAbove && toLeft <= toCorner ? left : nearer;
}

/// RFC 2083, 6: the guess of a byte from that of the pixel to the left, above, and above left
/// (`corner`); outside the picture they are 0.
inline int predict(unsigned filter, int left, int above, int corner) {
  return filter == 0   ? 0
         : filter == 1 ? left
         : filter == 2 ? above
         : filter == 3 ? (left + above) / 2
                       : paeth(left, above, corner);
}

/// Filters a row of `size` bytes, `perPixel` of them a pixel, to out[0..size), and gives the sum of
/// the absolute values of the differences, taken as -128..127. As many bytes as a pixel has stand
/// before `row` and before `above`, the row above it, and are 0; so is the row above the first.
std::uint64_t filterRow(unsigned filter, unsigned perPixel, const std::uint8_t* row,
                        const std::uint8_t* above, std::size_t size, std::uint8_t* out);

/// RFC 2083, 3.4: CRC-32. The table holds what remains of each byte, divided by the polynomial
/// 0xEDB88320 (the lowest bit is that of the highest power).
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

}  // namespace png
