// Comparison: one walk over both pictures, from the top left in reading order, so that the first of
// several worst pixels is the one that is named. Sums are of whole numbers, which no order of
// summing changes; the figures are computed from them at the end.
#include "image/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "math/functions.h"

namespace {

constexpr Rgb8 kOnlyInOne = {255, 0, 255};

/// Sums over the samples of two pictures, exact: 65025 * 3 * 2^32 is below 2^53.
struct Sums {
  std::uint64_t differences = 0, squares = 0;
};

/// The pixel at column x of the row that is y-th from the top.
Rgb8 pixelAt(const Image& image, int x, int y) { return image.getPixel(x, image.Height() - 1 - y); }

/// Adds the differences of three samples to the sums, and returns the largest.
int addDifferences(Rgb8 e, Rgb8 a, Sums& sums) {
  int largest = 0;
  for (const int difference : {std::abs(e.r - a.r), std::abs(e.g - a.g), std::abs(e.b - a.b)}) {
    sums.differences += std::uint64_t(difference);
    sums.squares += std::uint64_t(difference * difference);
    largest = std::max(largest, difference);
  }
  return largest;
}

/// Counts the pixel, which is over the tolerance, and makes the box as large as it takes.
void addOver(int x, int y, Comparison& result) {
  if (result.pixelsOver++ == 0) {
    result.boxX = x;
    result.boxY = y;
  }
  // Rows come from the top on, so that none is above the box.
  const int right = std::max(x + 1, result.boxX + result.boxWidth);
  result.boxX = std::min(result.boxX, x);
  result.boxWidth = right - result.boxX;
  result.boxHeight = y + 1 - result.boxY;
}

/// From the sums over all three samples of a pixel; see Comparison for the formulas.
void setFigures(const Sums& sums, Comparison& result) {
  const double samples = 3.0 * double(result.pixels);
  result.mean = double(sums.differences) / samples;
  result.rms = std::sqrt(double(sums.squares) / samples);
  result.psnr = sums.squares == 0 ? std::numeric_limits<double>::infinity()
                                  : 20 * math::log(255 / result.rms) / math::log(10.0);
}

/// A sample's difference, made visible.
std::uint8_t enlarged(int e, int a) {
  return std::uint8_t(std::min(255, kDifferenceGain * std::abs(e - a)));
}

bool holds(const Image& image, int x, int y) { return x < image.Width() && y < image.Height(); }

/// What differencePicture shows at a place.
Rgb8 differenceAt(const Image& expected, const Image& actual, int x, int y) {
  const bool isExpected = holds(expected, x, y), isActual = holds(actual, x, y);
  if (isExpected != isActual) return kOnlyInOne;
  if (!isExpected) return Rgb8();
  const Rgb8 e = pixelAt(expected, x, y), a = pixelAt(actual, x, y);
  return {enlarged(e.r, a.r), enlarged(e.g, a.g), enlarged(e.b, a.b)};
}

}  // namespace

double Comparison::percentOver() const {
  return pixels == 0 ? 0 : 100.0 * double(pixelsOver) / double(pixels);
}

Comparison compare(const Image& expected, const Image& actual, int tolerance) {
  if (expected.Width() != actual.Width() || expected.Height() != actual.Height()) {
    throw std::invalid_argument("pictures of different sizes cannot be compared");
  }
  Comparison result;
  result.pixels = std::size_t(expected.Width()) * std::size_t(expected.Height());
  Sums sums;
  for (int y = 0; y < expected.Height(); ++y) {
    for (int x = 0; x < expected.Width(); ++x) {
      const int difference = addDifferences(pixelAt(expected, x, y), pixelAt(actual, x, y), sums);
      if (difference > tolerance) addOver(x, y, result);
      if (difference <= result.maximum) continue;  // the first one of the largest stays
      result.maximum = difference;
      result.worstX = x;
      result.worstY = y;
    }
  }
  setFigures(sums, result);
  return result;
}

Image differencePicture(const Image& expected, const Image& actual) {
  Image picture(std::max(expected.Width(), actual.Width()),
                std::max(expected.Height(), actual.Height()));
  for (int y = 0; y < picture.Height(); ++y) {
    for (int x = 0; x < picture.Width(); ++x) {
      picture.setPixel(x, picture.Height() - 1 - y, differenceAt(expected, actual, x, y));
    }
  }
  return picture;
}
