// FlatScene: the objects of a scene in one list, Groups and Transforms dissolved, and where each is
// in the world. Matrices stay apart: an object is asked in its own space, which a ray enters by one
// multiplication for each Transform, outermost first, as it does in the tree of objects.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/grid/world_shape.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

namespace accel {

/// A Transform of the scene, and what is known of numbers inside it.
struct FlatTransform {
  const Transform* transform;  // not owned; null for the world
  int parent;                  ///< the number, which is smaller, of the one it stands under
  Matrix toWorld;              ///< from its inside
  double largest = 0;          ///< coordinate of a ray's origin or of a point, inside
  double error = 0;            ///< of a hit that is found inside, as a distance in the world
};

/// A primitive, a mesh or an object of a class that is not known here.
struct FlatObject {
  const Object3D* object;    // not owned
  const TriangleMesh* mesh;  ///< the object, where it is a mesh
  int transform;             ///< the number of the Transform whose inside it stands in
  /// Whether it has a place in a grid; not where it is unbounded, or its numbers are so extreme
  /// that a box says too little.
  bool isPlaced = false;

  /// The faces of a mesh; 1 for anything else, which is then its face 0.
  std::uint32_t faceCount() const { return mesh ? mesh->getGeometry().faceCount() : 1; }

  /// Object3D's questions, asked of one face by a ray in the object's own space.
  bool intersect(std::uint32_t face, const Ray& ray, Hit& hit, double tmin) const;
  bool occluded(std::uint32_t face, const Ray& ray, double tmin, double tmax) const;
  void visitCrossings(std::uint32_t face, const Ray& ray, CrossingVisitor& visitor) const;
};

class FlatScene {
 public:
  static constexpr int kWorld = 0;  ///< the number of a Transform that maps nothing

  /// Lists everything below `root`. `root` and what it holds are not owned.
  explicit FlatScene(const Object3D& root);

  /// In scene order: of two hits at one t the earlier object wins.
  const std::vector<FlatObject>& objects() const { return objects_; }

  const FlatTransform& transformAt(int number) const { return transforms_[std::size_t(number)]; }
  /// A ray of the world as it is inside a Transform.
  Ray rayInside(int transform, const Ray& world) const;
  /// Takes a hit inside a Transform out to the world, step by step.
  void restate(int transform, const Ray& world, Hit& hit) const;

  /// The world box of all objects that have one; empty where none has.
  const BoundingBox& box() const { return box_; }
  /// How far beyond its surface, in the world, anything placed may seem to be hit; for rays whose
  /// origin has no larger coordinate than reach(), and beyond that in proportion to it.
  double margin() const { return margin_; }
  double reach() const { return reach_; }

  /// The world box of faces [first, last) of an object, without the margin.
  BoundingBox boxOf(const FlatObject& object, std::uint32_t first, std::uint32_t last) const;
  /// The shape of a face in the world, without the margin.
  WorldShape shapeOf(const FlatObject& object, std::uint32_t face) const;

 private:
  void add(const Object3D* object, int transform);
  void boundErrors();

  std::vector<FlatTransform> transforms_{{nullptr, kWorld, Matrix()}};
  std::vector<FlatObject> objects_;
  BoundingBox box_;
  double margin_ = 0, reach_ = 0;
};

}  // namespace accel
