// Reading numbers: a fast exact path for those of few digits, and the C library for the rest.
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

namespace {

/// The powers of ten that a double holds exactly.
constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::int64_t kMaxExactPower = 22;
constexpr int kMantissaDigits = 19;  // the most that 64 bits hold whatever the digits are

/// A number as it is written: (-1)^isNegative * mantissa * 10^exponent, where the mantissa holds
/// the first 19 significant digits. `isCut` says that digits other than 0 follow those.
struct Decimal {
  std::uint64_t mantissa = 0;
  std::int64_t exponent = 0;
  bool isNegative = false;
  bool isCut = false;
  std::string_view digits;  // the digits and the point, without sign and exponent
};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Reads digits from `p` on into the mantissa, as many as it holds. Returns how many were read;
/// `exponent` grows by one for each digit that did not fit.
std::int64_t readDigits(const char*& p, const char* end, int& significant, Decimal& number) {
  const char* const start = p;
  for (; p != end && isDigit(*p); ++p) {
    const unsigned digit = unsigned(*p - '0');
    if (significant < kMantissaDigits) {
      number.mantissa = number.mantissa * 10 + digit;
      significant += number.mantissa != 0;
    } else {
      ++number.exponent;
      number.isCut |= digit != 0;
    }
  }
  return p - start;
}

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

bool readDecimal(std::string_view word, Decimal& number) {
  const char* p = word.data();
  const char* const end = p + word.size();
  number.isNegative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  const char* const start = p;
  int significant = 0;
  std::int64_t count = readDigits(p, end, significant, number);
  if (p != end && *p == '.') {
    ++p;
    const std::int64_t fraction = readDigits(p, end, significant, number);
    number.exponent -= fraction;
    count += fraction;
  }
  if (count == 0) return false;
  number.digits = std::string_view(start, std::size_t(p - start));
  if (p != end && (*p == 'e' || *p == 'E')) {
    ++p;
    if (!readExponent(p, end, number.exponent)) return false;
  }
  return p == end;
}

void convert(const char* text, double& value) { value = std::strtod(text, nullptr); }
void convert(const char* text, float& value) { value = std::strtof(text, nullptr); }

/// Reads a non-zero number by the C library, from a bounded copy without sign and point (so that no
/// locale matters). No point halfway between two doubles has more than 767 digits, so what
/// follows the 800th can only matter by being there.
template <class T>
bool readExactly(const Decimal& number, T& value) {
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
  return exponent < 0 ? mantissa / kPowersOfTen[-exponent] : mantissa * kPowersOfTen[exponent];
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

}  // namespace

bool isNumber(std::string_view word) {
  Decimal number;
  return readDecimal(word, number);
}

bool readDouble(std::string_view word, double& value) {
  Decimal number;
  if (!readDecimal(word, number)) return false;
  constexpr std::uint64_t kExactLimit = std::uint64_t(1) << 53;
  const bool isShort = number.mantissa <= kExactLimit && !number.isCut && hasExactPower(number);
  if (!isShort && number.mantissa != 0) return readExactly(number, value);
  const double magnitude =
      number.mantissa == 0 ? 0 : scaleByPowerOfTen(double(number.mantissa), number.exponent);
  value = number.isNegative ? -magnitude : magnitude;
  return true;
}

bool readFloat(std::string_view word, float& value) {
  Decimal number;
  if (!readDecimal(word, number)) return false;
  if (number.mantissa == 0) {
    value = number.isNegative ? -0.0f : 0.0f;
    return true;
  }
  if (hasExactPower(number)) {
    // Cutting, converting and scaling each err by less than one unit in the last place.
    const double magnitude = scaleByPowerOfTen(double(number.mantissa), number.exponent);
    if (roundsSafelyToFloat(magnitude)) {
      value = float(number.isNegative ? -magnitude : magnitude);
      return true;
    }
  }
  return readExactly(number, value);
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
