// sin, cos and tan from + - * / and the bits of a double, as functions.h says: x = n pi/2 + r with
// |r| <= pi/4; n modulo 4 says which series of r, and its sign.
#include "math/functions.h"

#include <cmath>
#include <limits>

namespace math {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// pi/2 as a sum of doubles; all but the last have few bits, so that their products with a whole
// number of less than 2^20 are exact.
constexpr double kHalfPi1 = 0x1.921fb54000000p+0, kHalfPi2 = 0x1.10b4611800000p-30,
                 kHalfPi3 = 0x1.313198a000000p-61, kHalfPi4 = 0x1.701b839a25205p-92;

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
