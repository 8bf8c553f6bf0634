// Seeded random numbers for tests: the same on every machine (the standard fixes mt19937_64, but
// not its distributions).
#pragma once
#include <cstdint>
#include <random>

#include "math/functions.h"
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

 private:
  std::mt19937_64 engine_;
};
