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
  void extend(const Vec3d& point) {
    low_ = least(low_, point);
    high_ = largest(high_, point);
  }
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
  /// The box of its eight corners as `matrix` moves them; of one that is not empty.
  BoundingBox moved(const Matrix& matrix) const {
    BoundingBox box;
    for (int corner = 0; corner < 8; ++corner) {
      box.extend(matrix.transformPoint({((corner & 1) != 0 ? high_ : low_).x(),
                                        ((corner & 2) != 0 ? high_ : low_).y(),
                                        ((corner & 4) != 0 ? high_ : low_).z()}));
    }
    return box;
  }
  /// True where all of `other` lies within, its sides too; false where a coordinate of it is NaN.
  bool contains(const BoundingBox& other) const {
    return least(other.low_, low_) == low_ && largest(other.high_, high_) == high_;
  }
  /// The longest side; 0 for an empty box.
  double longestSide() const {
    const Vec3d size = high_ - low_;
    return isEmpty() ? 0 : std::max({size.x(), size.y(), size.z()});
  }

 private:
  static constexpr double kInf = std::numeric_limits<double>::infinity();
  Vec3d low_, high_;
};
