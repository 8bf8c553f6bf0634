// Reading numbers: quick arithmetic where it is provably exact, and the C library for the rest.
// Source: Clinger, "How to Read Floating Point Numbers Accurately", PLDI 1990.
#include "scene/number_reader.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "scene/digits.h"
#include "scene/powers_of_ten.h"
#include "scene/quick_decimal.h"

namespace {

using digits::isDigit;

/// The largest power of ten that a double holds exactly.
constexpr std::int64_t kMaxExactPower = 22;
/// The doubles nearest to 10^-22 .. 10^22; exact from 1 on.
constexpr double kNearPowersOfTen[] = {
    1e-22, 1e-21, 1e-20, 1e-19, 1e-18, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11,
    1e-10, 1e-9,  1e-8,  1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1,  1e0,   1e1,
    1e2,   1e3,   1e4,   1e5,   1e6,   1e7,   1e8,   1e9,   1e10,  1e11,  1e12,  1e13,
    1e14,  1e15,  1e16,  1e17,  1e18,  1e19,  1e20,  1e21,  1e22};
/// Whole numbers up to here are doubles.
constexpr std::uint64_t kExactDoubles = std::uint64_t(1) << 53;
constexpr int kMantissaDigits = digits::kMost;

/// A number as it is written: (-1)^isNegative * mantissa * 10^exponent, where the mantissa holds
/// the first 19 significant digits. `isCut` says that digits other than 0 follow those.
struct Decimal {
  std::uint64_t mantissa = 0;
  std::int64_t exponent = 0;
  bool isNegative = false;
  bool isCut = false;
  std::string_view digits;  // the digits and the point, without sign and exponent
};

/// The number with its mantissa read again from more digits than it can hold: `exponent` grows by
/// one for each significant digit that does not fit.
Decimal withCutMantissa(Decimal number) {
  number.mantissa = 0;
  int significant = 0;
  for (const char c : number.digits) {
    if (c == '.') continue;
    const unsigned digit = unsigned(c - '0');
    if (significant < kMantissaDigits) {
      number.mantissa = number.mantissa * 10 + digit;
      significant += number.mantissa != 0;
    } else {
      ++number.exponent;
      number.isCut |= digit != 0;
    }
  }
  return number;
}

bool beginsExponent(char c) { return c == 'e' || c == 'E'; }

/// Reads `[+-] digits` after an e. Exponents beyond any sense stop growing at 10^15, which is
/// still far more than a word has digits.
bool readExponent(const char*& p, const char* end, std::int64_t& exponent) {
  const bool isNegative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  if (p == end || !isDigit(*p)) return false;
  constexpr std::int64_t kEnough = 1'000'000'000'000'000;
  std::int64_t value = 0;
  for (; p != end && isDigit(*p); ++p) {
    if (value < kEnough) value = value * 10 + (*p - '0');
  }
  exponent += isNegative ? -value : value;
  return true;
}

/// Reads the longest number that begins at `p` and returns where it ends; null where none does,
/// or one whose exponent has no digits. In line and with `number` in registers (nothing on the
/// usual path takes its address): see PartReader for what it saves.
[[gnu::always_inline]] inline const char* scanDecimal(const char* p, const char* end,
                                                      Decimal& number) {
  // No branch on the sign, which nobody can predict.
  const char sign = p != end ? *p : '0';
  number.isNegative = sign == '-';
  p += int(sign == '-') | int(sign == '+');
  const char* const start = p;
  p = digits::append(p, end, number.mantissa);
  std::int64_t count = p - start;
  if (p != end && *p == '.') {
    const char* const fraction = ++p;
    p = digits::append(p, end, number.mantissa);
    number.exponent = fraction - p;
    count -= number.exponent;
  }
  if (count == 0) return nullptr;
  number.digits = std::string_view(start, std::size_t(p - start));
  if (count > kMantissaDigits) number = withCutMantissa(number);
  if (p == end || !beginsExponent(*p)) return p;
  ++p;
  return readExponent(p, end, number.exponent) ? p : nullptr;
}

void convert(const char* text, double& value) { value = std::strtod(text, nullptr); }
void convert(const char* text, float& value) { value = std::strtof(text, nullptr); }

/// Reads a non-zero number, a word that scanDecimal takes, by the C library, from a bounded copy
/// without sign and point (so that no locale matters). No point halfway between two doubles has
/// more than 767 digits, so what follows the 800th can only matter by being there.
template <class T>
[[gnu::noinline]] bool readExactly(std::string_view word, T& value) {
  Decimal number;
  scanDecimal(word.data(), word.data() + word.size(), number);
  constexpr int kKept = 800;
  char text[kKept + 32];
  int count = 0;
  bool isMore = false;
  for (const char c : number.digits) {
    if (c == '.' || (count == 0 && c == '0')) continue;
    if (count < kKept) {
      text[count++] = c;
    } else {
      isMore |= c != '0';
    }
  }
  std::int64_t exponent = number.exponent - std::max(0, count - kMantissaDigits);
  if (isMore) {
    text[count++] = '1';
    --exponent;
  }
  constexpr std::int64_t kBeyondDouble = 400;
  if (count + exponent > kBeyondDouble) return false;
  T magnitude = 0;
  if (count + exponent > -kBeyondDouble) {
    std::snprintf(text + count, 32, "e%d", int(exponent));
    convert(text, magnitude);
    if (std::isinf(magnitude)) return false;
  }
  value = number.isNegative ? -magnitude : magnitude;
  return true;
}

double scaleByPowerOfTen(double mantissa, std::int64_t exponent) {
  const double power = kNearPowersOfTen[std::abs(exponent) + kMaxExactPower];
  return exponent < 0 ? mantissa / power : mantissa * power;
}

bool hasExactPower(const Decimal& number) {
  return number.exponent >= -kMaxExactPower && number.exponent <= kMaxExactPower;
}

/// True when `value`, known to within 4 units in its last place, rounds to the same float
/// wherever in that range the truth lies: its 29 bits beyond a float's are not near the half.
bool roundsSafelyToFloat(double value) {
  if (!(value >= double(FLT_MIN) && value < 3.4e38)) return false;
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const std::int64_t rest = std::int64_t(bits & 0x1fffffff);
  return std::abs(rest - 0x10000000) > 4;
}

/// Stores the double nearest to the number's magnitude, which is not 0, and returns true, where 128
/// bits can tell. What was cut off lies between nothing and one more in the last digit kept.
bool findByProduct(std::uint64_t mantissa, std::int64_t exponent, bool isCut, double& magnitude) {
  if (!powers_of_ten::nearest(mantissa, exponent, magnitude)) return false;
  double above = magnitude;
  if (isCut && !powers_of_ten::nearest(mantissa + 1, exponent, above)) return false;
  return above == magnitude;
}

/// The same for any number. Two exact doubles give it in one rounded operation.
[[gnu::always_inline]] inline bool findNearest(const Decimal& number, double& magnitude) {
  const bool isShort = number.mantissa <= kExactDoubles && !number.isCut;
  if (number.mantissa == 0 || (isShort && hasExactPower(number))) {
    magnitude =
        number.mantissa == 0 ? 0 : scaleByPowerOfTen(double(number.mantissa), number.exponent);
    return true;
  }
  double found;
  if (!findByProduct(number.mantissa, number.exponent, number.isCut, found)) return false;
  magnitude = found;
  return true;
}

/// The same, but to within 4 units in the last place, which is quicker: cutting, converting, the
/// power and the product each err by less than one.
[[gnu::always_inline]] inline bool findNear(const Decimal& number, double& magnitude) {
  if (!hasExactPower(number)) return findNearest(number, magnitude);
  magnitude = double(number.mantissa) * kNearPowersOfTen[number.exponent + kMaxExactPower];
  return true;
}

/// The magnitude with the number's sign, without a branch.
double signedAs(const Decimal& number, double magnitude) {
  static constexpr double kSigns[] = {1, -1};
  return magnitude * kSigns[number.isNegative];
}

/// Any number: what a QuickDecimal cannot hold.
[[gnu::noinline]] const char* scanAnyDouble(const char* p, const char* end, double& value) {
  Decimal number;
  const char* const stop = scanDecimal(p, end, number);
  if (!stop) return nullptr;
  double magnitude;
  if (findNearest(number, magnitude)) {
    value = signedAs(number, magnitude);
    return stop;
  }
  return readExactly({p, std::size_t(stop - p)}, value) ? stop : nullptr;
}

/// The same; what is not clear from near the number is rounded from its digits.
[[gnu::noinline]] const char* scanAnyFloat(const char* p, const char* end, float& value) {
  Decimal number;
  const char* const stop = scanDecimal(p, end, number);
  if (!stop) return nullptr;
  double magnitude;
  if (findNear(number, magnitude) && (number.mantissa == 0 || roundsSafelyToFloat(magnitude))) {
    value = float(signedAs(number, magnitude));
    return stop;
  }
  return readExactly({p, std::size_t(stop - p)}, value) ? stop : nullptr;
}

const char* endOf(std::string_view word) { return word.data() + word.size(); }

}  // namespace

bool isNumber(std::string_view word) {
  Decimal number;
  return scanDecimal(word.data(), endOf(word), number) == endOf(word) && !word.empty();
}

const char* scanDouble(const char* p, const char* end, double& value) {
  if (end - p >= kQuickBytes) {
    QuickDecimal quick;
    const char* const stop = scanQuickly(p, quick);
    if (stop && !beginsExponent(*stop) && toDouble(quick, value)) return stop;
  }
  return scanAnyDouble(p, end, value);
}

const char* scanFloat(const char* p, const char* end, float& value) {
  if (end - p >= kQuickBytes) {
    QuickDecimal quick;
    const char* const stop = scanQuickly(p, quick);
    if (stop && !beginsExponent(*stop) && toFloat(quick, value)) return stop;
  }
  return scanAnyFloat(p, end, value);
}

bool readDouble(std::string_view word, double& value) {
  double found;
  if (word.empty() || scanDouble(word.data(), endOf(word), found) != endOf(word)) return false;
  value = found;
  return true;
}

bool readFloat(std::string_view word, float& value) {
  float found;
  if (word.empty() || scanFloat(word.data(), endOf(word), found) != endOf(word)) return false;
  value = found;
  return true;
}

bool readInt(std::string_view word, int& value) {
  const char* p = word.data();
  const char* const end = p + word.size();
  const bool isNegative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  if (p == end) return false;
  const std::int64_t limit = std::int64_t(std::numeric_limits<int>::max()) + isNegative;
  std::int64_t magnitude = 0;
  for (; p != end; ++p) {
    if (!isDigit(*p)) return false;
    magnitude = magnitude * 10 + (*p - '0');
    if (magnitude > limit) return false;
  }
  value = int(isNegative ? -magnitude : magnitude);
  return true;
}
