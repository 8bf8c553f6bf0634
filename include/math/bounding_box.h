// BoundingBox: an axis-aligned box. It starts empty (low above high) and grows.
#pragma once
#include <algorithm>
#include <limits>

#include "math/vec3.h"

class BoundingBox {
 public:
  /// Empty: contains nothing, and does not change a box that it is added to.
  BoundingBox() : low_(kInf, kInf, kInf), high_(-kInf, -kInf, -kInf) {}
  BoundingBox(const Vec3d& low, const Vec3d& high) : low_(low), high_(high) {}

  const Vec3d& low() const { return low_; }
  const Vec3d& high() const { return high_; }
  bool isEmpty() const { return !(low_.x() <= high_.x()); }

  void extend(const Vec3d& point) {
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], point[axis]);
      high_[axis] = std::max(high_[axis], point[axis]);
    }
  }
  void extend(const BoundingBox& other) {
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], other.low_[axis]);
      high_[axis] = std::max(high_[axis], other.high_[axis]);
    }
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
