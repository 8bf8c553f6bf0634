// TimeMap: from a ray's own t to the tree's, rounded outwards.
#include <cmath>
#include <limits>

#include "accel/traversal.h"

namespace accel {
namespace {

constexpr double kRounding = 0x1p-24;
constexpr float kInf = std::numeric_limits<float>::infinity();
/// Half of what a float holds, so that what is added to it is held as well.
constexpr float kMost = 0x1p127f;
}  // namespace

float TimeMap::below(double t) const {
  const double x = t * scale - shift;
  if (x > kMost) return kMost;
  if (x < -kMost) return -kInf;
  return float(x - (std::fabs(x) * (2 * kRounding) + std::fabs(shift) * 0x1p-46));
}

float TimeMap::above(double t) const {
  const double x = t * scale - shift;
  if (x > kMost) return kInf;
  if (x < -kMost) return -kMost;
  return float(x + (std::fabs(x) * (2 * kRounding) + std::fabs(shift) * 0x1p-46));
}

}  // namespace accel
