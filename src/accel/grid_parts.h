// GridParts: the objects of a scene, each with the Transforms that it stands under, and its box in
// the world.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/part_shape.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

namespace accel {

/// The inside of a Transform.
struct GridSpace {
  static constexpr int kWorld = -1;

  const Transform* transform;  // not owned
  int parent;                  ///< the space the Transform stands in; kWorld or a smaller number
  Matrix toWorld;
};

/// A primitive, a mesh or an object of a class that is not known here.
struct PlacedObject {
  const Object3D* object;    // not owned
  const TriangleMesh* mesh;  ///< the object, where it is a mesh
  int space;
  std::uint32_t order;  ///< place in the scene: of two hits at one t the lower one wins
  double margin = 0;    ///< how far beyond its box, in the world, it may seem to be hit

  /// The parts that a box is made for: the faces of a mesh; one of anything else.
  std::uint32_t partCount() const { return mesh ? mesh->getGeometry().faceCount() : 1; }
};

class GridParts {
 public:
  /// Lists everything below `root`, in scene order. `root` and what it holds are not owned.
  explicit GridParts(const Object3D& root);

  const std::vector<GridSpace>& spaces() const { return spaces_; }
  /// What has a place in a grid.
  const std::vector<PlacedObject>& placed() const { return placed_; }
  /// What has not: it is unbounded, or its numbers are so extreme that a box says too little.
  const std::vector<PlacedObject>& beside() const { return beside_; }

  /// The world box of everything placed, without margins; empty where nothing is.
  const BoundingBox& box() const { return box_; }
  /// The world box of parts [first, last) of an object, without its margin.
  BoundingBox boxOf(const PlacedObject& object, std::uint32_t first, std::uint32_t last) const;

  /// The shape of part `part` in the world, without its margin.
  PartShape shapeOf(const PlacedObject& object, std::uint32_t part) const;

  /// The margins hold for rays whose origin has no larger coordinate; beyond that they grow in
  /// proportion to it.
  double reach() const { return reach_; }

 private:
  void add(const Object3D* object, int space);
  void addPrimitive(const Object3D* object, int space);
  const Matrix& toWorld(int space) const;
  bool isMeasurable(const PlacedObject& object, const BoundingBox& box) const;
  void findMargins();

  std::vector<GridSpace> spaces_;
  std::vector<PlacedObject> placed_, beside_;
  const Matrix identity_;
  BoundingBox box_;
  double reach_ = 0;
};

}  // namespace accel
