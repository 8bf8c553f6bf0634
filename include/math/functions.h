// pow, sin, cos, tan, exp, log of our own: the same bits on every processor and C library.
// They use only + - * / and integer arithmetic on the bits, each of which IEEE 754 fixes.
// And random numbers that are a function of what they are for: no state, no order to depend on.
#pragma once
#include <cstdint>

#include "math/arithmetic.h"

namespace math {

inline constexpr double kPi = 3.14159265358979323846;

/// Radians from degrees.
constexpr double radians(double degrees) { return degrees * (kPi / 180); }

/// Natural logarithm, error below 2 ulp. log(0) is -infinity, of a negative number or NaN NaN.
double log(double x);

/// e^x, error below 2 ulp. Overflows to infinity above 709.78, underflows to 0 below -745.13.
double exp(double x);

/// x^y for x >= 0, relative error below 4e-16 (1 + |y ln x|). pow(x, 0) and pow(1, y) are 1;
/// pow(0, y) is 0 for y > 0 and infinity for y < 0. A negative x or a NaN gives NaN.
double pow(double x, double y);

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

}  // namespace math
