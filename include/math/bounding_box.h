// BoundingBox: an axis-aligned box, its sides included. It starts empty (low above high) and grows.
// What a box has been extended by lies within it exactly: nothing is rounded.
#pragma once
#include <algorithm>
#include <limits>

#include "math/matrix.h"

class BoundingBox {
 public:
  /// Empty: contains nothing, and does not change a box that it is added to.
  BoundingBox() : low_(kInf, kInf, kInf), high_(-kInf, -kInf, -kInf) {}
  /// From two corners, low <= high on every axis; the order is not checked.
  BoundingBox(const Vec3d& low, const Vec3d& high) : low_(low), high_(high) {}

  /// The corner of the least and of the largest coordinates; +infinity and -infinity of an empty
  /// box.
  const Vec3d& low() const { return low_; }
  const Vec3d& high() const { return high_; }
  bool isEmpty() const { return !(low_.x() <= high_.x()); }

  /// Grows until it holds `point`. A coordinate that is NaN changes nothing along its axis; an
  /// infinite one makes the box reach as far.
  void extend(const Vec3d& point) { extend(BoundingBox(point, point)); }
  /// Grows until it holds `other`.
  void extend(const BoundingBox& other) {
    low_ = least(low_, other.low_);
    high_ = largest(high_, other.high_);
  }
  /// The box whose sides stand further out by `margin`.
  BoundingBox widened(double margin) const {
    const Vec3d margins(margin, margin, margin);
    return {low_ - margins, high_ + margins};
  }
  /// The least box that holds its eight corners, and with them all its points, as
  /// matrix.transformPoint moves them, rounding included: the terms are added in the same order,
  /// each at its least or largest, and rounding keeps order. Of a box that is finite, not empty.
  BoundingBox moved(const Matrix& matrix) const {
    BoundingBox box;
    for (int row = 0; row < 3; ++row) {
      const Vec3d factors(matrix.at(row, 0), matrix.at(row, 1), matrix.at(row, 2));
      const Vec3d lows = factors * low_, highs = factors * high_;
      const Vec3d from = least(lows, highs), to = largest(lows, highs);
      box.low_[row] = from.x() + from.y() + from.z() + matrix.at(row, 3);
      box.high_[row] = to.x() + to.y() + to.z() + matrix.at(row, 3);
    }
    return box;
  }
  /// True where all of `other` lies within, its sides too; false where a coordinate of it is NaN.
  bool contains(const BoundingBox& other) const {
    return least(other.low_, low_) == low_ && largest(other.high_, high_) == high_;
  }
  /// The largest coordinate by size; infinite for an empty box.
  double extent() const { return larger(maxAbs(low_), maxAbs(high_)); }
  /// The longest side; 0 for an empty box.
  double longestSide() const {
    const Vec3d size = high_ - low_;
    return isEmpty() ? 0 : std::max({size.x(), size.y(), size.z()});
  }

 private:
  static constexpr double kInf = std::numeric_limits<double>::infinity();
  Vec3d low_, high_;
};
