// SolidObjects: the transparent objects of a scene that enclose a volume, and how large they are;
// and which of them is the thinnest.
#pragma once
#include <functional>
#include <limits>
#include <unordered_map>

#include "geometry/mesh_geometry.h"
#include "geometry/object3d.h"

class SolidObjects {
 public:
  /// Lists the spheres and closed meshes of transparent material below `root`, inside Transforms
  /// too. Nothing is owned: the scene must outlive the list. Each object stands in one place.
  explicit SolidObjects(const Object3D& root);

  /// The volume of an object in the world, at least 0 (it may overflow to infinity); infinity of
  /// what is not listed, null included. It is the same from wherever one looks, and what lies all
  /// inside another has the smaller one.
  double volumeOf(const Object3D* object) const;
  /// True where `point`, in world space, is further than `distance` >= 0 and all rounding from the
  /// box around all of them; always true where there are none. A NaN coordinate is beyond no side.
  bool areBeyond(const Vec3d& point, double distance) const;

 private:
  std::unordered_map<const Object3D*, double> volumes_;  // only looked up, never walked through
  BoundingBox box_;  // of all of them, in the world; empty where there are none
};

/// Takes a sphere, or a mesh (`mesh` is null for a sphere), and how it stands in the world.
using VisitSolid =
    std::function<void(const Object3D& object, const MeshGeometry* mesh, const Matrix& toWorld)>;
/// Visits all of transparent material below `object`, inside Transforms too, in scene order.
/// `toWorld` says how the object stands. The depth of recursion is the scene's nesting.
void visitTransparent(const Object3D& object, const Matrix& toWorld, const VisitSolid& visit);

/// How thick a solid is: the shortest side of its own box, as its Transforms stretch it.
struct ThinSolid {
  const Object3D* object = nullptr;                            ///< not owned; null: none
  double thickness = std::numeric_limits<double>::infinity();  ///< in the world
  std::size_t line = 0;                                        ///< of the scene file
};
/// The thinnest that is thinner than `limit`, of equal ones the first, without its line. `isClosed`
/// finds out whether a mesh is: that takes long, and is asked of the thinnest so far alone.
ThinSolid findThinnestSolid(const Object3D& root, double limit,
                            const std::function<bool(const MeshGeometry&)>& isClosed);

/// The volume that a closed mesh encloses: the sum over its faces of the tetrahedra that they span
/// with one point, without its sign, in the mesh's own space; 0 where it has no faces.
double volumeOf(const MeshGeometry& mesh);
