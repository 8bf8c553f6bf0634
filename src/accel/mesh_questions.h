// What the rays of a stream ask of one mesh.
#pragma once
#include "accel/mesh_tree.h"
#include "accel/stream.h"
#include "geometry/triangle_mesh.h"

namespace accel {

/// A mesh in the scene, and the tree over its triangles. Nothing is owned.
struct MeshInScene {
  const TriangleMesh& mesh;
  const MeshTree& tree;
  std::uint32_t order;  ///< place in the scene
};

/// Object3D::intersect for the listed rays, which are in the mesh's space: rays.tmax is lowered to
/// the t of each new hit, and its row of `hits` set.
void nearestInMesh(const Kernels& kernels, const MeshInScene& asked, const RayTable& rays,
                   const RowList& list, HitTable& hits, Arena& arena);

/// Object3D::occluded: sets blocked[row] where anything is hit between tmin and tmax, and leaves
/// the others as they are.
void occludedByMesh(const Kernels& kernels, const MeshInScene& asked, const RayTable& rays,
                    const RowList& list, bool* blocked, Arena& arena);

/// Object3D::visitCrossings. tmin is 0 and tmax infinite.
void visitMeshCrossings(const Kernels& kernels, const MeshInScene& asked, const RayTable& rays,
                        const RowList& list, RowCrossingVisitor& visitor, Arena& arena);

}  // namespace accel
