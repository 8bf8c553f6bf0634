// Decimals as files mostly write them, read eight bytes at a time: up to seven digits, a point, up
// to 15 more, no exponent. number_reader reads all others.
//
// A loop over single digits is mispredicted at most of its ends, so a run of digits is found at
// once: digits become the bytes 0 to 9, a sum marks the first byte that is none, a shift drops it
// and all behind it, and two products put the rest together as one number. (Takes half the time of
// a loop for meshes.) Source: Lemire, "Number Parsing at a Gigabyte per Second", 2021, section 7.
#pragma once
#include <cstdint>
#include <cstring>

namespace decimal {

constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// How many bytes must be there where scan() begins: a sign, seven digits, the point, twice eight
/// bytes, and the byte behind.
inline constexpr int kBytes = 26;

/// A run of up to eight digits: their number, and how many they are.
struct Digits {
  std::uint64_t number;
  unsigned count;
};

/// 10^n for n digits that are to stand behind others.
inline constexpr std::uint64_t kPowers[] = {1,      10,      100,      1000,     10000,
                                            100000, 1000000, 10000000, 100000000};

/// The digits among the eight bytes from `p` on, all of which must be there, up to the first byte
/// that is none.
[[gnu::always_inline]] inline Digits leadingDigits(const char* p) {
  std::uint64_t bytes = 0;  // the first one lowest
  std::memcpy(&bytes, p, 8);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  bytes = __builtin_bswap64(bytes);
#endif
  std::uint64_t values = bytes ^ 0x3030303030303030;
  // The highest bit of each byte that is above 9. Behind the first such byte a carry may mark
  // others wrongly.
  const std::uint64_t marks = ((values + 0x7676767676767676) | values) & 0x8080808080808080;
  unsigned count = 8;
  if (marks != 0) {
    const int bit = __builtin_ctzll(marks);  // 8 * count + 7
    count = unsigned(bit) / 8;
    values = values << 8 << (bit ^ 63);  // zeros come in as leading digits
  }
  // Four pairs p0 .. p3, each in every other byte; of those, one product has 10^6 p0 + 100 p2 in
  // its upper half, the other 10^4 p1 + p3.
  constexpr std::uint64_t kFirstAndThird = 0x000000ff000000ff;
  const std::uint64_t pairs = values * 10 + (values >> 8);
  const std::uint64_t number =
      ((pairs & kFirstAndThird) * (100 + (std::uint64_t(1000000) << 32)) +
       (pairs >> 16 & kFirstAndThird) * (1 + (std::uint64_t(10000) << 32))) >>
      32;
  return {number, count};
}

/// (-1)^isNegative * mantissa / 10^places, where mantissa < 10^18 and places <= 15.
struct Decimal {
  std::uint64_t mantissa;
  unsigned places;
  bool isNegative;
};

/// Stores the number that begins at `p`, without its exponent if it has one, and returns where it
/// ends; null where no number begins, or a longer one.
[[gnu::always_inline]] inline const char* scan(const char* p, Decimal& number) {
  // No branch on the sign, which nobody can predict.
  number.isNegative = *p == '-';
  p += int(*p == '-') | int(*p == '+');
  const Digits whole = leadingDigits(p);
  if (whole.count == 8) return nullptr;
  p += whole.count;
  number.mantissa = whole.number;
  number.places = 0;
  if (*p != '.') return whole.count > 0 ? p : nullptr;
  Digits fraction = leadingDigits(++p);
  number.mantissa = number.mantissa * kPowers[fraction.count] + fraction.number;
  number.places = fraction.count;
  if (fraction.count == 8) {
    fraction = leadingDigits(p + 8);
    if (whole.count + fraction.count > 10 || fraction.count == 8) return nullptr;
    number.mantissa = number.mantissa * kPowers[fraction.count] + fraction.number;
    number.places += fraction.count;
  }
  return whole.count + number.places > 0 ? p + number.places : nullptr;
}

/// 10^n and then -10^n, which are doubles.
inline constexpr double kScales[2][16] = {
    {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15},
    {-1, -1e1, -1e2, -1e3, -1e4, -1e5, -1e6, -1e7, -1e8, -1e9, -1e10, -1e11, -1e12, -1e13, -1e14,
     -1e15}};

/// Stores the nearest float, and returns true, where a quotient of doubles tells it. That is not
/// even 2 units in its last place off, as mantissa and quotient are rounded once each; so it must
/// lie further from the middle between two floats, told by the 29 bits that a float has not.
[[gnu::always_inline]] inline bool round(const Decimal& number, float& value) {
  constexpr std::uint64_t kRest = 0x1fffffff, kMiddle = 0x10000000, kUnits = 2;
  const double near =
      double(std::int64_t(number.mantissa)) / kScales[number.isNegative][number.places];
  std::uint64_t bits;
  std::memcpy(&bits, &near, sizeof bits);
  if (((bits + kMiddle + kUnits) & kRest) <= 2 * kUnits) return false;
  value = float(near);
  return true;
}

/// Stores the nearest double, and returns true, where both operands of the quotient are exact.
inline bool round(const Decimal& number, double& value) {
  if (number.mantissa > std::uint64_t(1) << 53) return false;
  value = double(std::int64_t(number.mantissa)) / kScales[number.isNegative][number.places];
  return true;
}

/// Reads a number behind one blank at `p` and before white space, and returns where it ends. Null,
/// and `value` is as it was, where anything stands there in another way or near the text's end.
template <class T>
[[gnu::always_inline]] inline const char* scanBehindBlank(const char* p, const char* end,
                                                          T& value) {
  if (end - p <= kBytes || *p != ' ') return nullptr;
  Decimal number;
  const char* const stop = scan(p + 1, number);
  const bool isAll = stop && (*stop == ' ' || *stop == '\n' || *stop == '\r');
  return isAll && round(number, value) ? stop : nullptr;
}

}  // namespace decimal
