// TriangleHits: triangles that are known to be hit, whose hits are still to be computed.
// The kernels compute them several at a time with the very operations of triangle::distance and
// TriangleMesh::setHit, in the same order and in double, so with the same bits.
#pragma once

namespace accel {

struct alignas(64) TriangleHits {
  static constexpr int kMost = 64;

  int count = 0;
  double corner[9][kMost];  ///< a, b, c of each triangle
  double origin[3][kMost], direction[3][kMost];

  double t[kMost], normal[3][kMost], point[3][kMost], magnitude[kMost];  ///< results
};

}  // namespace accel
