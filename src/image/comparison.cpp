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

  void add(int difference) {
    differences += static_cast<std::uint64_t>(difference);
    squares += static_cast<std::uint64_t>(difference * difference);
  }
};

struct Box {
  int left = std::numeric_limits<int>::max(), top = left, right = -1, bottom = -1;

  void add(int x, int y) {
    left = std::min(left, x);
    top = std::min(top, y);
    right = std::max(right, x);
    bottom = std::max(bottom, y);
  }
};

/// The pixel at column x of the row that is y-th from the top.
Rgb8 pixelAt(const Image& image, int x, int y) { return image.getPixel(x, image.Height() - 1 - y); }

void setFigures(const Sums& sums, Comparison& result) {
  const double samples = 3.0 * static_cast<double>(result.pixels);
  result.mean = static_cast<double>(sums.differences) / samples;
  result.rms = std::sqrt(static_cast<double>(sums.squares) / samples);
  result.psnr = sums.squares == 0 ? std::numeric_limits<double>::infinity()
                                  : 20 * math::log(255 / result.rms) / math::log(10);
}

std::uint8_t enlarged(int e, int a) {
  return static_cast<std::uint8_t>(std::min(255, kDifferenceGain * std::abs(e - a)));
}

bool holds(const Image& image, int x, int y) { return x < image.Width() && y < image.Height(); }

}  // namespace

double Comparison::percentOver() const {
  return pixels == 0 ? 0 : 100.0 * static_cast<double>(pixelsOver) / static_cast<double>(pixels);
}

Comparison compare(const Image& expected, const Image& actual, int tolerance) {
  if (expected.Width() != actual.Width() || expected.Height() != actual.Height()) {
    throw std::invalid_argument("pictures of different sizes cannot be compared");
  }
  Comparison result;
  result.pixels = std::size_t(expected.Width()) * std::size_t(expected.Height());
  Sums sums;
  Box box;
  for (int y = 0; y < expected.Height(); ++y) {
    for (int x = 0; x < expected.Width(); ++x) {
      const Rgb8 e = pixelAt(expected, x, y), a = pixelAt(actual, x, y);
      const int samples[] = {std::abs(e.r - a.r), std::abs(e.g - a.g), std::abs(e.b - a.b)};
      for (const int sample : samples) sums.add(sample);
      const int difference = std::max({samples[0], samples[1], samples[2]});
      if (difference > result.maximum) {
        result.maximum = difference;
        result.worstX = x;
        result.worstY = y;
      }
      if (difference <= tolerance) continue;
      ++result.pixelsOver;
      box.add(x, y);
    }
  }
  setFigures(sums, result);
  if (result.pixelsOver == 0) return result;
  result.boxX = box.left;
  result.boxY = box.top;
  result.boxWidth = box.right - box.left + 1;
  result.boxHeight = box.bottom - box.top + 1;
  return result;
}

Image differencePicture(const Image& expected, const Image& actual) {
  Image picture(std::max(expected.Width(), actual.Width()),
                std::max(expected.Height(), actual.Height()));
  for (int y = 0; y < picture.Height(); ++y) {
    for (int x = 0; x < picture.Width(); ++x) {
      Rgb8 pixel = kOnlyInOne;
      if (holds(expected, x, y) && holds(actual, x, y)) {
        const Rgb8 e = pixelAt(expected, x, y), a = pixelAt(actual, x, y);
        pixel = {enlarged(e.r, a.r), enlarged(e.g, a.g), enlarged(e.b, a.b)};
      } else if (!holds(expected, x, y) && !holds(actual, x, y)) {
        pixel = Rgb8();
      }
      picture.setPixel(x, picture.Height() - 1 - y, pixel);
    }
  }
  return picture;
}
