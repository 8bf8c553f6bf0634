// A small test framework: TEST registers a test whose name is a sentence, CHECK... report with
// file and line and go on. The runner is tests/main.cpp.
#pragma once
#include <cmath>
#include <functional>
#include <sstream>
#include <string>

namespace check {

/// Registers a test at start-up; TEST uses it.
struct Registration {
  Registration(const char* file, const char* name, void (*function)());
};

/// Records that an expression was checked, and how it came out.
void report(bool ok, const char* file, int line, const std::string& text);

/// Thrown by SKIP; ends the test, which counts as skipped.
struct Skipped {
  std::string reason;
};

template <class T>
std::string show(const T& value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

template <class A, class B>
void equal(const A& actual, const B& expected, const char* text, const char* file, int line) {
  const bool ok = actual == expected;
  report(
      ok, file, line,
      ok ? text : std::string(text) + ": found " + show(actual) + ", expected " + show(expected));
}

/// True when the difference is at most `tolerance`; false for NaN.
inline void near(double actual, double expected, double tolerance, const char* text,
                 const char* file, int line) {
  const bool ok = std::fabs(actual - expected) <= tolerance;
  report(ok, file, line,
         ok ? text
            : std::string(text) + ": found " + show(actual) + ", expected " + show(expected) +
                  " within " + show(tolerance));
}

/// Path of a folder for files that tests write; exists and is emptied by nobody.
std::string temporaryFolder();
/// Path of the folder tests/ in the source tree, and of the reference pictures (perhaps absent).
std::string testsFolder();
std::string referenceFolder();
/// The raytracer executable under test.
std::string programToTest();

}  // namespace check

#define CHECK_JOIN2(a, b) a##b
#define CHECK_JOIN(a, b) CHECK_JOIN2(a, b)
#define TEST_NAMED(name, function)                                                    \
  static void function();                                                             \
  static const check::Registration CHECK_JOIN(function, _)(__FILE__, name, function); \
  static void function()
/// TEST("a sentence that says what holds") { ... }
#define TEST(name) TEST_NAMED(name, CHECK_JOIN(test_, __LINE__))

#define CHECK(condition) check::report(bool(condition), __FILE__, __LINE__, #condition)
#define CHECK_EQUAL(actual, expected) \
  check::equal((actual), (expected), #actual " == " #expected, __FILE__, __LINE__)
#define CHECK_NEAR(actual, expected, tolerance) \
  check::near((actual), (expected), (tolerance), #actual " ~ " #expected, __FILE__, __LINE__)
#define CHECK_THROWS(expression, Type)                                       \
  do {                                                                       \
    bool thrown = false;                                                     \
    try {                                                                    \
      (void)(expression);                                                    \
    } catch (const Type&) {                                                  \
      thrown = true;                                                         \
    }                                                                        \
    check::report(thrown, __FILE__, __LINE__, #expression " throws " #Type); \
  } while (false)
#define SKIP(reason) \
  throw check::Skipped { reason }
