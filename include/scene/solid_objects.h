// SolidObjects: the transparent objects of a scene that enclose a volume, and how large they are.
#pragma once
#include <vector>

#include "geometry/mesh_geometry.h"
#include "geometry/object3d.h"

class SolidObjects {
 public:
  /// Lists the spheres and closed meshes of transparent material below `root`, inside Transforms
  /// too. Nothing is owned; each object stands in one place.
  explicit SolidObjects(const Object3D& root);

  /// The volume of an object in the world; infinity of what is not listed. It is the same from
  /// wherever one looks, and what lies all inside another has the smaller one.
  double volumeOf(const Object3D* object) const;
  /// The world box of all of them; empty where there are none.
  const BoundingBox& box() const { return box_; }
  /// True where `point` is further than `distance` >= 0 and all rounding from that box.
  bool areBeyond(const Vec3d& point, double distance) const;

 private:
  struct Solid {
    const Object3D* object;
    double volume;
  };

  void add(const Object3D& object, const Matrix& toWorld);

  std::vector<Solid> solids_;  // by address
  BoundingBox box_;
};

/// The volume that a closed mesh encloses: the sum over its faces of the tetrahedra that they span
/// with one point, without its sign.
double volumeOf(const MeshGeometry& mesh);
