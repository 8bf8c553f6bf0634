// TransformError: how errors go through a Transform, by norms of its matrices' rows.
//
// A ray whose origin has coordinates up to x meets numbers up to y = in.perSize * x + in.fixed
// inside. The way in, the hit there and the way out each round numbers of that size, and the way
// out makes every error larger by out.perSize. The rounded inverse is no exact inverse: by how much
// matrix * inverse differs from the identity counts like rounding.
#include "accel/transform_range.h"

#include <cmath>

namespace accel {
namespace {

/// Each step of a hit takes at most 96 roundings of the numbers in it: twice 48.
constexpr double kSteps = 2;
constexpr double kFromError = 0x1p48;  // at least 2^53 / 48

/// What a matrix, less the identity where that is wanted, can make of a point: its linear part of
/// coordinates up to 1, and of the origin.
TransformError sizeOf(const Matrix& matrix, bool minusIdentity = false) {
  TransformError size;
  for (int row = 0; row < 3; ++row) {
    double sum = 0;
    for (int column = 0; column < 3; ++column) {
      sum += std::fabs(matrix.at(row, column) - (minusIdentity && row == column ? 1 : 0));
    }
    size.add({sum, std::fabs(matrix.at(row, 3))});
  }
  return size;
}

}  // namespace

double stretchOf(const Matrix& matrix) { return sizeOf(matrix).perSize; }

void TransformError::add(const TransformError& other) {
  // Where it cannot be told (not a number) it is anything.
  perSize = other.perSize <= perSize ? perSize : other.perSize;
  fixed = other.fixed <= fixed ? fixed : other.fixed;
}

TransformError errorThrough(const Transform& transform, const TransformError& inner) {
  const TransformError out = sizeOf(transform.getMatrix()), in = sizeOf(transform.getInverse());
  const TransformError residue = sizeOf(transform.getMatrix() * transform.getInverse(), true);
  // Inside, coordinates are up to y = in.perSize * x + in.fixed. The way in, the hit itself and
  // what is nested further err by so much for each y, times what the way out makes of it.
  const double each = out.perSize * (2 * kSteps + inner.perSize);
  return {each * in.perSize + residue.perSize * kFromError, each * in.fixed + kSteps * out.fixed +
                                                                out.perSize * inner.fixed +
                                                                residue.fixed * kFromError};
}

}  // namespace accel
