// Prepares a ray for the kernels.
#include "accel/prepare_ray.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace accel {
namespace {

constexpr double kRounding = 0x1p-24;
constexpr float kInf = std::numeric_limits<float>::infinity();
/// Half of what a float holds, so that what is added to it is held as well.
constexpr float kMost = 0x1p127f;
/// Seen from further away, in sizes of the tree, nothing can be told from rounding.
constexpr double kFarthest = 0x1p56;

/// A direction's component for the box test: not so small that its reciprocal could overflow. A
/// ray turned by this little stays well within the widening of the boxes.
float divisible(float component) {
  constexpr float kLeast = 0x1p-60f;
  return std::fabs(component) >= kLeast ? component : std::copysign(kLeast, component);
}

/// The power of two with the exponent of x, for a positive and normal x. (std::ldexp and ilogb took
/// a tenth of this function.)
double powerOfTwoBelow(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits &= 0x7ff0000000000000u;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// 1 / x for a power of two, without a division.
double inverseOfPower(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits = (std::uint64_t(2046) << 52) - bits;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// Sets the part of `r` that the box test uses, boxes widened by `pad` on every side. In float:
/// `pad` covers its rounding too.
void setBoxTest(TraversalRay& r, float pad) {
  for (int axis = 0; axis < 3; ++axis) r.reciprocal[axis] = 1 / divisible(r.direction[axis]);
  for (int axis = 0; axis < 3; ++axis) {
    const bool negative = r.reciprocal[axis] < 0;
    const float widened = negative ? -pad : pad;
    r.nearRow[axis] = 2 * axis + (negative ? 1 : 0);
    r.nearOffset[axis] = -(r.originHigh[axis] + widened) * r.reciprocal[axis];
    r.farOffset[axis] = -(r.originHigh[axis] - widened) * r.reciprocal[axis];
  }
}

/// Where the ray enters and leaves the tree's box, widened by `margin`.
struct Passage {
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();

  Passage(const WideBvh& bvh, const Vec3d& start, const Vec3d& direction, double margin) {
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double kLeast = 0x1p-60;
      const double component = std::fabs(direction[axis]) >= kLeast
                                   ? direction[axis]
                                   : std::copysign(kLeast, direction[axis]);
      const double inverse = 1 / component;
      const double a = (bvh.low[axis] - margin - start[axis]) * inverse;
      const double b = (bvh.high[axis] + margin - start[axis]) * inverse;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
  }
};

bool contains(const WideBvh& bvh, const Vec3d& p) {
  return p.x() >= bvh.low[0] && p.x() <= bvh.high[0] && p.y() >= bvh.low[1] &&
         p.y() <= bvh.high[1] && p.z() >= bvh.low[2] && p.z() <= bvh.high[2];
}

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

bool prepareRay(const WideBvh& bvh, const Ray& ray, double tmin, double tmax, TraversalRay& r,
                TimeMap& time) {
  const Vec3d start =
      (ray.getOrigin() - Vec3d(bvh.anchor[0], bvh.anchor[1], bvh.anchor[2])) * bvh.scale;
  Vec3d direction = ray.getDirection() * bvh.scale;
  const double largest = maxAbs(direction);
  if (!(largest >= 0x1p-1000 && largest <= 0x1p1000)) return false;
  time.scale = powerOfTwoBelow(largest);
  direction *= inverseOfPower(time.scale);

  // A ray that starts outside is moved to where it enters the box: numbers stay small.
  const double far = maxAbs(start);
  time.shift = 0;
  Vec3d origin = start;
  if (tmin < 0 || !contains(bvh, start)) {
    const Passage passage(bvh, start, direction, 0x1p-18 + far * 0x1p-44);
    if (!(passage.enter <= passage.leave && passage.leave >= tmin * time.scale &&
          passage.enter <= tmax * time.scale)) {
      return false;
    }
    if (passage.enter > 0 || tmin < 0) {
      time.shift = passage.enter;
      origin = start + direction * time.shift;
    }
  }
  if (far > kFarthest) {
    // The error bounds, though not larger than float can hold, then leave everything open.
    if (!(std::fabs(time.shift) < std::numeric_limits<double>::max())) return false;
    for (int axis = 0; axis < 3; ++axis) origin[axis] = (bvh.low[axis] + bvh.high[axis]) / 2;
  }

  double reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    reach = std::max(
        {reach, std::fabs(bvh.low[axis] - origin[axis]), std::fabs(bvh.high[axis] - origin[axis])});
    r.originHigh[axis] = float(origin[axis]);
    r.originLow[axis] = float(origin[axis] - double(r.originHigh[axis]));
    r.direction[axis] = float(direction[axis]);
  }
  reach = (reach + std::min(far, 2 * kFarthest) * 0x1p-28) * (1 + 8 * kRounding);
  // A mesh has no anchor: its coordinates, and so their rounding, may be larger than its size.
  setBoxTest(r, float(24 * kRounding * (reach + 1 + maxAbs(origin))));
  r.nodes = bvh.root();
  r.leaves = bvh.words();
  r.reach = float(reach);
  r.edgeError = float(64 * kRounding * reach * maxAbs(direction));
  r.determinantError = float(48 * kRounding * maxAbs(direction));
  r.numeratorError = float(64 * kRounding * reach);
  r.inverseLengthSquared = 1 / float(dot(direction, direction));
  r.tminDown = std::max(time.below(tmin), 0.0f);
  r.tminUp = std::max(time.above(tmin), 0.0f);
  r.tmaxDown = time.below(tmax);
  r.tmaxUp = time.above(tmax);
  r.candidateCount = 0;
  return true;
}

}  // namespace accel
