// Prepares a packet of rays whose lines pass one point.
#pragma once
#include "accel/packet.h"
#include "geometry/ray.h"

namespace accel {

/// A beam: `count` lines through `point`, line i along the i-th direction, of which the part from
/// tmin[i] to tmax[i] counts, measured from the point in lengths of the direction. Each component
/// stands in an array of its own, so that the compiler can take several rays at once.
struct Beam {
  Vec3d point;
  double spread;  ///< every line passes the point at no more than this distance, along any axis
  int count;
  double direction[3][RayPacket::kMostRays];
  double tmin[RayPacket::kMostRays], tmax[RayPacket::kMostRays];
};

/// Fills `packet` for the tree `bvh`. Returns false where these rays had better be asked one by
/// one: directions of different octants, or a point too far away for the error bounds to be useful.
bool preparePacket(const WideBvh& bvh, const Beam& beam, RayPacket& packet);

}  // namespace accel
