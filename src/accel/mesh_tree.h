// MeshTree: the tree over one mesh's triangles, shared by all meshes of that geometry.
#pragma once
#include "accel/wide_bvh.h"
#include "geometry/mesh_geometry.h"

namespace accel {

class MeshTree {
 public:
  /// Builds with `threads` threads. The geometry is not owned.
  MeshTree(const MeshGeometry& geometry, int threads);

  const WideBvh& bvh() const { return bvh_; }
  /// The mesh's box in its own space.
  BoundingBox box() const;

  /// The corners of the triangle in lane `lane` of the leaf at `words`, exactly as the geometry
  /// holds them, and the number of its face.
  struct Triangle {
    Vec3d a, b, c;
    std::uint32_t face;
  };
  Triangle triangleAt(const std::uint32_t* words, int lane) const;

 private:
  const MeshGeometry* geometry_;  // not owned
  WideBvh bvh_;
  bool exact_ = true;  // scaling lost no digit, so leaves hold the corners exactly
};

}  // namespace accel
