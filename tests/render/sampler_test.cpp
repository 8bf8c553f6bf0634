// Where samples lie in their pixels.
#include "render/sampler.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "check.h"
#include "math/functions.h"
#include "sampling.h"

using sampling::Pattern;
using sampling::samplerOf;

namespace {

constexpr int kPixels[][2] = {{0, 0}, {1, 0}, {0, 1}, {-3, 7}, {65534, -1}, {12345, 65534}};

bool isInPixel(const Vec2d& p) { return p.x() >= 0 && p.x() < 1 && p.y() >= 0 && p.y() < 1; }

/// How many of the pixel's first `count` samples lie in each cell of a grid, row by row.
std::vector<int> countInCells(const Sampler& sampler, const int (&pixel)[2], int count, int side) {
  std::vector<int> cells(std::size_t(side * side));
  for (int n = 0; n < count; ++n) {
    const Vec2d p = sampler.getSamplePosition(pixel[0], pixel[1], n);
    CHECK(isInPixel(p));
    ++cells[std::size_t(int(p.x() * side) + side * int(p.y() * side))];
  }
  return cells;
}

bool isOneEach(const std::vector<int>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](int count) { return count == 1; });
}

/// The sum over cells of (found - expected)^2 / expected.
double chiSquare(const std::vector<int>& cells, int total) {
  const double expected = double(total) / double(cells.size());
  double sum = 0;
  for (const int found : cells) sum += (found - expected) * (found - expected) / expected;
  return sum;
}

}  // namespace

TEST("numbers of samples are rounded up to a square, but not random ones") {
  const int squares[][2] = {{1, 1}, {2, 4}, {4, 4}, {5, 9}, {36, 36}, {37, 49}, {65536, 65536}};
  for (const auto& [wanted, given] : squares) {
    CHECK_EQUAL(samplerOf(Pattern::uniform, wanted).getNumSamples(), given);
    CHECK_EQUAL(samplerOf(Pattern::jittered, wanted).getNumSamples(), given);
    CHECK_EQUAL(samplerOf(Pattern::random, wanted).getNumSamples(), wanted);
  }
}

TEST("uniform samples are the centres of the cells, in every pixel") {
  const Sampler nine = samplerOf(Pattern::uniform, 9);
  for (const auto& pixel : kPixels) {
    for (int n = 0; n < 9; ++n) {
      const Vec2d p = nine.getSamplePosition(pixel[0], pixel[1], n);
      CHECK_NEAR(p.x(), (n % 3 + 0.5) / 3, 1e-15);
      CHECK_NEAR(p.y(), (n / 3 + 0.5) / 3, 1e-15);
    }
  }
  const Vec2d centre = samplerOf(Pattern::uniform, 1).getSamplePosition(4, 5, 0);
  CHECK(centre.x() == 0.5 && centre.y() == 0.5);
}

TEST("jittered samples lie one in each cell") {
  for (const int side : {1, 2, 3, 7, 16, 255, 256}) {
    for (const auto& pixel : kPixels) {
      const Sampler sampler = samplerOf(Pattern::jittered, side * side);
      CHECK(isOneEach(countInCells(sampler, pixel, side * side, side)));
    }
  }
}

TEST("jittered samples lie anywhere in their cells, evenly") {
  // 100 000 places within a cell, in 10 x 10 parts: chi-square with 99 degrees of freedom has the
  // mean 99 and the standard deviation sqrt(198) = 14.1.
  const int side = 4, pixels = 6250, parts = 10;
  const Sampler sampler = samplerOf(Pattern::jittered, side * side);
  std::vector<int> found(parts * parts);
  for (int i = 0; i < pixels; ++i) {
    for (int n = 0; n < side * side; ++n) {
      const Vec2d p = sampler.getSamplePosition(i % 100 - 20, i / 100, n);
      const double x = p.x() * side - n % side, y = p.y() * side - n / side;
      ++found[std::size_t(std::min(int(x * parts), parts - 1) +
                          parts * std::min(int(y * parts), parts - 1))];
    }
  }
  CHECK_NEAR(chiSquare(found, pixels * side * side), 99, 70);
}

TEST("random samples are evenly spread, within a pixel and from pixel to pixel") {
  // 256 cells: chi-square has the mean 255 and the standard deviation sqrt(510) = 22.6.
  const Sampler sampler = samplerOf(Pattern::random, 65536);
  for (const auto& pixel : kPixels) {
    const std::vector<int> cells = countInCells(sampler, pixel, 65536, 16);
    CHECK_NEAR(chiSquare(cells, 65536), 255, 110);
  }
  std::vector<int> acrossRows(256), acrossColumns(256);
  for (int i = -50; i < 206; ++i) {
    for (int j = -50; j < 206; ++j) {
      const Vec2d here = sampler.getSamplePosition(i, j, 0);
      const Vec2d right = sampler.getSamplePosition(i + 1, j, 0);
      const Vec2d above = sampler.getSamplePosition(i, j + 1, 0);
      ++acrossRows[std::size_t(int(here.x() * 16) + 16 * int(right.x() * 16))];
      ++acrossColumns[std::size_t(int(here.y() * 16) + 16 * int(above.y() * 16))];
    }
  }
  CHECK_NEAR(chiSquare(acrossRows, 65536), 255, 110);
  CHECK_NEAR(chiSquare(acrossColumns, 65536), 255, 110);
}

TEST("refined samples begin with jittered ones and are one in each cell at every step") {
  for (const int side : {1, 2, 3, 5}) {
    const int first = side * side, most = first * 256;
    const Sampler refined = samplerOf(Pattern::adaptive, first, most);
    const Sampler jittered = samplerOf(Pattern::jittered, first);
    CHECK_EQUAL(refined.getNumFirst(), first);
    CHECK_EQUAL(refined.getNumSamples(), most);
    for (const auto& pixel : kPixels) {
      for (int n = 0; n < first; ++n) {
        const Vec2d a = refined.getSamplePosition(pixel[0], pixel[1], n);
        const Vec2d b = jittered.getSamplePosition(pixel[0], pixel[1], n);
        CHECK(a.x() == b.x() && a.y() == b.y());
      }
      for (int step = 0; step <= 4; ++step)
        CHECK(isOneEach(countInCells(refined, pixel, first << 2 * step, side << step)));
    }
  }
}

TEST("refined numbers are rounded up to a square and to this times a power of 4") {
  CHECK_EQUAL(samplerOf(Pattern::adaptive, 5, 5).getNumFirst(), 9);
  CHECK_EQUAL(samplerOf(Pattern::adaptive, 5, 5).getNumSamples(), 9);
  CHECK_EQUAL(samplerOf(Pattern::adaptive, 5, 10).getNumSamples(), 36);
  CHECK_EQUAL(samplerOf(Pattern::adaptive, 4, 64).getNumSamples(), 64);
  CHECK_EQUAL(samplerOf(Pattern::adaptive, 4, 65).getNumSamples(), 256);
}

TEST("numbers of a sequence are drawn column by column, row by row, sample by sample") {
  SamplingOptions options;
  options.numbers = SamplingOptions::Numbers::sequence;
  options.samples = 4;
  constexpr int kHeight = 5;
  for (const Pattern pattern : {Pattern::random, Pattern::jittered}) {
    options.pattern = pattern;
    const Sampler sampler(options, kHeight);
    std::uint64_t draw = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < kHeight; ++j) {
        for (int n = 0; n < 4; ++n) {
          const double first = math::sequenceNumber(draw++), second = math::sequenceNumber(draw++);
          const Vec2d p = sampler.getSamplePosition(i, j, n);
          // A random sample draws its y first, a jittered one its x.
          const bool isRandom = pattern == Pattern::random;
          CHECK_EQUAL(p.x(), isRandom ? second : (n % 2 + first) / 2);
          CHECK_EQUAL(p.y(), isRandom ? first : (n / 2 + second) / 2);
        }
      }
    }
  }
}

TEST("adaptive samples keep the hashed numbers") {
  SamplingOptions options;
  options.pattern = Pattern::adaptive;
  options.samples = 4;
  options.maxSamples = 16;
  const Sampler hashed(options, 5);
  options.numbers = SamplingOptions::Numbers::sequence;
  const Sampler other(options, 5);
  for (int n = 0; n < 16; ++n) {
    CHECK_EQUAL(hashed.getSamplePosition(2, 3, n).x(), other.getSamplePosition(2, 3, n).x());
  }
}

TEST("an exact grid lies the same to the left and to the right of the centre") {
  SamplingOptions options;
  options.pattern = Pattern::uniform;
  options.isGridExact = true;
  for (const int side : {1, 3, 6, 7}) {
    options.samples = side * side;
    const Sampler sampler(options);
    for (int n = 0; n < side; ++n) {
      const double x = sampler.getSamplePosition(0, 0, n).x();
      CHECK_NEAR(x, (n + 0.5) / side, 0x1p-30);
      CHECK_EQUAL(x + sampler.getSamplePosition(0, 0, side - 1 - n).x(), 1.0);
      CHECK_EQUAL(x * 0x1p30, std::floor(x * 0x1p30));
    }
  }
}
