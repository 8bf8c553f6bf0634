// ImageDifference.
#include "image/difference.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

std::size_t ImageDifference::pixels() const {
  return std::accumulate(pixelsWith.begin(), pixelsWith.end(), std::size_t{0});
}

int ImageDifference::maximum() const {
  int difference = 255;
  while (difference > 0 && pixelsWith[static_cast<std::size_t>(difference)] == 0) --difference;
  return difference;
}

double ImageDifference::mean() const {
  std::size_t sum = 0;
  for (std::size_t difference = 0; difference < pixelsWith.size(); ++difference) {
    sum += difference * pixelsWith[difference];
  }
  return sum == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(pixels());
}

std::size_t ImageDifference::pixelsOver(int threshold) const {
  assert(threshold >= 0);
  const auto first = std::min(static_cast<std::size_t>(threshold) + 1, pixelsWith.size());
  return std::accumulate(pixelsWith.begin() + static_cast<std::ptrdiff_t>(first), pixelsWith.end(),
                         std::size_t{0});
}

ImageDifference compareImages(const Image& a, const Image& b) {
  if (a.Width() != b.Width() || a.Height() != b.Height()) {
    throw std::invalid_argument("images of different sizes cannot be compared");
  }
  ImageDifference result;
  for (int y = 0; y < a.Height(); ++y) {
    for (int x = 0; x < a.Width(); ++x) {
      const Rgb8 p = a.getPixel(x, y), q = b.getPixel(x, y);
      const int difference =
          std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
      ++result.pixelsWith[static_cast<std::size_t>(difference)];
    }
  }
  return result;
}
