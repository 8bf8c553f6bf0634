// QuickDecimal: the numbers that files are full of, read without a loop: at most seven digits, a
// point, at most 15 more digits, 18 in all, and no exponent. Slower readers take all others.
#pragma once
#include <cstdint>
#include <cstring>

#include "scene/digits.h"

/// (-1)^isNegative * mantissa / 10^places, where mantissa < 10^18 and places <= 15.
struct QuickDecimal {
  std::uint64_t mantissa = 0;
  unsigned places = 0;
  bool isNegative = false;
};

/// How many bytes must be there where scanQuickly begins: a sign, seven digits, the point, twice
/// eight bytes, and the byte behind.
inline constexpr int kQuickBytes = 26;

namespace quick {

inline constexpr int kMostPlaces = 15;
/// The doubles nearest to 10^-n, and then to -10^-n.
inline constexpr double kInverses[2][kMostPlaces + 1] = {
    {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14,
     1e-15},
    {-1, -1e-1, -1e-2, -1e-3, -1e-4, -1e-5, -1e-6, -1e-7, -1e-8, -1e-9, -1e-10, -1e-11, -1e-12,
     -1e-13, -1e-14, -1e-15}};
/// 10^n and then -10^n, which are exact.
inline constexpr double kPowers[2][kMostPlaces + 1] = {
    {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15},
    {-1, -1e1, -1e2, -1e3, -1e4, -1e5, -1e6, -1e7, -1e8, -1e9, -1e10, -1e11, -1e12, -1e13, -1e14,
     -1e15}};

/// Goes on behind eight places, the last of which is at p[7]; null for 18 digits and more.
inline const char* scanLongFraction(const char* p, unsigned wholeDigits, QuickDecimal& number) {
  const digits::Run first = digits::leading(eight_bytes::load(p));
  const digits::Run more = digits::leading(eight_bytes::load(p + 8));
  if (wholeDigits + more.count > 10 || more.count == 8) return nullptr;
  number.mantissa =
      (number.mantissa * digits::kPowers[8] + first.number) * digits::kPowers[more.count] +
      more.number;
  number.places = 8 + more.count;
  return p + number.places;
}

}  // namespace quick

/// Stores the number that begins at `p`, without its exponent if it has one, and returns where it
/// ends; null where no number begins or a longer one. Two runs of digits that fit in eight bytes
/// are put together as one. (Takes 0.45 of the
/// instructions of scanDecimal in number_reader.)
[[gnu::always_inline]] inline const char* scanQuickly(const char* p, QuickDecimal& number) {
  // No branch on the sign, which nobody can predict.
  number.isNegative = *p == '-';
  p += int(*p == '-') | int(*p == '+');
  const digits::Aligned whole = digits::aligned(eight_bytes::load(p));
  if (whole.count == 8) return nullptr;
  p += whole.count;
  number.places = 0;
  if (*p != '.') {
    number.mantissa = digits::joined(whole.values);
    return whole.count > 0 ? p : nullptr;
  }
  const digits::Aligned places = digits::aligned(eight_bytes::load(++p));
  if (places.count == 8) {
    number.mantissa = digits::joined(whole.values);
    return quick::scanLongFraction(p, whole.count, number);
  }
  number.places = places.count;
  number.mantissa = whole.count + places.count <= 8
                        ? digits::joined(whole.values >> (8 * places.count) | places.values)
                        : digits::joined(whole.values) * digits::kPowers[places.count] +
                              digits::joined(places.values);
  return whole.count + places.count > 0 ? p + places.count : nullptr;
}

/// Stores the nearest float where a double that is 4 units in its last place off at most tells it:
/// its 29 bits beyond a float's are not near the half. (Converting, the inverse and the product err
/// by half a unit each.) There are no overflows or denormals among these numbers.
[[gnu::always_inline]] inline bool toFloat(const QuickDecimal& number, float& value) {
  const double near =
      double(std::int64_t(number.mantissa)) * quick::kInverses[number.isNegative][number.places];
  std::uint64_t bits;
  std::memcpy(&bits, &near, sizeof bits);
  constexpr std::uint64_t kRest = 0x1fffffff, kHalf = 0x10000000;
  if (((bits + kHalf + 4) & kRest) <= 8) return false;
  value = float(near);
  return true;
}

/// Stores the nearest double where one rounded division of exact numbers gives it.
inline bool toDouble(const QuickDecimal& number, double& value) {
  if (number.mantissa > std::uint64_t(1) << 53) return false;
  value = double(std::int64_t(number.mantissa)) / quick::kPowers[number.isNegative][number.places];
  return true;
}
