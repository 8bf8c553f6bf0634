// RayRange: how far off a ray can start, and how long its direction can be, inside a Transform.
// Beyond what is allowed here, squares in the double functions of triangles and spheres overflow or
// underflow, and their answers are arbitrary; boxes and kernels then tell nothing of them.
#pragma once
#include <algorithm>
#include <cmath>

#include "geometry/transform.h"

namespace accel {

struct RayRange {
  /// Rays that start further off in the world are not taken.
  static constexpr double kFarthest = 0x1p300;

  double farthest = kFarthest;  ///< the largest coordinate of an origin
  double least = 1, most = 1;   ///< of a direction's length: in the world all are unit vectors

  /// Not by maxAbs, to which a coordinate that is no number is nothing.
  static bool holds(const Ray& ray) {
    const Vec3d& origin = ray.getOrigin();
    return std::fabs(origin.x()) <= kFarthest && std::fabs(origin.y()) <= kFarthest &&
           std::fabs(origin.z()) <= kFarthest;
  }

  /// Inside `transform`, which stands where this range holds. A linear map makes no vector longer
  /// than three times its largest element times that vector.
  RayRange inside(const Transform& transform) const {
    const Matrix& inverse = transform.getInverse();
    const Vec3d offset(inverse.at(0, 3), inverse.at(1, 3), inverse.at(2, 3));
    const double growth = 3 * largestOf(inverse);
    return {farthest * growth + maxAbs(offset), least / (3 * largestOf(transform.getMatrix())),
            most * growth};
  }

  /// True where the double functions are sure of themselves, and so are kernels in a tree that
  /// scales its space by `scale`.
  bool fits(double scale) const {
    return farthest <= 0x1p500 && least >= 0x1p-450 && most <= 0x1p450 &&
           least * scale >= 0x1p-900 && most * scale <= 0x1p900;
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
