// Vec3: a point, a direction, a normal or a colour, three components of one type; and Vec2, a place
// on a picture.
// Convention: Vec3f holds colours, Vec3d holds geometry. Widening is implicit, narrowing is not.
// Vec3<lanes::Doubles> is the vectors of several rays, for formulas of any width: see number.h.
#pragma once
#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>

#include "math/number.h"

template <class T>
class Vec3 {
 public:
  constexpr Vec3() : v_{} {}
  constexpr Vec3(T x, T y, T z) : v_{x, y, z} {}

  /// Widening (float to double) is exact and implicit.
  template <class U,
            std::enable_if_t<std::is_floating_point_v<T> && (sizeof(U) < sizeof(T)), int> = 0>
  constexpr Vec3(const Vec3<U>& other) : v_{T(other.x()), T(other.y()), T(other.z())} {}
  /// Narrowing (double to float) rounds each component to nearest and must be asked for.
  template <class U, std::enable_if_t<(sizeof(U) > sizeof(T)), int> = 0>
  constexpr explicit Vec3(const Vec3<U>& other) : v_{T(other.x()), T(other.y()), T(other.z())} {}

  /// From three doubles in a row, the same ones for every ray.
  static Vec3 of(const double* three) { return {three[0], three[1], three[2]}; }

  constexpr T x() const { return v_[0]; }
  constexpr T y() const { return v_[1]; }
  constexpr T z() const { return v_[2]; }
  constexpr T r() const { return v_[0]; }
  constexpr T g() const { return v_[1]; }
  constexpr T b() const { return v_[2]; }
  /// Component `axis`: 0 is x, 1 is y, 2 is z; anything else is the caller's mistake.
  constexpr T operator[](int axis) const {
    assert(axis >= 0 && axis < 3);
    return v_[axis];
  }
  constexpr T& operator[](int axis) {
    assert(axis >= 0 && axis < 3);
    return v_[axis];
  }

  constexpr Vec3& operator+=(const Vec3& o) { return *this = *this + o; }
  constexpr Vec3& operator-=(const Vec3& o) { return *this = *this - o; }
  constexpr Vec3& operator*=(const Vec3& o) { return *this = *this * o; }
  constexpr Vec3& operator*=(T s) { return *this = *this * s; }

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x() + b.x(), a.y() + b.y(), a.z() + b.z()};
  }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
  }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x(), -a.y(), -a.z()}; }
  /// Componentwise, as colours are filtered. The scalar product is dot().
  friend constexpr Vec3 operator*(const Vec3& a, const Vec3& b) {
    return {a.x() * b.x(), a.y() * b.y(), a.z() * b.z()};
  }
  friend constexpr Vec3 operator*(const Vec3& a, T s) { return {a.x() * s, a.y() * s, a.z() * s}; }
  friend constexpr Vec3 operator*(T s, const Vec3& a) { return a * s; }
  friend constexpr Vec3 operator/(const Vec3& a, T s) { return {a.x() / s, a.y() / s, a.z() / s}; }
  friend constexpr bool operator==(const Vec3& a, const Vec3& b) {
    return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
  }
  friend constexpr bool operator!=(const Vec3& a, const Vec3& b) { return !(a == b); }

 private:
  T v_[3];
};

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

/// A place in two dimensions: on the image plane, in a texture, in pixels.
template <class T>
class Vec2 {
 public:
  constexpr Vec2() : x_(0), y_(0) {}
  constexpr Vec2(T x, T y) : x_(x), y_(y) {}

  /// From another component type; widening a Vec2f to a Vec2d is exact.
  template <class U>
  constexpr Vec2(const Vec2<U>& other) : x_(T(other.x())), y_(T(other.y())) {}

  /// To the right and up.
  constexpr T x() const { return x_; }
  constexpr T y() const { return y_; }

 private:
  T x_, y_;
};

using Vec2f = Vec2<float>;
using Vec2d = Vec2<double>;

/// The scalar product, summed in the order x, y, z. Products beyond the type's range overflow to
/// infinity, and to NaN where two of them differ in sign; below it they vanish.
template <class T>
constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// Right-handed cross product, overflowing as dot does. cross(b, a) is exactly -cross(a, b), bit
/// for bit, which the triangle test relies on.
template <class T>
constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// Euclidean length; 0 for the zero vector. Components beyond the square root of the type's
/// range overflow to infinity.
template <class T>
T length(const Vec3<T>& a) {
  return squareRoot(dot(a, a));
}

/// The unit vector along `a`, to within rounding. A zero vector, and one so short that its square
/// vanishes, gives NaNs or infinities: callers rule it out first.
template <class T>
Vec3<T> normalize(const Vec3<T>& a) {
  return a / length(a);
}

/// The largest absolute component; 0 only for the zero vector. NaNs are passed over.
template <class T>
T maxAbs(const Vec3<T>& a) {
  return larger(larger(larger(T(0), absolute(a.x())), absolute(a.y())), absolute(a.z()));
}

/// The axis of the largest absolute component, the first of equal ones.
template <class T>
int longestAxis(const Vec3<T>& a) {
  const int axis = absolute(a.y()) > absolute(a.x()) ? 1 : 0;
  return absolute(a.z()) > absolute(a[axis]) ? 2 : axis;
}

/// The smaller, and the larger, of each pair of components. Where one is NaN, that of `a`.
template <class T>
Vec3<T> least(const Vec3<T>& a, const Vec3<T>& b) {
  return {smaller(a.x(), b.x()), smaller(a.y(), b.y()), smaller(a.z(), b.z())};
}
template <class T>
Vec3<T> largest(const Vec3<T>& a, const Vec3<T>& b) {
  return {larger(a.x(), b.x()), larger(a.y(), b.y()), larger(a.z(), b.z())};
}

/// Functions of number.h, of each component.
template <class T>
Vec3<T> absolute(const Vec3<T>& a) {
  return {absolute(a.x()), absolute(a.y()), absolute(a.z())};
}
template <class T>
Vec3<T> roundedToFloat(const Vec3<T>& a) {
  return {roundedToFloat(a.x()), roundedToFloat(a.y()), roundedToFloat(a.z())};
}
template <class T>
Vec3<T> choose(const MaskOf<T>& where, const Vec3<T>& a, const Vec3<T>& b) {
  return {choose(where, a.x(), b.x()), choose(where, a.y(), b.y()), choose(where, a.z(), b.z())};
}

/// Where any component is other than 0; a NaN is.
template <class T>
MaskOf<T> isNotZero(const Vec3<T>& a) {
  const T x = a.x(), y = a.y(), z = a.z();
  return (x != 0) | (y != 0) | (z != 0);
}

/// True when any component is greater than 0: such a colour reflects or lets something through.
constexpr bool anyPositive(const Vec3f& c) { return c.r() > 0 || c.g() > 0 || c.b() > 0; }
