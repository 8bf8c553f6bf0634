// MapNoise: norms of matrices by rows.
#include "accel/map_noise.h"

#include <algorithm>
#include <cmath>

namespace accel {
namespace {

/// Each step of a hit takes at most 96 roundings of the numbers in it: twice 48.
constexpr double kSteps = 2;
constexpr double kFromError = 0x1p48;  // at least 2^53 / 48

/// What the rows of a matrix can make of a point: its linear part of coordinates up to 1, and of
/// the origin.
MapNoise sizeOf(const double (&rows)[3][4]) {
  MapNoise size;
  for (const auto& row : rows) {
    size.add({std::fabs(row[0]) + std::fabs(row[1]) + std::fabs(row[2]), std::fabs(row[3])});
  }
  return size;
}

MapNoise sizeOf(const Matrix& matrix, bool minusIdentity = false) {
  double rows[3][4];
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) rows[row][column] = matrix.at(row, column);
    if (minusIdentity) rows[row][row] -= 1;
  }
  return sizeOf(rows);
}

}  // namespace

void MapNoise::add(const MapNoise& other) {
  // Where it cannot be told (not a number) it is anything.
  perSize = other.perSize <= perSize ? perSize : other.perSize;
  fixed = other.fixed <= fixed ? fixed : other.fixed;
}

MapNoise noiseThrough(const Transform& transform, const MapNoise& inner) {
  const MapNoise out = sizeOf(transform.getMatrix()), in = sizeOf(transform.getInverse());
  const MapNoise residue = sizeOf(transform.getMatrix() * transform.getInverse(), true);
  // Inside, coordinates are up to y = in.perSize * x + in.fixed. The way in, the hit itself and
  // what is nested further err by so much for each y, times what the way out makes of it.
  const double each = out.perSize * (2 * kSteps + inner.perSize);
  return {each * in.perSize + residue.perSize * kFromError, each * in.fixed + kSteps * out.fixed +
                                                                out.perSize * inner.fixed +
                                                                residue.fixed * kFromError};
}

}  // namespace accel
