// Checks for vectors, and the text of a failing case.
#pragma once
#include <ostream>
#include <string>

#include "check.h"
#include "math/vec3.h"

template <class T>
std::ostream& operator<<(std::ostream& out, const Vec3<T>& v) {
  return out << '(' << v.x() << ", " << v.y() << ", " << v.z() << ')';
}

namespace check {

/// True when every component differs by at most `tolerance`; false for NaN.
template <class A, class B>
void nearVector(const Vec3<A>& actual, const Vec3<B>& expected, double tolerance, const char* text,
                const char* file, int line) {
  bool ok = true;
  for (int axis = 0; axis < 3; ++axis)
    ok = ok && std::fabs(double(actual[axis]) - double(expected[axis])) <= tolerance;
  report(ok, file, line,
         ok ? text
            : std::string(text) + ": found " + show(actual) + ", expected " + show(expected) +
                  " within " + show(tolerance));
}

/// Many cases under one check: remembers the first that failed and how many were tried.
class Cases {
 public:
  /// `describe` returns the text of the case; it is only called for the first failure.
  template <class Describe>
  void expect(bool ok, Describe describe) {
    ++tried_;
    if (ok || !firstFailure_.empty()) return;
    firstFailure_ = "case " + std::to_string(tried_) + ": " + describe();
  }
  int tried() const { return tried_; }
  /// Empty where all went well.
  const std::string& firstFailure() const { return firstFailure_; }

 private:
  int tried_ = 0;
  std::string firstFailure_;
};

}  // namespace check

#define CHECK_NEAR_VECTOR(actual, expected, tolerance) \
  check::nearVector((actual), (expected), (tolerance), #actual " ~ " #expected, __FILE__, __LINE__)
