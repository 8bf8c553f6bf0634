// Numbers: what counts as one, limits, and rounding against the C library.
#include "scene/number_reader.h"

#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>

#include "check.h"
#include "patience.h"
#include "system/worker_threads.h"

namespace {

bool isDouble(std::string_view word) {
  double value = 0;
  return readNumber(word, value);
}
/// The same bits, so that 0 and -0 differ.
bool areSame(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool areSame(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Reads a word that stands alone, and the same word in a longer text, where it may be read eight
/// bytes at a time: false unless the results are the same.
bool readInText(std::string_view word, double& value, char behind = ' ') {
  const std::string text = std::string(word) + behind + "12345678901234567890.123456e7";
  double inText = -777;
  const char* const stop = scanNumber(text.data(), text.data() + text.size(), inText);
  return readNumber(word, value) && stop == text.data() + word.size() && areSame(value, inText);
}
bool readInText(std::string_view word, float& value, char behind = ' ') {
  const std::string text = std::string(word) + behind + "12345678901234567890.123456e7";
  float inText = -777;
  const char* const stop = scanNumber(text.data(), text.data() + text.size(), inText);
  return readNumber(word, value) && stop == text.data() + word.size() && areSame(value, inText);
}

double asDouble(std::string_view word) {
  double value = -777;
  CHECK(readInText(word, value));
  return value;
}
float asFloat(std::string_view word) {
  float value = -777;
  CHECK(readInText(word, value));
  return value;
}

/// Words of every shape: few and many digits, points anywhere, exponents large and small.
std::string randomWord(std::mt19937_64& random) {
  std::string word = random() % 3 == 0 ? "-" : random() % 7 == 0 ? "+" : "";
  const unsigned mostBefore = random() % 4 == 0 ? 25 : 6, mostAfter = random() % 4 == 0 ? 25 : 9;
  const std::size_t before = random() % mostBefore;
  const std::size_t after = random() % mostAfter + (before == 0);
  for (std::size_t i = 0; i < before; ++i) word += char('0' + random() % 10);
  if (after > 0 || random() % 5 == 0) word += '.';
  for (std::size_t i = 0; i < after; ++i) word += char('0' + random() % 10);
  if (random() % 3 == 0) {
    const int range = random() % 4 == 0 ? 340 : 30;
    word += random() % 2 ? "e" : "E";
    word += std::to_string(int(random() % (2 * unsigned(range))) - range);
  }
  return word;
}

}  // namespace

TEST("every form of a number is read") {
  CHECK_EQUAL(asDouble("5"), 5.0);
  CHECK_EQUAL(asDouble("5."), 5.0);
  CHECK_EQUAL(asDouble(".5"), 0.5);
  CHECK_EQUAL(asDouble("+5"), 5.0);
  CHECK_EQUAL(asDouble("-.5e1"), -5.0);
  CHECK_EQUAL(asDouble("1e3"), 1000.0);
  CHECK_EQUAL(asDouble("1E+3"), 1000.0);
  CHECK_EQUAL(asDouble("25e-2"), 0.25);
  CHECK_EQUAL(asDouble("000000000000000000000000000012"), 12.0);
  CHECK(areSame(asDouble("-0"), -0.0));
  CHECK(areSame(asFloat("-0.0"), -0.0f));
}

TEST("what is not wholly a number is none") {
  for (const char* word :
       {"",    "+",    "-",     ".",   "+.",    "e5",       ".e5",  "1e",      "1e+",
        "5x",  "x5",   "nan",   "inf", "-inf",  "infinity", "0x10", "1 ",      " 1",
        "1,5", "1..2", "1.2.3", "--1", "1e5.0", "1e5e5",    "1f",   "\xd9\xa1"}) {
    double value = 42;
    float single = 42;
    check::report(!readNumber(word, value) && value == 42, __FILE__, __LINE__, word);
    check::report(!readNumber(word, single) && single == 42, __FILE__, __LINE__, word);
    CHECK(!isNumber(word));
  }
  CHECK(!isDouble(std::string_view("1\0", 2)));
}

TEST("numbers of every length end where they do, whatever stands behind") {
  // Up to 9 digits before the point and 18 behind: all that is read at a stretch, and the next.
  const std::string digits = "123456789012345678";
  int count = 0;
  for (std::size_t before = 0; before <= 9; ++before) {
    for (std::size_t after = 0; after <= 18; ++after) {
      for (const char* sign : {"", "-", "+"}) {
        for (const char behind : {' ', '\n', '/', ':', '}', '\0', '\xb0', '-', ','}) {
          const std::string word = sign + digits.substr(0, before) + "." + digits.substr(0, after);
          const bool isNumberMeant = before + after > 0;
          double value = 0;
          float single = 0;
          const bool isRight = readInText(word, value, behind) == isNumberMeant &&
                               readInText(word, single, behind) == isNumberMeant &&
                               (!isNumberMeant || (value == std::strtod(word.c_str(), nullptr) &&
                                                   single == std::strtof(word.c_str(), nullptr)));
          if (!isRight) check::report(false, __FILE__, __LINE__, word + behind);
          ++count;
        }
      }
    }
  }
  CHECK_EQUAL(count, 10 * 19 * 3 * 9);
}

TEST("what is no number is none in a long text either") {
  const std::string behind = " 123456789012345678901234567890";
  for (const char* word :
       {"", "+", "-", ".", "+.", "e5", ".e5", "1e", "1.5e", "1e+", "x5", "--1"}) {
    const std::string text = word + behind;
    double value = 42;
    float single = 42;
    const char* const end = text.data() + text.size();
    check::report(!scanNumber(text.data(), end, value) && value == 42, __FILE__, __LINE__, word);
    check::report(!scanNumber(text.data(), end, single) && single == 42, __FILE__, __LINE__, word);
  }
}

TEST("overflow is refused and underflow gives denormals and zero") {
  // The largest double is (2 - 2^-52) 2^1023 = 1.7976931348623157e308; half a unit more rounds up.
  CHECK_EQUAL(asDouble("1.7976931348623157e308"), std::numeric_limits<double>::max());
  CHECK(!isDouble("1.7976931348623159e308"));
  CHECK(!isDouble("1e309"));
  CHECK(!isDouble("-1e999999999999999999999"));
  CHECK(isNumber("-1e999999999999999999999"));
  CHECK_EQUAL(asDouble("5e-324"), std::numeric_limits<double>::denorm_min());
  CHECK_EQUAL(asDouble("1e-320"), 1e-320);
  CHECK(areSame(asDouble("1e-99999999999999999999"), 0.0));
  CHECK(areSame(asDouble("0e99999999999999999999"), 0.0));
  float value = 0;
  CHECK(!readNumber("1e39", value));
  CHECK(!readNumber("3.4028236e38", value));
  CHECK_EQUAL(asFloat("3.4028234e38"), std::numeric_limits<float>::max());
  CHECK_EQUAL(asFloat("1e-45"), std::numeric_limits<float>::denorm_min());
  CHECK(areSame(asFloat("-1e-60"), -0.0f));
}

TEST("a float is rounded once, not by way of a double") {
  // 1 + 2^-24 is halfway between 1 and its neighbour 1 + 2^-23, and goes to the even one, 1. A
  // trace more must round up, though a double cannot hold so small a trace.
  CHECK_EQUAL(asFloat("1.000000059604644775390625"), 1.0f);
  CHECK_EQUAL(asFloat("1.000000059604644775390625000000000000001"), std::nextafter(1.0f, 2.0f));
  CHECK_EQUAL(asFloat("1.000000059604644775390624999999999999999"), 1.0f);
  CHECK_EQUAL(asFloat("16777217"), 16777216.0f);
  CHECK_EQUAL(asFloat("16777217.0000000000000000000000000001"), 16777218.0f);
  // From 2^23 = 8388608 on floats are whole numbers. A trace of 1e-11 is lost in a double, where
  // neighbours are 2e-9 apart.
  CHECK_EQUAL(asFloat("8388608.5"), 8388608.0f);
  CHECK_EQUAL(asFloat("8388609.5"), 8388610.0f);
  CHECK_EQUAL(asFloat("8388608.50000000001"), 8388609.0f);
  CHECK_EQUAL(asFloat("-8388609.49999999999"), -8388609.0f);
}

TEST("digits beyond any buffer still decide") {
  // 2^53 + 1 lies halfway between two doubles.
  const std::string zeros(2'000'000, '0');
  CHECK_EQUAL(asDouble("9007199254740993"), 9007199254740992.0);
  CHECK_EQUAL(asDouble("9007199254740993." + zeros), 9007199254740992.0);
  CHECK_EQUAL(asDouble("9007199254740993." + zeros + "1"), 9007199254740994.0);
  CHECK_EQUAL(asDouble("1" + zeros + "e-2000000"), 1.0);
  CHECK_EQUAL(asDouble("0." + zeros + "1e2000001"), 1.0);
}

TEST("whole numbers fill their word and fit in an int") {
  int value = 42;
  CHECK(readInt("-2147483648", value) && value == std::numeric_limits<int>::min());
  CHECK(readInt("+2147483647", value) && value == std::numeric_limits<int>::max());
  CHECK(readInt("007", value) && value == 7);
  value = 42;
  for (const char* word : {"", "-", "2147483648", "-2147483649", "99999999999999999999999", "1.0",
                           "1e3", "5x", "0x1"}) {
    check::report(!readInt(word, value) && value == 42, __FILE__, __LINE__, word);
  }
}

TEST("a million random words agree with strtod and strtof to the last bit") {
  std::mt19937_64 random(20);
  int read = 0;
  for (int i = 0; i < casesFor(1'000'000); ++i) {
    const std::string word = randomWord(random);
    const double expected = std::strtod(word.c_str(), nullptr);
    const float expectedSingle = std::strtof(word.c_str(), nullptr);
    double value = 0;
    float single = 0;
    const bool isRead = readNumber(word, value), isSingleRead = readNumber(word, single);
    const bool isRight =
        isRead == std::isfinite(expected) && isSingleRead == std::isfinite(expectedSingle) &&
        (!isRead || areSame(value, expected)) && (!isSingleRead || areSame(single, expectedSingle));
    if (!isRight) check::report(false, __FILE__, __LINE__, word);
    read += isRead;
  }
  CHECK(read > casesFor(900'000));
}

TEST("ten million random words agree with std::from_chars to the last bit") {
  std::atomic<int> read{0}, wrong{0};
  runOnThreads(4, 1 << 20, [&](int seed) {
    std::mt19937_64 random(std::uint64_t(seed) + 100);
    for (int i = 0; i < casesFor(2'500'000); ++i) {
      const std::string word = randomWord(random);
      const char *const start = word.data() + (word[0] == '+'), *const end = &word[word.size()];
      double expected = 0, value = 0;
      float expectedSingle = 0, single = 0;
      const bool isIn = std::from_chars(start, end, expected).ec == std::errc();
      const bool isSingleIn = std::from_chars(start, end, expectedSingle).ec == std::errc();
      // from_chars refuses underflow, which here gives a zero or a denormal: see the tests above.
      if ((isIn && !(readInText(word, value) && areSame(value, expected))) ||
          (isSingleIn && !(readInText(word, single) && areSame(single, expectedSingle)))) {
        if (++wrong == 1) std::printf("%s\n", word.c_str());
      }
      read += isIn && isSingleIn;
    }
  });
  CHECK_EQUAL(wrong, 0);
  CHECK(read > casesFor(8'000'000));
}

TEST("numbers halfway between two floats or doubles, and a trace beside them, are rounded right") {
  std::mt19937_64 random(22);
  for (int i = 0; i < casesFor(100'000); ++i) {
    // 54 and 25 bits, the last of them set: halfway. Written out in full, with up to 60 decimals.
    const bool isSingle = i % 2 == 0;
    const std::uint64_t bits = isSingle ? random() >> 39 | 1 : random() >> 10 | 1;
    char text[128];
    std::snprintf(text, sizeof text, "%.60Lf",
                  std::ldexp(static_cast<long double>(bits), -int(random() % 60)));
    std::string word(text);
    const std::size_t kept = word.find_last_not_of('0');
    word = word.substr(0, kept + 1);
    for (const std::string& tail : {std::string(), std::string("00000000000000000000001")}) {
      const std::string full = word + tail;
      double value = 0;
      float single = 0;
      const bool isRight = readInText(full, value) && readInText(full, single) &&
                           areSame(value, std::strtod(full.c_str(), nullptr)) &&
                           areSame(single, std::strtof(full.c_str(), nullptr));
      if (!isRight) check::report(false, __FILE__, __LINE__, full);
    }
  }
  CHECK(asFloat("16777217") == 16777216.0f);
}

TEST("random doubles and floats written with all their digits come back") {
  std::mt19937_64 random(21);
  for (int i = 0; i < casesFor(200'000); ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    float single = 0;
    std::memcpy(&value, &bits, sizeof value);
    std::memcpy(&single, &bits, sizeof single);
    char text[64];
    if (std::isfinite(value)) {
      std::snprintf(text, sizeof text, "%.17g", value);
      if (!areSame(asDouble(text), value)) check::report(false, __FILE__, __LINE__, text);
    }
    if (std::isfinite(single)) {
      std::snprintf(text, sizeof text, "%.9g", double(single));
      if (!areSame(asFloat(text), single)) check::report(false, __FILE__, __LINE__, text);
    }
  }
}
