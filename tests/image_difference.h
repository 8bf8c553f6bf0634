// ImageDifference: how far two images are apart.
// The difference of a pixel is the largest of its three channel differences, 0..255.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

#include "image/image.h"

/// All figures follow from how many pixels have each difference.
struct ImageDifference {
  std::array<std::size_t, 256> pixelsWith = {};  // by difference

  std::size_t pixels() const {
    return std::accumulate(pixelsWith.begin(), pixelsWith.end(), std::size_t{0});
  }
  /// The largest difference of any pixel; 0 for equal images.
  int maximum() const {
    int difference = 255;
    while (difference > 0 && pixelsWith[std::size_t(difference)] == 0) --difference;
    return difference;
  }
  /// Mean of the differences of all pixels; 0 where there are none.
  double mean() const {
    std::size_t sum = 0;
    for (std::size_t difference = 0; difference < pixelsWith.size(); ++difference) {
      sum += difference * pixelsWith[difference];
    }
    return sum == 0 ? 0 : double(sum) / double(pixels());
  }
  /// The number of pixels whose difference is greater than `threshold`, which is at least 0.
  std::size_t pixelsOver(int threshold) const {
    std::size_t count = 0;
    for (int difference = threshold + 1; difference < 256; ++difference) {
      count += pixelsWith[std::size_t(difference)];
    }
    return count;
  }
};

/// Both images have the same width and height, else std::invalid_argument is thrown.
inline ImageDifference compareImages(const Image& a, const Image& b) {
  if (a.Width() != b.Width() || a.Height() != b.Height()) {
    throw std::invalid_argument("images of different sizes cannot be compared");
  }
  ImageDifference result;
  for (int y = 0; y < a.Height(); ++y) {
    for (int x = 0; x < a.Width(); ++x) {
      const Rgb8 p = a.getPixel(x, y), q = b.getPixel(x, y);
      ++result.pixelsWith[std::size_t(
          std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}))];
    }
  }
  return result;
}
