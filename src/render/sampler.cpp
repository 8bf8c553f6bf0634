// The patterns of samples.
//
// Random numbers are hashed from the pixel and a count: the nth number of a pixel is there without
// those before it, and neighbours have nothing in common. Those of a sequence are jumped to.
//
// The jittered pattern is refined like this. A grid of side s has a sample in each cell. For the
// grid of twice the side each cell is cut into four quarters: its own sample lies in one of them
// and stays there, and each of the other three gets a new one. So four times as many samples are
// again one in each cell, and those taken before are among them. Nothing is kept: which quarter of
// a cell its sample lies in is found by following the sample down from the coarsest grid.
#include "render/sampler.h"

#include <cassert>
#include <cmath>

#include "math/functions.h"

namespace {

using Pattern = SamplingOptions::Pattern;

/// What the random numbers of a pixel start from.
std::uint64_t seedOf(int i, int j) {
  return math::mixBits(std::uint64_t(std::uint32_t(i)) << 32 | std::uint32_t(j));
}

/// A point in the unit square, the `index`th of the pixel's own.
Vec2d randomPoint(std::uint64_t pixel, std::uint64_t index) {
  return {math::unitNumber(math::randomBits(pixel, 2 * index)),
          math::unitNumber(math::randomBits(pixel, 2 * index + 1))};
}

/// The point `within` (0 to below 1) cell (x, y) of a grid of `side` cells each way.
Vec2d pointInCell(int x, int y, int side, const Vec2d& within) {
  return {(x + within.x()) / side, (y + within.y()) / side};
}

/// The nearest multiple of 2^-30 to x from 0 to 1; of 1 - x it is 1 minus that.
double toGrid(double x) { return std::floor(x * 0x1p30 + 0.5) * 0x1p-30; }

/// The side of the smallest square grid with at least `samples` >= 1 cells.
int gridSide(int samples) {
  int side = 1;
  while (side * side < samples) ++side;
  return side;
}

}  // namespace

Sampler::Sampler(const SamplingOptions& options, int height)
    : options_(options),
      height_(height),
      side_(options.pattern == Pattern::center ? 1 : gridSide(options.samples)),
      first_(options.pattern == Pattern::random ? options.samples : side_ * side_),
      most_(first_) {
  while (options.pattern == Pattern::adaptive && most_ < options.maxSamples) most_ *= 4;
}

Vec2d Sampler::getSamplePosition(int i, int j, int n) const {
  assert(n >= 0 && n < getNumSamples());
  const Pattern pattern = options_.pattern;
  const bool isDrawn = pattern == Pattern::random || pattern == Pattern::jittered;
  if (isDrawn && options_.numbers == SamplingOptions::Numbers::sequence) {
    return sequencePosition(i, j, n);
  }
  if (pattern == Pattern::random) return randomPoint(seedOf(i, j), std::uint64_t(n));
  if (pattern == Pattern::jittered || pattern == Pattern::adaptive) {
    return jitteredPosition(seedOf(i, j), n);
  }
  const Vec2d middle = pointInCell(n % side_, n / side_, side_, {0.5, 0.5});
  return options_.isGridExact ? Vec2d{toGrid(middle.x()), toGrid(middle.y())} : middle;
}

/// A random sample's first draw is its y, that of a cell its x.
Vec2d Sampler::sequencePosition(int i, int j, int n) const {
  const auto pixel = std::uint64_t(i) * std::uint64_t(height_) + std::uint64_t(j);
  const std::uint64_t draw = 2 * (pixel * std::uint64_t(most_) + std::uint64_t(n));
  const double first = math::sequenceNumber(draw), second = math::sequenceNumber(draw + 1);
  if (options_.pattern == Pattern::random) return {second, first};
  return pointInCell(n % side_, n / side_, side_, {first, second});
}

Vec2d Sampler::jitteredPosition(std::uint64_t pixel, int n) const {
  int before = getNumFirst(), side = side_;
  if (n < before) return newSampleIn(pixel, {0, n % side, n / side});
  // Which grid is refined when sample n comes: the one whose samples end before it.
  Cell parent = {0, 0, 0};
  for (; n >= 4 * before; before *= 4, side *= 2) ++parent.level;
  // Each of its cells brings three new samples, to all of its quarters but that of its own sample.
  const int cell = (n - before) / 3, other = (n - before) % 3;
  parent.x = cell % side;
  parent.y = cell / side;
  const int quarter = (quarterOf(sampleIn(pixel, parent), parent) + 1 + other) % 4;
  return newSampleIn(pixel,
                     {parent.level + 1, 2 * parent.x + quarter % 2, 2 * parent.y + quarter / 2});
}

/// The sample that the grid of this level has in the cell: that of the cell around it, where it
/// lies in this quarter. At most eight levels deep.
Vec2d Sampler::sampleIn(std::uint64_t pixel, const Cell& cell) const {
  if (cell.level == 0) return newSampleIn(pixel, cell);
  const Cell around = {cell.level - 1, cell.x / 2, cell.y / 2};
  const Vec2d sample = sampleIn(pixel, around);
  const bool isHere = quarterOf(sample, around) == cell.x % 2 + 2 * (cell.y % 2);
  return isHere ? sample : newSampleIn(pixel, cell);
}

/// The quarter of the cell in which its sample lies: 0 and 1 below, 2 and 3 above.
int Sampler::quarterOf(const Vec2d& sample, const Cell& cell) const {
  const int finer = side_ << (cell.level + 1);
  return int(sample.x() * finer >= 2 * cell.x + 1) + 2 * int(sample.y() * finer >= 2 * cell.y + 1);
}

/// The sample of a cell in which no coarser grid has one.
Vec2d Sampler::newSampleIn(std::uint64_t pixel, const Cell& cell) const {
  const int side = side_ << cell.level;
  const auto index = std::uint64_t(cell.x + cell.y * side) | std::uint64_t(cell.level) << 32;
  return pointInCell(cell.x, cell.y, side, randomPoint(pixel, index));
}
