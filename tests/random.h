// Seeded random numbers for tests: the same on every machine (the standard fixes mt19937_64, but
// not its distributions). C++ leaves open which argument of a call or operand of * is evaluated
// first, so a test draws once per statement or in braces {}, whose order is fixed: the cases of a
// seed are then the same from every compiler.
#pragma once
#include <cstdint>
#include <random>

#include "math/functions.h"
#include "math/matrix.h"
#include "math/vec3.h"

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Evenly spread over [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * (double(engine_() >> 11) * 0x1p-53);
  }
  /// Evenly spread on a logarithmic scale over [low, high); both are above 0.
  double logUniform(double low, double high) {
    return math::exp(uniform(math::log(low), math::log(high)));
  }
  /// An integer 0 <= i < count.
  int index(int count) { return int(engine_() % std::uint64_t(count)); }
  Vec3d inCube(double low, double high) {
    const double x = uniform(low, high), y = uniform(low, high), z = uniform(low, high);
    return {x, y, z};
  }
  /// Evenly spread over the unit sphere.
  Vec3d unitVector() {
    for (;;) {
      const Vec3d v = inCube(-1, 1);
      if (dot(v, v) <= 1 && dot(v, v) > 1e-4) return normalize(v);
    }
  }
  /// In any direction, of a length drawn by uniform(low, high).
  Vec3d ofLength(double low, double high) {
    const Vec3d direction = unitVector();
    return direction * uniform(low, high);
  }
  /// In any direction, of a length drawn by logUniform(low, high).
  Vec3d ofLogLength(double low, double high) {
    const Vec3d direction = unitVector();
    return direction * logUniform(low, high);
  }
  /// About any axis, by 0 to 360 degrees.
  Matrix rotation() {
    const Vec3d axis = unitVector();
    return Matrix::rotation(axis, uniform(0, 360));
  }

 private:
  std::mt19937_64 engine_;
};
