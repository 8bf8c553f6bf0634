// Vec2: a point on the image plane.
// Camera::generateRay takes one; both components run over [-0.5, 0.5] on a square image.
#pragma once

template <class T>
class Vec2 {
 public:
  constexpr Vec2() : x_(0), y_(0) {}
  constexpr Vec2(T x, T y) : x_(x), y_(y) {}

  /// From another component type; widening a Vec2f to a Vec2d is exact.
  template <class U>
  constexpr Vec2(const Vec2<U>& other) : x_(T(other.x())), y_(T(other.y())) {}

  /// To the right and up, in lengths of the image's longer side, 0 in its middle.
  constexpr T x() const { return x_; }
  constexpr T y() const { return y_; }

 private:
  T x_, y_;
};

using Vec2f = Vec2<float>;
using Vec2d = Vec2<double>;
