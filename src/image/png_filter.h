// The filters of PNG: each byte of a row less a guess from its neighbours (RFC 2083, section 6).
#pragma once
#include <cstdlib>

#include "image/bytes.h"

namespace png {

constexpr unsigned kFilters = 5;  // none, left, above, mean of both, Paeth

/// RFC 2083, 6.6: whichever of left, above and corner is nearest to left + above - corner.
inline int paeth(int left, int above, int corner) {
  const int toLeft = std::abs(above - corner);
  const int toAbove = std::abs(left - corner);
  const int toCorner = std::abs(left + above - 2 * corner);
  if (toLeft <= toAbove && toLeft <= toCorner) return left;
  return toAbove <= toCorner ? above : corner;
}

inline int predict(unsigned filter, int left, int above, int corner) {
  switch (filter) {
    case 0:
      return 0;
    case 1:
      return left;
    case 2:
      return above;
    case 3:
      return (left + above) / 2;
    default:
      return paeth(left, above, corner);
  }
}

/// Writes the filter's number and the filtered samples of `row` (`perPixel` bytes a pixel), 1 +
/// row.size() bytes, to `out`. `above` is the row above, of the same size; zeros for the first.
void filterRow(unsigned filter, unsigned perPixel, const Bytes& row, const Bytes& above,
               std::uint8_t* out);

/// The filter whose differences, taken as -128..127, have the least sum of absolute values (RFC
/// 2083, 9.6).
unsigned leastDifference(unsigned perPixel, const Bytes& row, const Bytes& above);

}  // namespace png
