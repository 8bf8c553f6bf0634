// Comparison: the figures that tell how far a picture is from the one that was expected.
// Places are counted from the top left, x to the right and y downwards, as viewers show them.
#pragma once
#include <cstddef>

#include "image/image.h"

/// A picture as it was read.
struct ReadPicture {
  Image image;
  FloatImage exact{};  ///< the same in floats, where the file has more than bytes; else no pixels
};

/// A sample is one of the three components of a pixel. Differences are in levels, 1/255 of the
/// brightest that a screen shows. Where both pictures have floats, these are compared: a difference
/// is absolute up to 1, and above it relative to the expected sample, |e - a| 255 / max(1, |e|).
/// NaN differs from all but NaN, and an infinity from all but itself, by infinity. Else bytes are
/// compared. The difference of a pixel is the largest of those of its samples.
struct Comparison {
  /// The largest difference of a pixel; a whole number where bytes are compared.
  double maximum = 0;
  double mean = 0;  ///< sum of the differences of all 3 W H samples, divided by 3 W H
  double rms = 0;   ///< square root of the sum of their squares, divided by 3 W H
  double psnr = 0;  ///< 20 log10(255 / rms) decibels; infinity for equal pictures

  std::size_t pixels = 0;
  std::size_t pixelsOver = 0;  ///< whose difference is greater than the tolerance
  /// The pixel of the largest difference, the first one in reading order; (0, 0) where all agree.
  int worstX = 0, worstY = 0;
  /// The smallest box around the pixels over the tolerance; of no width where there are none.
  int boxX = 0, boxY = 0, boxWidth = 0, boxHeight = 0;

  /// 100 pixelsOver / pixels.
  double percentOver() const;
};

/// Both pictures have the same width and height, else std::invalid_argument is thrown.
/// `tolerance` is in levels, at least 0.
Comparison compare(const ReadPicture& expected, const ReadPicture& actual, int tolerance);

/// How many times the differences in differencePicture are enlarged.
inline constexpr int kDifferenceGain = 16;

/// Each sample is min(255, kDifferenceGain times the difference): black where the pictures agree.
/// Pictures of different sizes are laid with their top left corners on each other; where only one
/// of them has a pixel it is magenta.
Image differencePicture(const ReadPicture& expected, const ReadPicture& actual);
