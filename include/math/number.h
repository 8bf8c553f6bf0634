// What a formula may ask of its number type besides + - * / and comparisons, for float and double.
//
// A formula that is needed for many rays is a template over its number type. The course's classes
// use it with double, and what works on several rays at once with lanes::Doubles (math/lanes.h),
// which has the same functions. So it says `choose(where, a, b)` in place of `where ? a : b`, joins
// conditions by & | ! and never by && and ||, and branches only on what holds for every ray:
//
//   if (!any(where)) return ...;    // a short cut, which changes no result
//
// Its constants are double, which each number type takes, or of the number type itself. It calls no
// function of the standard library: what is compiled for one instruction set must not hold an
// inline function that other code shares, or the linker could keep the wrong one.
#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "math/arithmetic.h"

/// What goes with a number type: the answer to a comparison, and the bits as whole numbers.
template <class Number>
struct NumberParts {
  using Mask = typename Number::Mask;
  using Wholes = typename Number::Wholes;
  static Number fromBits(const Wholes& bits) { return Number::fromBits(bits); }
};
template <>
struct NumberParts<float> {
  using Mask = bool;
};
template <>
struct NumberParts<double> {
  using Mask = bool;
  using Wholes = std::uint64_t;
  static double fromBits(std::uint64_t bits) {
    double a;
    std::memcpy(&a, &bits, sizeof a);
    return a;
  }
};
template <class Number>
using MaskOf = typename NumberParts<Number>::Mask;
template <class Number>
using WholesOf = typename NumberParts<Number>::Wholes;

/// Number, for a parameter whose argument does not decide what Number is: a double will do.
template <class Number>
struct AsItIs {
  using Type = Number;
};
template <class Number>
using Plain = typename AsItIs<Number>::Type;

inline bool any(bool where) { return where; }

/// Numbers that are one number: float, double, long double.
template <class T>
using Scalar = std::enable_if_t<std::is_floating_point_v<T>, T>;

template <class T>
Scalar<T> choose(bool where, T a, T b) {
  return where ? a : b;
}

/// std::min and std::max: `a` where either is a NaN, and where they are equal.
template <class T>
constexpr Scalar<T> smaller(T a, T b) {
  return b < a ? b : a;
}
template <class T>
constexpr Scalar<T> larger(T a, T b) {
  return a < b ? b : a;
}

/// The number from 0 to 1 that is nearest to `a`; 0 where that is a NaN.
constexpr double withinUnit(double a) { return smaller(1.0, larger(0.0, a)); }

/// Without its sign; of a NaN and of -0 too.
template <class T>
Scalar<T> absolute(T a) {
  return std::fabs(a);
}
template <class T>
Scalar<T> squareRoot(T a) {
  return std::sqrt(a);
}

/// The largest whole number that is not above `a`.
inline double roundedDown(double a) { return std::floor(a); }
/// The nearest number that a float can hold.
inline double roundedToFloat(double a) { return double(float(a)); }

/// The bits of a double, and the double of such bits.
inline std::uint64_t bitsOf(double a) {
  std::uint64_t bits;
  std::memcpy(&bits, &a, sizeof bits);
  return bits;
}
template <class Number>
Number fromBits(const WholesOf<Number>& bits) {
  return NumberParts<Number>::fromBits(bits);
}
