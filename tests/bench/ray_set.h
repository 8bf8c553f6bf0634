// RaySet: rays of one kind, tile by tile, in double for us and in float for the rival.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/object3d.h"

namespace bench {

enum class RayKind { primary, shadow, mirror, diffuse };

/// One ray as the rival takes it: origin, tmin, direction, tmax.
struct FloatRay {
  float origin[3], tmin, direction[3], tmax;
};

/// 16 of them, component by component; the last `count` .. 15 are not to be traced.
struct alignas(64) FloatPacket {
  float origin[3][16], tmin[16], direction[3][16], tmax[16];
  int count;
};

/// A tile is 32 x 32 pixels, as many rays as a generation of the renderer, row by row; secondary
/// rays keep that order and leave gaps out. Only the packets hold a tile's rays in blocks of 4 x 4
/// pixels, which suits them best.
struct RaySet {
  std::vector<Ray> rays;
  std::vector<double> tmax;
  double tmin = 0;
  std::vector<FloatRay> floatRays;
  std::vector<FloatPacket> packets;      // no packet spans two tiles
  std::vector<std::size_t> firstRay;     // of each tile, and one more for the end
  std::vector<std::size_t> firstPacket;  // likewise

  std::size_t tileCount() const { return firstRay.size() - 1; }
};

/// Casts a picture of `side` x `side` pixels at the displaced sphere and makes from its hits the
/// rays of one kind: primary; shadow, to one point light; mirror; diffuse, one seeded cosine
/// direction for each hit. Secondary rays start looking at 0.001.
RaySet makeRays(RayKind kind, const Object3D& scene, int side);

}  // namespace bench
