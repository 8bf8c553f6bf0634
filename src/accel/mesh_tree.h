// MeshTree: the tree over one mesh's triangles, shared by all meshes of that geometry.
#pragma once
#include <vector>

#include "accel/wide_bvh.h"
#include "geometry/mesh_geometry.h"

namespace accel {

/// Faces with the very same corners, in the same order. All are hit at the same t, so the first
/// stands for all; but it does not for a ray that leaves it, nor where crossings are counted.
struct FaceCopies {
  std::uint32_t face, next;  ///< the first two of them
  std::uint32_t count;       ///< at least 2
};

class MeshTree {
 public:
  /// Builds with `threads` threads. The geometry is not owned.
  MeshTree(const MeshGeometry& geometry, int threads);

  const WideBvh& bvh() const { return bvh_; }
  /// The mesh's box in its own space.
  BoundingBox box() const;

  /// Stores the corners of the triangle in lane `lane` of the leaf at `words`, exactly as the
  /// geometry has them: numbers[k * stride], the first one's x, y and z first.
  void getCorners(const std::uint32_t* words, int lane, double* numbers, int stride) const;
  /// A face in the tree that has copies, which are not; null for other faces.
  const FaceCopies* copiesOf(std::uint32_t face) const;
  static std::uint32_t faceAt(const std::uint32_t* words, int lane) {
    return words[kFirstRow + 3 * verticesOf(*words) + lane] & ~kIdBit;
  }

 private:
  const MeshGeometry* geometry_;  // not owned
  WideBvh bvh_;
  std::vector<FaceCopies> copies_;  // by face
  double unscale_ = 0;  // what corners in leaves are to be multiplied by; 0 where they are not
                        // exactly those of the mesh: scaling lost a digit, or the anchor is not 0
};

}  // namespace accel
