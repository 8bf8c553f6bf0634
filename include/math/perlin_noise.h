// Perlin's gradient noise in space: the same bits everywhere, for every point that a double can
// name. Source: Perlin, "Improving Noise", 2002, with the permutation published there.
#pragma once
#include <cstdint>

#include "math/functions.h"
#include "math/vec3.h"

namespace math {

/// floor(x) modulo 2^bits, 0 <= bits <= 8, exact and never negative for every finite x; 0 for
/// infinities and NaN.
int floorBits(double x, int bits);

/// Improved noise: smooth, 0 at every point with whole coordinates, its size at most 1.04, repeated
/// every 256 units along each axis. Doubles from 2^52 on are whole, so the noise is 0 there; it is
/// 0 where a coordinate is infinite or NaN.
double noise(const Vec3d& p);

/// The most octaves that fractalNoise sums. Further ones, each half as strong, would add less than
/// a float can tell.
inline constexpr int kMaxOctaves = 32;

/// noise(p) + noise(2 p) / 2 + noise(4 p) / 4 ..., `octaves` terms, 0..kMaxOctaves: always finite,
/// its size below 2.1.
double fractalNoise(const Vec3d& p, int octaves);

/// Waves that are disturbed by noise: their angle at a way x along them is frequency x + amplitude
/// N, N being fractalNoise at a point.
struct NoisyWaves {
  int octaves;        ///< of the noise
  double frequency;   ///< in radians per unit of the way, any finite number
  double amplitude;   ///< in radians, likewise
  double height = 1;  ///< or -1, which turns the waves upside down

  /// height sin(angle); NaN where the angle is infinite.
  double sineAt(double x, const Vec3d& p) const {
    return height * math::sin(frequency * x + amplitude * fractalNoise(p, octaves));
  }
  /// The same from 0 to 1.
  double shareAt(double x, const Vec3d& p) const { return (1 + sineAt(x, p)) / 2; }
};

}  // namespace math
