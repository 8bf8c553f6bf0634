// Reading numbers. Three ways, each for what the one before cannot do:
//  1. decimal.h: short numbers without an exponent, eight bytes at a time;
//  2. up to 19 digits, with an exponent or near the text's end: digit by digit, then one rounded
//     operation on two doubles that are exact. Source: Clinger, "How to Read Floating Point Numbers
//     Accurately", PLDI 1990;
//  3. the standard library, given a word of which the form is known already: from_chars where there
//     is one, which knows no locale; else strtod, given no point, the only sign of a number that
//     differs from locale to locale.
#include "scene/number_reader.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "scene/decimal.h"

namespace {

/// The most decimal digits that 64 bits hold whatever they are.
constexpr std::int64_t kMantissaDigits = 19;
/// The largest power of ten that is a double.
constexpr std::int64_t kMaxExactPower = 22;
constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// A number as it is written: (-1)^isNegative * mantissa * 10^exponent, where the mantissa is
/// right for up to kMantissaDigits digits.
struct Number {
  std::string_view digits;    // with the point, without sign and exponent
  std::int64_t exponent = 0;  // of the last digit
  std::uint64_t mantissa = 0;
  std::int64_t digitCount = 0;
  bool isNegative = false;
  const char* end = nullptr;  // null where this is no number
};

bool isSign(char c) { return c == '-' || c == '+'; }
bool beginsExponent(char c) { return c == 'e' || c == 'E'; }
const char* endOf(std::string_view word) { return word.data() + word.size(); }

/// Appends the digits from `p` on to the mantissa, modulo 2^64, and returns where they end.
const char* appendDigits(const char* p, const char* end, Number& number) {
  const char* const start = p;
  for (; p != end && decimal::isDigit(*p); ++p) {
    number.mantissa = number.mantissa * 10 + std::uint64_t(*p - '0');
  }
  number.digitCount += p - start;
  return p;
}

/// Reads `[+-] digits` after an e; returns null where there are no digits. Exponents beyond any
/// sense stop growing at 10^15, which is still far more than a word has digits.
const char* readExponent(const char* p, const char* end, std::int64_t& exponent) {
  const bool isNegative = p != end && *p == '-';
  if (p != end && isSign(*p)) ++p;
  if (p == end || !decimal::isDigit(*p)) return nullptr;
  constexpr std::int64_t kEnough = 1'000'000'000'000'000;
  std::int64_t value = 0;
  for (; p != end && decimal::isDigit(*p); ++p) {
    if (value < kEnough) value = value * 10 + (*p - '0');
  }
  exponent += isNegative ? -value : value;
  return p;
}

/// Takes the longest number that begins at `p` apart.
Number takeApart(const char* p, const char* end) {
  Number number;
  number.isNegative = p != end && *p == '-';
  if (p != end && isSign(*p)) ++p;
  const char* const start = p;
  p = appendDigits(p, end, number);
  if (p != end && *p == '.') {
    const std::int64_t before = number.digitCount;
    p = appendDigits(p + 1, end, number);
    number.exponent = before - number.digitCount;
  }
  if (number.digitCount == 0) return number;
  number.digits = std::string_view(start, std::size_t(p - start));
  number.end = p != end && beginsExponent(*p) ? readExponent(p + 1, end, number.exponent) : p;
  return number;
}

/// Stores the magnitude where one operation on two exact doubles gives it.
bool findExactly(const Number& number, double& magnitude) {
  constexpr std::uint64_t kExactDoubles = std::uint64_t(1) << 53;
  if (number.digitCount > kMantissaDigits || number.mantissa > kExactDoubles) return false;
  if (std::abs(number.exponent) > kMaxExactPower) return false;
  const double mantissa = double(number.mantissa);
  const double power = kPowersOfTen[std::abs(number.exponent)];
  magnitude = number.exponent < 0 ? mantissa / power : mantissa * power;
  return true;
}

/// The same for a float: rounded once more, which is harmless but in the middle between two floats.
/// (All numbers are 0 or among the normal floats, from 1e-22 to 2^53 1e22 = 9e37.)
bool findExactly(const Number& number, float& magnitude) {
  double exact = 0;
  if (!findExactly(number, exact) || decimal::isNearMiddle(exact, 0)) return false;
  magnitude = float(exact);
  return true;
}

void convert(const char* text, double& value) { value = std::strtod(text, nullptr); }
void convert(const char* text, float& value) { value = std::strtof(text, nullptr); }

/// Stores the magnitude of any number; false where it is too large for the type.
template <class T>
bool findByLibrary(const Number& number, T& magnitude) {
#ifdef __cpp_lib_to_chars
  // Refuses what is too small as well as what is too large.
  if (std::from_chars(number.digits.data(), number.end, magnitude).ec == std::errc()) return true;
#endif
  std::string text;
  for (const char c : number.digits) {
    if (c != '.') text += c;
  }
  text += 'e' + std::to_string(number.exponent);
  convert(text.c_str(), magnitude);
  return !std::isinf(magnitude);
}

/// Any number: what decimal.h cannot read.
template <class T>
[[gnu::noinline]] const char* scanAny(const char* p, const char* end, T& value) {
  const Number number = takeApart(p, end);
  T magnitude = 0;
  if (!number.end) return nullptr;
  if (!findExactly(number, magnitude) && !findByLibrary(number, magnitude)) return nullptr;
  value = number.isNegative ? -magnitude : magnitude;
  return number.end;
}

template <class T>
const char* scanNumber(const char* p, const char* end, T& value) {
  if (end - p >= decimal::kBytes) {
    decimal::Decimal number;
    const char* const stop = decimal::scan(p, number);
    if (stop && !beginsExponent(*stop) && decimal::round(number, value)) return stop;
  }
  return scanAny(p, end, value);
}

template <class T>
bool readWord(std::string_view word, T& value) {
  T found;
  if (word.empty() || scanNumber(word.data(), endOf(word), found) != endOf(word)) return false;
  value = found;
  return true;
}

}  // namespace

bool isNumber(std::string_view word) {
  return !word.empty() && takeApart(word.data(), endOf(word)).end == endOf(word);
}

const char* scanDouble(const char* p, const char* end, double& value) {
  return scanNumber(p, end, value);
}
const char* scanFloat(const char* p, const char* end, float& value) {
  return scanNumber(p, end, value);
}

bool readDouble(std::string_view word, double& value) { return readWord(word, value); }
bool readFloat(std::string_view word, float& value) { return readWord(word, value); }

bool readInt(std::string_view word, int& value) {
  const bool hasPlus = !word.empty() && word[0] == '+';
  if (hasPlus) word.remove_prefix(1);
  if (hasPlus && !word.empty() && word[0] == '-') return false;
  int found = 0;
  const auto [stop, error] = std::from_chars(word.data(), endOf(word), found);
  if (error != std::errc() || stop != endOf(word)) return false;
  value = found;
  return true;
}
