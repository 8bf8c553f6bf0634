// Comparison: one walk over both pictures, from the top left in reading order, so that the first of
// several worst pixels is the one that is named. The figures are computed from sums at the end.
#include "image/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "math/functions.h"

namespace {

constexpr Rgb8 kOnlyInOne = {255, 0, 255};

/// Of two floats, in levels; see Comparison.
double differenceOf(float e, float a) {
  if (e == a || (std::isnan(e) && std::isnan(a))) return 0;
  const double difference = std::fabs(double(e) - double(a));
  if (!std::isfinite(difference)) return std::numeric_limits<double>::infinity();
  return difference * 255 / std::max(1.0, std::fabs(double(e)));
}

/// Of the samples at column x of the row that is y-th from the top, which both pictures have.
std::array<double, 3> differencesAt(int x, int y, const ReadPicture& expected,
                                    const ReadPicture& actual) {
  const int ye = expected.image.Height() - 1 - y, ya = actual.image.Height() - 1 - y;
  if (expected.exact.Width() > 0 && actual.exact.Width() > 0) {
    const Vec3f e = expected.exact.getPixel(x, ye), a = actual.exact.getPixel(x, ya);
    return {differenceOf(e.r(), a.r()), differenceOf(e.g(), a.g()), differenceOf(e.b(), a.b())};
  }
  const Rgb8 e = expected.image.getPixel(x, ye), a = actual.image.getPixel(x, ya);
  return {std::fabs(e.r - a.r), std::fabs(e.g - a.g), std::fabs(e.b - a.b)};
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

/// From the sums over all samples of the differences and of their squares; see Comparison.
void setFigures(double sum, double squares, Comparison& result) {
  const double samples = 3.0 * double(result.pixels);
  result.mean = sum / samples;
  result.rms = std::sqrt(squares / samples);
  result.psnr = squares == 0 ? std::numeric_limits<double>::infinity()
                             : 20 * math::log(255 / result.rms) / math::log(10.0);
}

/// A sample's difference, made visible.
std::uint8_t enlarged(double difference) {
  return std::uint8_t(std::min(255.0, kDifferenceGain * difference));
}

bool holds(const Image& image, int x, int y) { return x < image.Width() && y < image.Height(); }

}  // namespace

double Comparison::percentOver() const {
  return pixels == 0 ? 0 : 100.0 * double(pixelsOver) / double(pixels);
}

Comparison compare(const ReadPicture& expected, const ReadPicture& actual, int tolerance) {
  const int width = expected.image.Width(), height = expected.image.Height();
  if (width != actual.image.Width() || height != actual.image.Height()) {
    throw std::invalid_argument("pictures of different sizes cannot be compared");
  }
  Comparison result;
  result.pixels = std::size_t(width) * std::size_t(height);
  double sum = 0, squares = 0;  // of bytes exact: 65025 * 3 * 2^32 is below 2^53
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::array<double, 3> samples = differencesAt(x, y, expected, actual);
      for (const double difference : samples) {
        sum += difference;
        squares += difference * difference;
      }
      const double largest = *std::max_element(samples.begin(), samples.end());
      if (largest > tolerance) addOver(x, y, result);
      if (largest <= result.maximum) continue;  // the first one of the largest stays
      result.maximum = largest;
      result.worstX = x;
      result.worstY = y;
    }
  }
  setFigures(sum, squares, result);
  return result;
}

Image differencePicture(const ReadPicture& expected, const ReadPicture& actual) {
  const Image &e = expected.image, &a = actual.image;
  Image picture(std::max(e.Width(), a.Width()), std::max(e.Height(), a.Height()));
  for (int y = 0; y < picture.Height(); ++y) {
    for (int x = 0; x < picture.Width(); ++x) {
      Rgb8 pixel;
      if (holds(e, x, y) && holds(a, x, y)) {
        const std::array<double, 3> samples = differencesAt(x, y, expected, actual);
        pixel = {enlarged(samples[0]), enlarged(samples[1]), enlarged(samples[2])};
      } else if (holds(e, x, y) || holds(a, x, y)) {
        pixel = kOnlyInOne;
      }
      picture.setPixel(x, picture.Height() - 1 - y, pixel);
    }
  }
  return picture;
}
