// What Transforms do to numbers: how far off hits may seem that are decided under them, and how
// large the numbers of rays may get there.
#pragma once
#include <cmath>

#include "geometry/transform.h"

namespace accel {

/// How far off hits may seem that are decided under Transforms.
///
/// The double functions err by a few units in the last place of the largest number that they see.
/// Under a Transform that is a number of its inside, and an error there, taken back outside, is as
/// much larger as the map stretches: a map that squeezes one axis to 1/1000 and a rotation inside
/// it make it 1000 times as large. Boxes outside have to be widened by that.
///
/// For rays whose origin has coordinates of at most x, errors are at most 48 roundings (2^-53 each)
/// of perSize * x + fixed, in the units of the space; 0 for what stands under no Transform, whose
/// errors the error bounds of the kernels hold anyway.
struct TransformError {
  double perSize = 0, fixed = 0;

  /// Takes in what else stands in the space.
  void add(const TransformError& other);
};

/// The error outside of a Transform whose inside has `inner`.
TransformError errorThrough(const Transform& transform, const TransformError& inner);

/// The most by which a matrix lengthens a vector whose components are at most 1, in its largest
/// component: the largest sum of absolute factors in a row.
double stretchOf(const Matrix& matrix);

/// How far off a ray can start, and how long its direction can be, inside a Transform. Beyond what
/// is allowed here, squares in the double functions of triangles and spheres overflow or underflow,
/// and their answers are arbitrary; boxes and kernels then tell nothing of them.
struct RayRange {
  /// Rays that start further off in the world are not taken.
  static constexpr double kFarthest = 0x1p300;

  double farthest = kFarthest;  ///< the largest coordinate of an origin
  double least = 1, most = 1;   ///< of a direction's length: in the world all are unit vectors

  /// Not by maxAbs, to which a coordinate that is no number is nothing.
  static bool holds(const Vec3d& origin) {
    return std::fabs(origin.x()) <= kFarthest && std::fabs(origin.y()) <= kFarthest &&
           std::fabs(origin.z()) <= kFarthest;
  }

  /// Inside `transform`, which stands where this range holds. A linear map makes no vector longer
  /// than twice (sqrt(3) times) its stretch.
  RayRange inside(const Transform& transform) const {
    const Matrix& inverse = transform.getInverse();
    const Vec3d offset(inverse.at(0, 3), inverse.at(1, 3), inverse.at(2, 3));
    const double growth = 2 * stretchOf(inverse);
    return {farthest * growth + maxAbs(offset), least / (2 * stretchOf(transform.getMatrix())),
            most * growth};
  }

  /// True where the double functions are sure of themselves, and so are kernels in a tree that
  /// scales its space by `scale`.
  bool fits(double scale) const {
    return farthest <= 0x1p500 && least >= 0x1p-450 && most <= 0x1p450 &&
           least * scale >= 0x1p-900 && most * scale <= 0x1p900;
  }
};

}  // namespace accel
