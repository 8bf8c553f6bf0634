// Ray parameters rounded outwards, and packets.
//
// How a packet is prepared. All its lines pass one point (up to a spread, which widens the reach),
// so in the tree's normalised space
//   1. the point is moved there; the reach, the largest distance from it to a corner of the tree's
//      box, decides the error bounds: beyond kFarthest they would leave too many rays open;
//   2. directions are scaled by one power of two for all rays, so that the largest component is
//      about 1; all must lie in one octant, away from its borders, so that one node's near and far
//      planes are the same for all of them and interval arithmetic on the reciprocals is tight;
//   3. tmin and tmax are counted from the point and rounded both ways, down and up;
//   4. up to the next multiple of 16 the packet is filled with rays that can hit nothing.
#include "accel/prepare_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace accel {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kRounding = 0x1p-24;
/// Half of what a float holds, so that what is added to it is held as well.
constexpr float kHalfOfMost = 0x1p127f;
/// Seen from further away, in sizes of the tree, too many rays would stay open.
constexpr double kFarthest = 64;

/// A float surely not above t.
inline float below(double t) {
  constexpr double kLargest = double(std::numeric_limits<float>::max());
  const double limited = t < kLargest ? t : kLargest;
  return float(limited - std::fabs(limited) * (2 * kRounding));
}

inline float above(double t) { return -below(-t); }

struct Extremes {
  float least = kInfinity, most = -kInfinity;

  Extremes(const float* values, int count) {
    for (int i = 0; i < count; ++i) {
      least = values[i] < least ? values[i] : least;
      most = values[i] > most ? values[i] : most;
    }
  }
};

/// Sets the directions, scaled by `scale`, and stores their largest component in `steepest`; false
/// where they differ in octant.
bool setDirections(const Beam& beam, double scale, RayPacket& packet, float& steepest) {
  steepest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    float* direction = packet.direction[axis];
    for (int i = 0; i < beam.count; ++i) direction[i] = float(beam.direction[axis][i] * scale);
    for (int i = 0; i < beam.count; ++i) packet.reciprocal[axis][i] = 1 / direction[i];
    const Extremes range(direction, beam.count);
    if (!(range.least > 0x1p-40f || range.most < -0x1p-40f)) return false;
    const Extremes reciprocals(packet.reciprocal[axis], beam.count);
    packet.leastReciprocal[axis] = reciprocals.least;
    packet.mostReciprocal[axis] = reciprocals.most;
    packet.nearRow[axis] = 2 * axis + (range.most < 0 ? 1 : 0);
    steepest = std::max({steepest, range.most, -range.least});
  }
  return true;
}

void setBounds(const Beam& beam, double timeScale, RayPacket& packet) {
  for (int i = 0; i < beam.count; ++i) {
    packet.tminDown[i] = below(beam.tmin[i] * timeScale);
    packet.tminUp[i] = above(beam.tmin[i] * timeScale);
  }
  for (int i = 0; i < beam.count; ++i) {
    packet.tmaxDown[i] = below(beam.tmax[i] * timeScale);
    packet.tmaxUp[i] = above(beam.tmax[i] * timeScale);
  }
  for (int i = 0; i < beam.count; ++i) {
    packet.leafBits[i] = 0;
    packet.doubtCount[i] = 0;
  }
}

/// Fills up to a multiple of the widest instruction with rays that want nothing.
void fillUp(RayPacket& packet, int count) {
  packet.count = count;
  for (int i = count; i % 16 != 0; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      packet.direction[axis][i] = packet.direction[axis][0];
      packet.reciprocal[axis][i] = packet.reciprocal[axis][0];
    }
    packet.tminDown[i] = packet.tminUp[i] = kInfinity;
    packet.tmaxDown[i] = packet.tmaxUp[i] = -kInfinity;
    packet.leafBits[i] = packet.laneBits[i] = 0;
  }
}

/// Sets the common point, from where the tree lies within `reach`.
void setPoint(const Vec3d& point, double reach, RayPacket& packet) {
  // A mesh has no anchor: its coordinates, and so their rounding, may be larger than its size.
  const double pad = 8 * kRounding * (reach + 1 + maxAbs(point));
  for (int axis = 0; axis < 3; ++axis) {
    const double widened = packet.direction[axis][0] < 0 ? -pad : pad;
    packet.originHigh[axis] = float(point[axis]);
    packet.originLow[axis] = float(point[axis] - double(packet.originHigh[axis]));
    packet.nearOrigin[axis] = float(point[axis] + widened);
    packet.farOrigin[axis] = float(point[axis] - widened);
  }
}

}  // namespace

float ParameterMap::below(double t) const {
  const double x = t * scale - shift;
  if (x > kHalfOfMost) return kHalfOfMost;
  if (x < -kHalfOfMost) return -kInfinity;
  return float(x - (std::fabs(x) * (2 * kRounding) + std::fabs(shift) * 0x1p-46));
}

float ParameterMap::above(double t) const { return -ParameterMap{-scale, -shift}.below(t); }

bool preparePacket(const WideBvh& bvh, const Beam& beam, RayPacket& packet) {
  const Vec3d point = (beam.point - Vec3d(bvh.anchor[0], bvh.anchor[1], bvh.anchor[2])) * bvh.scale;
  double reach = maxAbs(point) * 0x1p-28;
  for (int axis = 0; axis < 3; ++axis) {
    reach = std::max(
        {reach, std::fabs(bvh.low[axis] - point[axis]), std::fabs(bvh.high[axis] - point[axis])});
  }
  if (!(reach < kFarthest)) return false;
  // The error bounds are 64 e times the reach: this one allows for eight times the spread.
  const double spread = beam.spread * bvh.scale / (8 * kRounding);
  if (!(spread < kFarthest)) return false;
  reach = (reach + maxAbs(point) * 0x1p-28 + spread) * (1 + 8 * kRounding);

  double largest = 0;
  for (const auto& component : beam.direction) {
    largest = std::max(largest, std::fabs(component[0]) * bvh.scale);
  }
  if (!(largest >= 0x1p-500 && largest <= 0x1p500)) return false;
  const double timeScale = std::ldexp(1.0, std::ilogb(largest));
  float steepest;
  if (!setDirections(beam, bvh.scale / timeScale, packet, steepest)) return false;

  setPoint(point, reach, packet);
  setBounds(beam, timeScale, packet);
  fillUp(packet, beam.count);
  packet.nodes = bvh.root();
  packet.leaves = bvh.words();
  packet.reach = float(reach);
  packet.edgeError = float(64 * kRounding * reach) * steepest;
  packet.determinantError = float(48 * kRounding) * steepest;
  packet.numeratorError = float(80 * kRounding * reach);
  packet.open = packet.blocked = 0;
  packet.nodesVisited = packet.primitivesTested = 0;
  return true;
}

}  // namespace accel
