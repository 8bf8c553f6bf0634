// What one ray's questions to a mesh need to know while the tree is walked: the kernels call back
// with candidates, and the triangle's double function decides.
#pragma once
#include "accel/mesh_tree.h"
#include "accel/object_tree.h"
#include "accel/prepare_rays.h"

namespace accel {

/// One ray's question to one mesh. Nothing is owned.
struct MeshQuery {
  const MeshTree* tree;
  const TriangleMesh* mesh;
  const Ray* ray;

  /// Decides candidate `c`; true where the ray hits it, at `t`.
  bool decide(const Candidate& c, MeshTree::Triangle& corners, double& t) const;
};

/// Which triangle is the nearest. Set up by braces, then asked once.
struct NearestInMesh : MeshQuery {
  NearestQuery* query;
  std::uint32_t order;
  ParameterMap time;
  bool found = false;
  Candidate winner{};  ///< where found

  /// Walks the tree with `r`, the ray as prepared for it, and records the hit; true where there
  /// is one.
  bool ask(const Kernels& kernels, TraversalRay& r);

 private:
  static bool resolve(TraversalRay& r);
  void consider(const Candidate& c);
};

/// Whether any triangle is hit between tmin and tmax.
struct OccludedByMesh : MeshQuery {
  double tmin, tmax;

  bool ask(const Kernels& kernels, TraversalRay& r);

 private:
  static bool resolve(TraversalRay& r);
};

}  // namespace accel
