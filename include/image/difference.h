// ImageDifference: how far two images are apart.
// The difference of a pixel is the largest of its three channel differences, 0..255.
#pragma once
#include <array>
#include <cstddef>

#include "image/image.h"

/// All figures follow from how many pixels have each difference.
struct ImageDifference {
  std::array<std::size_t, 256> pixelsWith = {};  // by difference

  std::size_t pixels() const;
  /// The largest difference of any pixel; 0 for equal images.
  int maximum() const;
  /// Mean of the differences of all pixels; 0 where there are none.
  double mean() const;
  /// The number of pixels whose difference is greater than `threshold`, which is at least 0.
  std::size_t pixelsOver(int threshold) const;
};

/// Both images have the same width and height, else std::invalid_argument is thrown.
ImageDifference compareImages(const Image& a, const Image& b);
