// Prepares a packet of rays whose lines pass one point.
#include "accel/prepare_packet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace accel {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr double kRounding = 0x1p-24;
/// Seen from further away, in sizes of the tree, too many rays would stay open.
constexpr double kFarthest = 64;

float below(double t) {
  return t < -double(std::numeric_limits<float>::max())  ? -kInf
         : t > double(std::numeric_limits<float>::max()) ? std::numeric_limits<float>::max()
                                                         : float(t - std::fabs(t) * 2 * kRounding);
}

float above(double t) { return -below(-t); }

/// Sets the directions, scaled by `scale`; false where they differ in octant.
bool setDirections(const Beam& beam, double scale, RayPacket& packet) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool negative = beam.directions[0][axis] < 0;
    float least = kInf, most = -kInf;
    for (int i = 0; i < beam.count; ++i) {
      const double component = beam.directions[i][axis] * scale;
      if (!(std::fabs(component) > 0x1p-40) || (component < 0) != negative) return false;
      packet.direction[axis][i] = float(component);
      packet.reciprocal[axis][i] = 1 / packet.direction[axis][i];
      least = std::min(least, packet.reciprocal[axis][i]);
      most = std::max(most, packet.reciprocal[axis][i]);
    }
    packet.leastReciprocal[axis] = least;
    packet.mostReciprocal[axis] = most;
    packet.nearRow[axis] = 2 * axis + (negative ? 1 : 0);
  }
  return true;
}

/// Fills up to a multiple of the widest instruction with rays that want nothing.
void fillUp(RayPacket& packet, int count) {
  packet.count = count;
  for (int i = count; i % 16 != 0; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      packet.direction[axis][i] = packet.direction[axis][0];
      packet.reciprocal[axis][i] = packet.reciprocal[axis][0];
    }
    packet.tminDown[i] = packet.tminUp[i] = kInf;
    packet.tmaxDown[i] = packet.tmaxUp[i] = -kInf;
  }
}

}  // namespace

bool preparePacket(const WideBvh& bvh, const Beam& beam, RayPacket& packet) {
  const Vec3d point = (beam.point - Vec3d(bvh.anchor[0], bvh.anchor[1], bvh.anchor[2])) * bvh.scale;
  const double largest = maxAbs(beam.directions[0]) * bvh.scale;
  if (!(largest >= 0x1p-500 && largest <= 0x1p500)) return false;
  const double timeScale = std::ldexp(1.0, std::ilogb(largest));
  if (!setDirections(beam, bvh.scale / timeScale, packet)) return false;

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
  float steepest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < beam.count; ++i) {
      steepest = std::max(steepest, std::fabs(packet.direction[axis][i]));
    }
    const double pad = 8 * kRounding * (reach + 1 + maxAbs(point));
    const double widened = packet.direction[axis][0] < 0 ? -pad : pad;
    packet.originHigh[axis] = float(point[axis]);
    packet.originLow[axis] = float(point[axis] - double(packet.originHigh[axis]));
    packet.nearOrigin[axis] = float(point[axis] + widened);
    packet.farOrigin[axis] = float(point[axis] - widened);
  }
  for (int i = 0; i < beam.count; ++i) {
    packet.tminDown[i] = below(beam.tmin[i] * timeScale);
    packet.tminUp[i] = above(beam.tmin[i] * timeScale);
    packet.tmaxDown[i] = below(beam.tmax[i] * timeScale);
    packet.tmaxUp[i] = above(beam.tmax[i] * timeScale);
    packet.leafOf[i] = 0;
    packet.doubtCount[i] = 0;
  }
  packet.nodes = bvh.root();
  packet.leaves = bvh.words();
  packet.reach = float(reach);
  packet.edgeError = float(64 * kRounding * reach) * steepest;
  packet.determinantError = float(48 * kRounding) * steepest;
  packet.numeratorError = float(64 * kRounding * reach);
  packet.open = packet.blocked = 0;
  fillUp(packet, beam.count);
  return true;
}

}  // namespace accel
