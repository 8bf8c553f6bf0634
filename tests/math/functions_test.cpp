// Our own pow, log, exp, sin, cos and tan against digits from elsewhere and against the C library's
// long double functions, within the bounds that math/functions.h states.
#include "math/functions.h"

#include <limits>

#include "check.h"
#include "random.h"
#include "vectors.h"

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

/// The distance of `actual` from `expected` in units of the last place of a double that size.
double ulps(double actual, long double expected) {
  const int exponent = expected == 0 ? -1074 : std::max(std::ilogb(expected) - 52, -1074);
  return double(std::fabs(std::ldexp((long double)(actual)-expected, -exponent)));
}

std::string at(double x, double found) {
  return "at " + check::show(x) + " found " + check::show(found);
}

using Function = double (*)(double);
using Reference = long double (*)(long double);

/// The first of `count` arguments spread by `next` where function and reference differ too much.
template <class Next, class Close>
std::string firstBadArgument(int count, Next next, Function function, Reference reference,
                             Close close) {
  check::Cases cases;
  for (int i = 0; i < count; ++i) {
    const double x = next();
    const double found = function(x);
    cases.expect(close(x, found, reference(x)), [&] { return at(x, found); });
  }
  return cases.firstFailure();
}

bool withinTwoUlps(double, double found, long double expected) { return ulps(found, expected) < 2; }

/// The bound of math::sin and math::cos.
bool nearWave(double x, double found, long double expected) {
  const double bound = std::fabs(x) <= 1e5 ? 2.5e-16 : 1e-16 * std::fabs(x);
  return std::fabs(found - expected) < bound;
}

}  // namespace

// The digits below were computed with 40 digits in mpmath 1.3 for the double that is written.

TEST("log gives the digits of known logarithms") {
  CHECK(ulps(math::log(2.0), 0.69314718055994530942L) < 2);
  CHECK(ulps(math::log(10.0), 2.302585092994045684L) < 2);
  CHECK(ulps(math::log(0.1), -2.3025850929940456285L) < 2);
  CHECK(ulps(math::log(kLargest), 709.78271289338399673L) < 2);
  CHECK_EQUAL(math::log(1.0), 0.0);
}

TEST("log keeps its accuracy next to 1") {
  CHECK(ulps(math::log(1 + 0x1p-52), 2.2204460492503128343e-16L) < 2);
  CHECK(ulps(math::log(1 - 0x1p-53), -1.1102230246251566021e-16L) < 2);
}

TEST("log takes subnormal numbers") {
  CHECK(ulps(math::log(kLeast), -744.44007192138126231L) < 2);
  CHECK(ulps(math::log(3 * kLeast), std::log(3.0L) - 744.44007192138126231L) < 2);
}

TEST("log of zero, negatives, infinity and NaN") {
  CHECK_EQUAL(math::log(0.0), -kInf);
  CHECK_EQUAL(math::log(-0.0), -kInf);
  CHECK(std::isnan(math::log(-1.0)));
  CHECK(std::isnan(math::log(-kLeast)));
  CHECK(std::isnan(math::log(-kInf)));
  CHECK(std::isnan(math::log(kNan)));
  CHECK_EQUAL(math::log(kInf), kInf);
}

TEST("log stays within 2 ulp on random arguments") {
  Random random(1);
  const auto wide = [&] {
    const int exponent = random.index(2084) - 1060;
    return std::ldexp(random.uniform(0.5, 1), exponent);
  };
  CHECK_EQUAL(firstBadArgument(50000, wide, math::log, std::log, withinTwoUlps), "");
  const auto nearOne = [&] {
    const int exponent = -random.index(50);
    return 1 + std::ldexp(random.uniform(-0.5, 0.5), exponent);
  };
  CHECK_EQUAL(firstBadArgument(50000, nearOne, math::log, std::log, withinTwoUlps), "");
}

TEST("exp gives the digits of known powers of e") {
  CHECK_EQUAL(math::exp(0.0), 1.0);
  CHECK(ulps(math::exp(1.0), 2.7182818284590452354L) < 2);
  CHECK(ulps(math::exp(-1.0), 0.3678794411714423216L) < 2);
  CHECK(ulps(math::exp(0.5), 1.6487212707001281468L) < 2);
  CHECK(ulps(math::exp(10.0), 22026.465794806716517L) < 2);
  CHECK(ulps(math::exp(-700.0), 9.8596765437597708567e-305L) < 2);
  CHECK(ulps(math::exp(709.75), 1.7398368732641605577e308L) < 2);
}

TEST("exp underflows through the subnormal numbers to zero and overflows to infinity") {
  CHECK(ulps(math::exp(-740.0), 4.1887398800480489395e-322L) < 2);
  CHECK_EQUAL(math::exp(-745.2), 0.0);
  CHECK_EQUAL(math::exp(-1e300), 0.0);
  CHECK_EQUAL(math::exp(-kInf), 0.0);
  CHECK_EQUAL(math::exp(709.79), kInf);
  CHECK_EQUAL(math::exp(1e300), kInf);
  CHECK_EQUAL(math::exp(kInf), kInf);
  CHECK(std::isnan(math::exp(kNan)));
}

TEST("exp of the least numbers is 1") {
  CHECK_EQUAL(math::exp(kLeast), 1.0);
  CHECK_EQUAL(math::exp(-kLeast), 1.0);
  CHECK_EQUAL(math::exp(1e-20), 1.0);
}

TEST("exp stays within 2 ulp on random arguments") {
  Random random(2);
  const auto wide = [&] { return random.uniform(-744, 709); };
  CHECK_EQUAL(firstBadArgument(50000, wide, math::exp, std::exp, withinTwoUlps), "");
  const auto small = [&] {
    const int exponent = -random.index(60);
    return std::ldexp(random.uniform(-1, 1), exponent);
  };
  CHECK_EQUAL(firstBadArgument(50000, small, math::exp, std::exp, withinTwoUlps), "");
}

TEST("pow gives the digits of known powers") {
  const auto bound = [](double x, double y) { return 4e-16 * (1 + std::fabs(y * std::log(x))); };
  const auto good = [&](double x, double y, long double expected) {
    return std::fabs(math::pow(x, y) / expected - 1) < bound(x, y);
  };
  CHECK(good(2, 0.5, 1.4142135623730950488L));
  CHECK(good(0.9, 50, 0.005153775207320119668L));
  CHECK(good(0.99, 1000, 0.000043171247410657863678L));
  CHECK(good(3, 1.0 / 3, 1.4422495703074083823L));
  CHECK(good(10, -300, 1e-300L));
  CHECK(good(2, -200, std::ldexp(1.0L, -200)));
}

TEST("pow of zero, one, infinity, negatives and NaN") {
  for (double x : {0.0, 1.0, 7.5, kInf}) CHECK_EQUAL(math::pow(x, 0), 1.0);
  for (double y : {0.0, 1.0, -7.5, 1e300, -1e300}) CHECK_EQUAL(math::pow(1.0, y), 1.0);
  CHECK_EQUAL(math::pow(0.0, 2), 0.0);
  CHECK_EQUAL(math::pow(0.0, 1e-300), 0.0);
  CHECK_EQUAL(math::pow(0.0, -2), kInf);
  CHECK(std::isnan(math::pow(-2.0, 2)));
  CHECK(std::isnan(math::pow(-2.0, 0.5)));
  CHECK(std::isnan(math::pow(kNan, 2)));
  CHECK(std::isnan(math::pow(2.0, kNan)));
}

TEST("pow overflows to infinity and underflows to zero") {
  CHECK_EQUAL(math::pow(10.0, 400), kInf);
  CHECK_EQUAL(math::pow(10.0, -400), 0.0);
  CHECK_EQUAL(math::pow(0.5, 1e300), 0.0);
  CHECK_EQUAL(math::pow(0.5, -1e300), kInf);
}

TEST("pow keeps its stated relative error on random arguments") {
  Random random(3);
  check::Cases cases;
  while (cases.tried() < 100000) {
    const double x = random.index(2) ? random.uniform(0, 1) : random.logUniform(1e-30, 1e30);
    const double y = random.index(2) ? random.uniform(0, 200) : random.uniform(-20, 20);
    const long double expected = std::pow((long double)(x), (long double)(y));
    if (expected < 1e-300L || expected > 1e300L) continue;
    const double bound = 4e-16 * (1 + std::fabs(y * std::log(x)));
    cases.expect(std::fabs(math::pow(x, y) / expected - 1) < bound, [&] {
      return "pow(" + check::show(x) + ", " + check::show(y) +
             ") = " + check::show(math::pow(x, y));
    });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("sin, cos and tan give the digits of known angles") {
  CHECK_NEAR(math::sin(1), 0.84147098480789650665, 2.5e-16);
  CHECK_NEAR(math::cos(1), 0.5403023058681397174, 2.5e-16);
  CHECK_NEAR(math::tan(1), 1.5574077246549022305, 1e-15);
  CHECK_NEAR(math::sin(0.5), 0.47942553860420300027, 2.5e-16);
  CHECK_NEAR(math::sin(-2.5), -0.59847214410395649405, 2.5e-16);
  CHECK_NEAR(math::sin(100000), 0.035748797972016509316, 2.5e-16);
  CHECK_NEAR(math::cos(100000), -0.99936080743821245189, 2.5e-16);
  CHECK_NEAR(math::sin(1e10), -0.48750602508751069153, 1e-6);
  CHECK_NEAR(math::sin(3.141592653589793), 1.2246467991473531772e-16, 2.5e-16);
  CHECK_NEAR(math::cos(1.5707963267948966), 6.1232339957367658861e-17, 2.5e-16);
  CHECK_NEAR(math::tan(0.39269908169872414), 0.41421356237309503087, 4e-16);
}

TEST("sin and cos keep their stated error on random angles") {
  Random random(4);
  const auto turn = [&] { return random.uniform(-7, 7); };
  const auto large = [&] { return random.uniform(-1e5, 1e5); };
  const auto larger = [&] { return random.logUniform(1e5, 1e15); };
  const auto tiny = [&] {
    const int exponent = -random.index(1070);
    return std::ldexp(random.uniform(-1, 1), exponent);
  };
  CHECK_EQUAL(firstBadArgument(50000, turn, math::sin, std::sin, nearWave), "");
  CHECK_EQUAL(firstBadArgument(50000, turn, math::cos, std::cos, nearWave), "");
  CHECK_EQUAL(firstBadArgument(50000, large, math::sin, std::sin, nearWave), "");
  CHECK_EQUAL(firstBadArgument(50000, large, math::cos, std::cos, nearWave), "");
  CHECK_EQUAL(firstBadArgument(50000, larger, math::sin, std::sin, nearWave), "");
  CHECK_EQUAL(firstBadArgument(50000, larger, math::cos, std::cos, nearWave), "");
  CHECK_EQUAL(firstBadArgument(50000, tiny, math::sin, std::sin, nearWave), "");
  CHECK_EQUAL(firstBadArgument(50000, tiny, math::cos, std::cos, nearWave), "");
}

TEST("sin and cos of the largest numbers are finite and those of infinity and NaN are NaN") {
  for (double x : {1e16, -1e22, 1e100, kLargest, -kLargest}) {
    CHECK(std::isfinite(math::sin(x)));
    CHECK(std::isfinite(math::cos(x)));
  }
  for (double x : {kInf, -kInf, kNan}) {
    CHECK(std::isnan(math::sin(x)));
    CHECK(std::isnan(math::cos(x)));
    CHECK(std::isnan(math::tan(x)));
  }
}

TEST("sines and cosines of multiples of 90 degrees are exact") {
  const double sines[4] = {0, 1, 0, -1};
  check::Cases cases;
  for (int quarter = -4000; quarter <= 4000; ++quarter) {
    const int place = ((quarter % 4) + 4) % 4;
    const double degrees = 90.0 * quarter;
    const bool ok = math::sinDegrees(degrees) == sines[place] &&
                    math::cosDegrees(degrees) == sines[(place + 1) % 4];
    cases.expect(ok, [&] { return check::show(degrees) + " degrees"; });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
  // 90 x 2^50 is a multiple of 360.
  CHECK_EQUAL(math::sinDegrees(90 * 0x1p50), 0.0);
  CHECK_EQUAL(math::cosDegrees(90 * 0x1p50), 1.0);
}

TEST("sines and cosines of degrees give known digits") {
  CHECK_NEAR(math::sinDegrees(30), 0.5, 2.5e-16);
  CHECK_NEAR(math::cosDegrees(60), 0.5, 2.5e-16);
  CHECK_NEAR(math::sinDegrees(45), 0.70710678118654752440, 2.5e-16);
  CHECK_NEAR(math::sinDegrees(1), 0.017452406437283512819, 2.5e-16);
  CHECK_NEAR(math::cosDegrees(36), 0.8090169943749474241, 2.5e-16);
  CHECK_NEAR(math::sinDegrees(-20), -0.34202014332566873304, 2.5e-16);
  CHECK_NEAR(math::cosDegrees(-100), -0.17364817766693034885, 2.5e-16);
}

TEST("degrees far beyond a full turn keep their accuracy") {
  // 3.6e12 + 30 degrees is 1e10 full turns and 30 degrees, exactly.
  CHECK_NEAR(math::sinDegrees(3.6e12 + 30), 0.5, 3e-16);
  CHECK_NEAR(math::cosDegrees(-3.6e12 - 60), 0.5, 3e-16);
}

TEST("radians of 180 degrees are pi") {
  CHECK_NEAR(math::radians(180), 3.1415926535897932385, 5e-16);
  CHECK_EQUAL(math::radians(0), 0.0);
  CHECK_NEAR(math::radians(-45), -0.78539816339744830962, 2e-16);
}
