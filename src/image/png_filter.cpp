// PNG filters.
#include "image/png_filter.h"

namespace png {

void filterRow(unsigned filter, unsigned perPixel, const Bytes& row, const Bytes& above,
               std::uint8_t* out) {
  out[0] = static_cast<std::uint8_t>(filter);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool hasLeft = i >= perPixel;
    const int guess = predict(filter, hasLeft ? row[i - perPixel] : 0, above[i],
                              hasLeft ? above[i - perPixel] : 0);
    out[1 + i] = static_cast<std::uint8_t>(row[i] - guess);
  }
}

unsigned leastDifference(unsigned perPixel, const Bytes& row, const Bytes& above) {
  unsigned best = 0;
  std::uint64_t least = ~std::uint64_t{0};
  Bytes filtered(1 + row.size());
  for (unsigned filter = 0; filter < kFilters; ++filter) {
    filterRow(filter, perPixel, row, above, filtered.data());
    std::uint64_t sum = 0;
    for (std::size_t i = 1; i < filtered.size(); ++i) {
      sum += filtered[i] < 128 ? filtered[i] : 256u - filtered[i];
    }
    if (sum >= least) continue;
    least = sum;
    best = filter;
  }
  return best;
}

}  // namespace png
