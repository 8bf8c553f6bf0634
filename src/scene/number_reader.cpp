// Reading numbers. Two ways, the second for what the first cannot do:
//  1. decimal.h: short numbers without an exponent, eight bytes at a time, then one rounded
//     operation on two doubles that are exact;
//  2. the standard library, given a word of which the form is known already: from_chars where there
//     is one, which knows no locale; else a stream in the classic one.
#include "scene/number_reader.h"

#include <charconv>
#include <locale>
#include <sstream>
#include <string>

#include "scene/decimal.h"

namespace {

bool beginsExponent(char c) { return c == 'e' || c == 'E'; }
bool isSign(char c) { return c == '-' || c == '+'; }
const char* endOf(std::string_view word) { return word.data() + word.size(); }

const char* skipSign(const char* p, const char* end) { return p != end && isSign(*p) ? p + 1 : p; }
const char* skipDigits(const char* p, const char* end) {
  while (p != end && decimal::isDigit(*p)) ++p;
  return p;
}

/// Where the longest number that begins at `p` ends; null where none begins, or where it has an
/// exponent without digits.
const char* endOfNumber(const char* p, const char* end) {
  const char* const start = skipSign(p, end);
  p = skipDigits(start, end);
  bool hasDigits = p != start;
  if (p != end && *p == '.') {
    const char* const fraction = p + 1;
    p = skipDigits(fraction, end);
    hasDigits |= p != fraction;
  }
  if (!hasDigits) return nullptr;
  if (p == end || !beginsExponent(*p)) return p;
  const char* const exponent = skipSign(p + 1, end);
  p = skipDigits(exponent, end);
  return p != exponent ? p : nullptr;
}

/// False where the number is too large. Too small a one becomes a denormal or 0, at which some
/// libraries fail too.
template <class T>
bool readFromStream(std::string_view number, T& value) {
  std::istringstream in{std::string(number)};
  in.imbue(std::locale::classic());
  return (in >> value) || (value > -1 && value < 1);
}

/// Any number: what decimal.h cannot read.
template <class T>
[[gnu::noinline]] const char* scanAny(const char* p, const char* end, T& value) {
  const char* const stop = endOfNumber(p, end);
  if (!stop) return nullptr;
  if (*p == '+') ++p;
  T found = 0;
#ifdef __cpp_lib_to_chars
  // Refuses what is too small as well as what is too large, and then says nothing of either.
  const bool isRead = std::from_chars(p, stop, found).ec == std::errc();
#else
  const bool isRead = false;
#endif
  if (!isRead && !readFromStream({p, std::size_t(stop - p)}, found)) return nullptr;
  value = found;
  return stop;
}

}  // namespace

bool isNumber(std::string_view word) {
  return !word.empty() && endOfNumber(word.data(), endOf(word)) == endOf(word);
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
bool readNumber(std::string_view word, T& value) {
  T found;
  if (word.empty() || scanNumber(word.data(), endOf(word), found) != endOf(word)) return false;
  value = found;
  return true;
}

template const char* scanNumber(const char* p, const char* end, float& value);
template const char* scanNumber(const char* p, const char* end, double& value);
template bool readNumber(std::string_view word, float& value);
template bool readNumber(std::string_view word, double& value);

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
