// GridObjects: the objects of a scene, each with the Transforms that it stands under, and where it
// is in the world.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/grid/world_shape.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

namespace accel {

/// A Transform of the scene, and what is known of numbers inside it. The world counts as the first
/// one, which maps nothing.
struct GridTransform {
  static constexpr int kWorld = 0;

  const Transform* transform;  // not owned; null for the world
  int parent;                  ///< the number, which is smaller, of the one it stands under
  Matrix toWorld;              ///< from its inside
  double largest = 0;          ///< coordinate of a ray's origin or of a point, inside
  double error = 0;            ///< of a hit that is found inside, as a distance in the world
};

/// A primitive, a mesh or an object of a class that is not known here.
struct GridObject {
  const Object3D* object;    // not owned
  const TriangleMesh* mesh;  ///< the object, where it is a mesh
  int transform;             ///< the number of the Transform whose inside it stands in
  std::uint32_t order;       ///< place in the scene: of two hits at one t the lower one wins

  /// The faces of a mesh; 1 for anything else, which is then its face 0.
  std::uint32_t faceCount() const { return mesh ? mesh->getGeometry().faceCount() : 1; }

  /// Object3D's questions, asked of one face.
  bool intersect(std::uint32_t face, const Ray& ray, Hit& hit, double tmin) const;
  bool occluded(std::uint32_t face, const Ray& ray, double tmin, double tmax) const;
  void visitCrossings(std::uint32_t face, const Ray& ray, CrossingVisitor& visitor) const;
};

class GridObjects {
 public:
  /// Lists everything below `root`, in scene order. `root` and what it holds are not owned.
  explicit GridObjects(const Object3D& root);

  const GridTransform& transformAt(int number) const { return transforms_[std::size_t(number)]; }
  /// What has a place in a grid.
  const std::vector<GridObject>& placed() const { return placed_; }
  /// What has not: it is unbounded, or its numbers are so extreme that a box says too little.
  const std::vector<GridObject>& beside() const { return beside_; }

  /// How far beyond its surface, in the world, anything placed may seem to be hit; for rays whose
  /// origin has no larger coordinate than reach(), and beyond that in proportion to it.
  double margin() const { return margin_; }
  double reach() const { return reach_; }

  /// The world box of everything placed, without the margin; empty where nothing is.
  const BoundingBox& box() const { return box_; }
  /// The world box of faces [first, last) of an object, without the margin.
  BoundingBox boxOf(const GridObject& object, std::uint32_t first, std::uint32_t last) const;
  /// The shape of face `face` in the world, without the margin.
  WorldShape shapeOf(const GridObject& object, std::uint32_t face) const;

 private:
  void add(const Object3D* object, int transform);
  void findErrors();
  template <class Predicate>
  void keepPlaced(const Predicate& hasPlace);

  std::vector<GridTransform> transforms_{{nullptr, GridTransform::kWorld, Matrix()}};
  std::vector<GridObject> placed_, beside_;
  BoundingBox box_;
  double margin_ = 0, reach_ = 0;
};

}  // namespace accel
