// RayPacket: up to 64 rays through one point, which walk a tree together.
//
// Eye rays meet in the eye, shadow rays to one lamp in the lamp: their lines all pass one point,
// and seen from there they form a narrow beam. One interval test of eight boxes then serves the
// whole beam, and what a triangle needs is computed once for all of them.
// Source: Wald, Boulos and Shirley, "Ray Tracing Deformable Scenes Using Dynamic Bounding Volume
// Hierarchies", 2007; Boulos, Wald and Shirley, "Geometric and Arithmetic Culling Methods for
// Entire Ray Packets", 2006.
//
// As in traversal.h everything is in the tree's normalised space and only bounds are computed. A
// ray is answered by a packet only where all of it is proven; the others are `open` and are asked
// again one by one.
#pragma once
#include <cstdint>

#include "accel/wide_bvh.h"

namespace accel {

struct alignas(64) RayPacket {
  static constexpr int kMostRays = 64;

  const WideNode* nodes;
  const std::uint32_t* leaves;
  int count;                          ///< of rays; up to a multiple of 16 the others want nothing
  float originHigh[3], originLow[3];  ///< the common point, as the sum of two floats
  float nearOrigin[3], farOrigin[3];  ///< the same, moved so that boxes are widened
  int nearRow[3];                     ///< which of WideNode::planes is near, for every ray
  float leastReciprocal[3], mostReciprocal[3];
  float edgeError, determinantError, numeratorError, reach;  ///< as in TraversalRay
  float direction[3][kMostRays], reciprocal[3][kMostRays];
  /// Bounds of each ray's t', counted from the common point (so t' may be negative).
  float tminDown[kMostRays], tminUp[kMostRays], tmaxUp[kMostRays], tmaxDown[kMostRays];

  std::uint32_t nodesVisited, primitivesTested;
  std::uint64_t open;     ///< rays that the packet could not answer
  std::uint64_t blocked;  ///< rays proven to be blocked (any)
  /// The nearest proven hit: the offset of its leaf (0: none) and its place there. The bits of
  /// whole numbers, kept as floats because the kernels move them along with floats.
  float leafBits[kMostRays], laneBits[kMostRays];

  /// Triangles that the filter left open for a ray; more than this and the ray is open itself.
  static constexpr int kMostDoubts = 3;
  struct Doubt {
    std::uint32_t leaf;
    std::uint32_t lane;
    float tLow;  ///< it is not hit at any t' below this
  };
  std::uint8_t doubtCount[kMostRays];
  Doubt doubts[kMostRays][kMostDoubts];
};

/// Triangles that are known to be hit, whose hits are still to be computed. The kernels compute
/// them several at a time with the very operations of triangle::distance and TriangleMesh::setHit,
/// in the same order and in double, so with the same bits.
struct alignas(64) TriangleHits {
  static constexpr int kMost = 64;

  int count = 0;
  double corner[9][kMost];  ///< a, b, c of each triangle
  double origin[3][kMost], direction[3][kMost];

  double t[kMost], normal[3][kMost], point[3][kMost], magnitude[kMost];  ///< results
};

}  // namespace accel
