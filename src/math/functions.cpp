// pow, sin, cos, tan, exp, log from + - * / and the bits of a double, so that they are the same on
// every machine. Each reduces its argument to a small range and sums the Taylor series there, with
// as many terms as double can tell apart:
//
//   sin, cos  x = n pi/2 + r, |r| <= pi/4; n modulo 4 says which series of r, and its sign
//   exp       x = n ln 2 + r, |r| <= ln 2 / 2; e^x = 2^n e^r
//   log       x = 2^k m, m in [sqrt(1/2), sqrt(2)); ln x = k ln 2 + ln m
//   pow       e^(y ln x)
//
// The reductions subtract numbers that nearly cancel. So that no digits are lost, ln 2 and pi/2 are
// split into a few doubles of few bits each, whose products with n are exact, subtracted one after
// the other (Cody and Waite, "Software Manual for the Elementary Functions", 1980).
#include "math/functions.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace math {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// ln 2 and pi/2 as sums of doubles; all but the last have few bits, so that their products with a
// whole number of less than 2^20 are exact.
constexpr double kLn2High = 0x1.62e42fee00000p-1, kLn2Low = 0x1.a39ef35793c76p-33;
constexpr double kHalfPi1 = 0x1.921fb54000000p+0, kHalfPi2 = 0x1.10b4611800000p-30,
                 kHalfPi3 = 0x1.313198a000000p-61, kHalfPi4 = 0x1.701b839a25205p-92;

std::uint64_t bitsOf(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

double fromBits(std::uint64_t bits) {
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// 2^k for a normal result: -1022 <= k <= 1023.
double powerOfTwo(int k) { return fromBits(std::uint64_t(k + 1023) << 52); }

/// A whole number of quarter turns and what is left, |rest| <= pi/4 (a little more by rounding).
struct Quadrant {
  int turns;  // modulo 4
  double rest;
};

/// Beyond 1e5 the products with n would no longer be exact, so whole turns are taken off first; 2
/// pi as a double is off by 1e-16 of itself, which is the error stated in the header.
Quadrant reduceRadians(double x) {
  if (std::fabs(x) > 1e5) x = std::fmod(x, 4 * kHalfPi1 + (4 * kHalfPi2 + 4 * kHalfPi3));
  const double n = std::floor(x * (2 / kPi) + 0.5);
  const double rest = (((x - n * kHalfPi1) - n * kHalfPi2) - n * kHalfPi3) - n * kHalfPi4;
  return {int(n) & 3, rest};
}

/// Whole turns and quarters of degrees are exact, so only `rest` is rounded, and is 0 at multiples
/// of 90.
Quadrant reduceDegrees(double degrees) {
  const double within = std::fmod(degrees, 360);
  const double n = std::floor(within / 90 + 0.5);
  return {int(n) & 3, radians(within - 90 * n)};
}

/// c[0] z^(count - 1) + ... + c[count - 1], by Horner's rule: the smallest terms first.
template <int count>
double polynomial(const double (&c)[count], double z) {
  double sum = c[0];
  for (int i = 1; i < count; ++i) sum = sum * z + c[i];
  return sum;
}

/// r - r^3/3! + r^5/5! ... up to r^17.
double sineSeries(double r) {
  static constexpr double kTerms[] = {
      1 / 355687428096000.0, -1 / 1307674368000.0, 1 / 6227020800.0, -1 / 39916800.0,
      1 / 362880.0,          -1 / 5040.0,          1 / 120.0,        -1 / 6.0};
  const double z = r * r;
  return r + r * (z * polynomial(kTerms, z));
}

/// 1 - r^2/2 + r^4/4! ... up to r^16.
double cosineSeries(double r) {
  static constexpr double kTerms[] = {
      1 / 20922789888000.0, -1 / 87178291200.0, 1 / 479001600.0, -1 / 3628800.0,
      1 / 40320.0,          -1 / 720.0,         1 / 24.0};
  const double z = r * r;
  return 1 - (z / 2 - z * z * polynomial(kTerms, z));
}

/// sin of a quarter turn more is cos, of half a turn more -sin.
double sineOf(const Quadrant& q) {
  const double value = (q.turns & 1) != 0 ? cosineSeries(q.rest) : sineSeries(q.rest);
  return (q.turns & 2) != 0 ? -value : value;
}

double cosineOf(const Quadrant& q) { return sineOf({(q.turns + 1) & 3, q.rest}); }

}  // namespace

double log(double x) {
  if (!(x >= 0)) return kNaN;
  if (x == 0) return -kInf;
  if (x == kInf) return kInf;
  int k = 0;
  // A subnormal has no leading one: make it normal.
  if (x < 0x1p-1022) {
    x *= 0x1p54;
    k = -54;
  }
  // x = 2^k m with m in [sqrt(1/2), sqrt(2)): the low half of the mantissa rounds k down.
  constexpr std::uint64_t kSqrtHalf = 0x3fe6a09e667f3bcdu;
  const std::uint64_t offset = bitsOf(x) - kSqrtHalf;
  k += int(std::int64_t(offset) >> 52);
  const double f = fromBits((offset & 0xfffffffffffffu) + kSqrtHalf) - 1;
  // ln(1 + f) = 2 artanh(s) = 2s + 2s^3/3 + 2s^5/5 ... with s = f / (2 + f), and 2s = f - f s.
  const double s = f / (2 + f), z = s * s;
  double sum = 2 / 25.0;
  for (int odd = 23; odd >= 3; odd -= 2) sum = sum * z + 2.0 / odd;
  return k * kLn2High + (f - (s * (f - z * sum) - k * kLn2Low));
}

double exp(double x) {
  if (!(x == x)) return x;
  if (x > 709.79) return kInf;
  if (x < -745.14) return 0;
  const double n = std::floor(x * 0x1.71547652b82fep+0 + 0.5);
  const double r = (x - n * kLn2High) - n * kLn2Low;
  // e^r = 1 + r + r^2/2! ... up to r^13.
  static constexpr double kTerms[] = {
      1 / 6227020800.0, 1 / 479001600.0, 1 / 39916800.0, 1 / 3628800.0, 1 / 362880.0, 1 / 40320.0,
      1 / 5040.0,       1 / 720.0,       1 / 120.0,      1 / 24.0,      1 / 6.0,      1 / 2.0};
  const double value = 1 + (r + r * r * polynomial(kTerms, r));
  // Two factors, since 2^n itself may be out of range where the result is not.
  const int half = int(n) / 2;
  return value * powerOfTwo(half) * powerOfTwo(int(n) - half);
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (x == 0) return y > 0 ? 0 : y < 0 ? kInf : kNaN;
  return math::exp(y * math::log(x));
}

double sin(double x) { return std::fabs(x) < kInf ? sineOf(reduceRadians(x)) : kNaN; }
double cos(double x) { return std::fabs(x) < kInf ? cosineOf(reduceRadians(x)) : kNaN; }
double tan(double x) { return math::sin(x) / math::cos(x); }

double sinDegrees(double degrees) {
  return std::fabs(degrees) < kInf ? sineOf(reduceDegrees(degrees)) : kNaN;
}
double cosDegrees(double degrees) {
  return std::fabs(degrees) < kInf ? cosineOf(reduceDegrees(degrees)) : kNaN;
}

}  // namespace math
