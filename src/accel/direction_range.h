// DirectionRange: how long the direction of a ray can be inside a Transform.
#pragma once
#include <algorithm>
#include <cmath>

#include "geometry/transform.h"

namespace accel {

struct DirectionRange {
  double least = 1, most = 1;  ///< in the world directions are unit vectors

  /// Inside `transform`, which stands where this range holds. A linear map makes no vector longer
  /// than three times its largest element times that vector.
  DirectionRange inside(const Transform& transform) const {
    return {least / (3 * largestOf(transform.getMatrix())),
            most * (3 * largestOf(transform.getInverse()))};
  }

  /// True where double holds the squares of such directions, without which the double functions of
  /// triangles and spheres give arbitrary answers; and, in a tree that scales its space by `scale`,
  /// what kernels prepare rays from.
  bool fits(double scale) const {
    return least >= 0x1p-450 && most <= 0x1p450 && least * scale >= 0x1p-900 &&
           most * scale <= 0x1p900;
  }

 private:
  static double largestOf(const Matrix& matrix) {
    double largest = 0;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        largest = std::max(largest, std::fabs(matrix.at(row, column)));
      }
    }
    return largest;
  }
};

}  // namespace accel
