// pow, sin, cos, tan, exp, log of our own: the same bits on every processor and C library, for they
// use only + - * / and integer arithmetic on the bits, each of which IEEE 754 fixes; and random
// numbers that are a function of what they are for: no state, so no order to depend on.
//
// Each reduces its argument to a small range and sums the Taylor series there, with as many terms
// as double can tell apart:
//
//   sin, cos  x = n pi/2 + r, |r| <= pi/4; n modulo 4 says which series of r, and its sign
//   exp       x = n ln 2 + r, |r| <= ln 2 / 2; e^x = 2^n e^r
//   log       x = 2^k m, m in [sqrt(1/2), sqrt(2)); ln x = k ln 2 + ln m
//   pow       e^(y ln x)
//
// The reductions subtract numbers that nearly cancel. So that no digits are lost, ln 2 and pi/2 are
// split into a few doubles of few bits each, whose products with n are exact, subtracted one after
// the other (Cody and Waite, "Software Manual for the Elementary Functions", 1980).
//
// log, exp and pow are templates over their number type (number.h): double, or several at once.
#pragma once
#include <cstdint>

#include "math/number.h"

namespace math {

inline constexpr double kPi = 3.14159265358979323846;

/// Radians from degrees.
constexpr double radians(double degrees) { return degrees * (kPi / 180); }

// ln 2 as the sum of two doubles, the first of few bits, so that its product with a whole number of
// less than 2^20 is exact.
inline constexpr double kLn2High = 0x1.62e42fee00000p-1, kLn2Low = 0x1.a39ef35793c76p-33;

/// c[0] z^(count - 1) + ... + c[count - 1], by Horner's rule: the smallest terms first.
template <int count, class Number>
Number polynomial(const double (&c)[count], const Number& z) {
  Number sum = c[0];
  for (int i = 1; i < count; ++i) sum = sum * z + c[i];
  return sum;
}

/// 2^k for a whole k of -1022..1023, for which that is a normal number.
template <class Number>
Number powerOfTwo(const Number& k) {
  // In 2^52 + 2^51 + k the lowest bits are k.
  return fromBits<Number>((bitsOf(k + 0x1.8p52) + 1023u) << 52);
}

/// Natural logarithm, error below 2 ulp. log(0) is -infinity, of a negative number or NaN NaN.
template <class Number>
Number log(Number x) {
  static_assert(sizeof(Number) >= sizeof(double), "the bits of a double are looked at");
  constexpr double kInf = __builtin_inf(), kNaN = __builtin_nan("");
  // A subnormal has no leading one: make it normal.
  const auto isSubnormal = x < 0x1p-1022;
  const Number normal = choose(isSubnormal, x * 0x1p54, x);
  // x = 2^k m with m in [sqrt(1/2), sqrt(2)): the low half of the mantissa rounds k down. The sum
  // is 2^52 times k + 1024, so not below 0; put behind the digits of 2^52, k is a double.
  constexpr std::uint64_t kSqrtHalf = 0x3fe6a09e667f3bcdu, kDigits = 0xfffffffffffffu;
  const WholesOf<Number> offset = bitsOf(normal) - kSqrtHalf;
  const WholesOf<Number> exponent = (offset + (std::uint64_t(1024) << 52)) >> 52;
  const Number k = fromBits<Number>(exponent | std::uint64_t(0x433) << 52) - (0x1p52 + 1024) -
                   choose(isSubnormal, Number(54), Number(0));
  const Number f = fromBits<Number>((offset & kDigits) + kSqrtHalf) - 1;
  // ln(1 + f) = 2 artanh(s) = 2s + 2s^3/3 + 2s^5/5 ... with s = f / (2 + f), and 2s = f - f s.
  static constexpr double kTerms[] = {2 / 25.0, 2 / 23.0, 2 / 21.0, 2 / 19.0, 2 / 17.0, 2 / 15.0,
                                      2 / 13.0, 2 / 11.0, 2 / 9.0,  2 / 7.0,  2 / 5.0,  2 / 3.0};
  const Number s = f / (2 + f), z = s * s;
  const Number ofM = f - (s * (f - z * polynomial(kTerms, z)) - k * kLn2Low);
  const Number finite = k * kLn2High + ofM;
  const Number ofEdge = choose(x == 0, Number(-kInf), choose(x == kInf, Number(kInf), finite));
  return choose(x >= 0, ofEdge, Number(kNaN));
}

/// e^x, error below 2 ulp. Overflows to infinity above 709.78, underflows to 0 below -745.13.
template <class Number>
Number exp(Number x) {
  static_assert(sizeof(Number) >= sizeof(double), "the bits of a double are looked at");
  const Number n = roundedDown(x * 0x1.71547652b82fep+0 + 0.5);
  const Number r = (x - n * kLn2High) - n * kLn2Low;
  // e^r = 1 + r + r^2/2! ... up to r^13.
  static constexpr double kTerms[] = {
      1 / 6227020800.0, 1 / 479001600.0, 1 / 39916800.0, 1 / 3628800.0, 1 / 362880.0, 1 / 40320.0,
      1 / 5040.0,       1 / 720.0,       1 / 120.0,      1 / 24.0,      1 / 6.0,      1 / 2.0};
  const Number value = 1 + (r + r * r * polynomial(kTerms, r));
  // Two factors, since 2^n itself may be out of range where the result is not.
  const Number half = roundedDown(n * 0.5);
  const Number finite = value * powerOfTwo(half) * powerOfTwo(n - half);
  const Number inRange = choose(x < -745.14, Number(0), finite);
  return choose(x > 709.79, Number(__builtin_inf()), choose(x == x, inRange, x));
}

/// x^y for x >= 0, relative error below 4e-16 (1 + |y ln x|). pow(x, 0) and pow(1, y) are 1;
/// pow(0, y) is 0 for y > 0 and infinity for y < 0. A negative x or a NaN gives NaN.
template <class Number>
Number pow(Number x, Plain<Number> y) {
  const Number ofZero = choose(y > 0, Number(0), Number(__builtin_inf()));
  const Number usual = choose((x == 0) & (y == y), ofZero, math::exp(y * math::log(x)));
  return choose((y == 0) | (x == 1), Number(1), usual);
}

/// Sine and cosine of an angle in radians, absolute error below 2.5e-16 up to |x| = 1e5 and below
/// 1e-16 |x| beyond; infinities and NaN give NaN.
double sin(double x);
double cos(double x);

/// Tangent of an angle in radians: sin(x) / cos(x).
double tan(double x);

/// Sine and cosine of an angle in degrees, exact (0, 1, -1) at multiples of 90.
double sinDegrees(double degrees);
double cosDegrees(double degrees);

/// 64 bits in which every bit of `x` has stirred every other; one to one.
/// Source: the finaliser of SplitMix64, in Steele, Lea and Flood, "Fast Splittable Pseudorandom
/// Number Generators", 2014, with the multipliers of Stafford's "Better Bit Mixing", 2011.
constexpr std::uint64_t mixBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Number `index` of the random sequence that belongs to `seed`: SplitMix64 started there.
constexpr std::uint64_t randomBits(std::uint64_t seed, std::uint64_t index) {
  return mixBits(seed + (index + 1) * 0x9e3779b97f4a7c15u);
}

/// The upper half of `bits` as one of 2^32 evenly spaced numbers from 0 to below 1.
constexpr double unitNumber(std::uint64_t bits) { return double(bits >> 32) * 0x1p-32; }

/// Number `index`, from 0, of the sequence of the classic generator drand48 begun at 0: from 0 up
/// to below 1. It goes x -> a x + c modulo 2^48 before each number, which is x / 2^48. k steps
/// together are such a step again, and 2 k steps are it twice: so it takes log2(index) of them.
/// Source: Brown, "Random Number Generation with Arbitrary Strides", 1994.
constexpr double sequenceNumber(std::uint64_t index) {
  std::uint64_t factor = 0x5DEECE66Du, offset = 0xB;  // of 2^k steps, modulo 2^64
  std::uint64_t x = 0;
  for (std::uint64_t steps = index + 1; steps != 0; steps >>= 1) {
    if ((steps & 1) != 0) x = factor * x + offset;
    offset += factor * offset;
    factor *= factor;
  }
  return double(x & 0xffffffffffffu) * 0x1p-48;
}

}  // namespace math
