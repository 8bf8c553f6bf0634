// FlatScene: the objects of a scene in one list, Groups and Transforms dissolved, and where each is
// in the world. Matrices stay apart: an object is asked in its own space, which a ray enters by one
// multiplication for each Transform, outermost first, as it does in the tree of objects. Only to
// find the cells of a grid that an object is in it is moved to the world, as a WorldShape.
#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "accel/grid/grid_frame.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

namespace accel {

/// A ball or a triangle of the world, and whether it reaches into a cell of a grid. What is neither
/// (a squashed ball, an object of an unknown class) is known by its box alone, and is taken to
/// reach into every cell that is asked about.
class WorldShape {
 public:
  /// Known by its box alone.
  explicit WorldShape(const BoundingBox& box) : box_(box) {}
  /// The ball that `toWorld` makes of a sphere; known by its box alone where it is no ball, because
  /// the map does not stretch all directions alike.
  WorldShape(const Matrix& toWorld, const Sphere& sphere);
  /// What `toWorld` makes of the triangle of these corners.
  WorldShape(const Matrix& toWorld, const std::array<Vec3d, 3>& corners);

  const BoundingBox& box() const { return box_; }
  bool isKnown() const { return isTriangle_ || radius_ > 0; }

  /// Whether the shape, a ball being solid, and `cell` have points in common; a cell that overlaps
  /// the shape's box. Touching alone does not count, but for a triangle that lies in the plane of a
  /// side. Sources: Arvo, "A Simple Method for Box-Sphere Intersection Testing", Graphics Gems,
  /// 1990; Akenine-Moeller, "Fast 3D Triangle-Box Overlap Testing", 2001.
  bool meets(const BoundingBox& cell) const;
  /// Whether the whole cell is inside the ball, so that the ball's surface is nowhere in it.
  bool surrounds(const BoundingBox& cell) const;

 private:
  bool isSeparated(const Vec3d& axis, const BoundingBox& cell) const;

  BoundingBox box_;
  bool isTriangle_ = false;
  std::array<Vec3d, 3> points_;  // corners of a triangle, or the centre of a ball
  double radius_ = 0;            // of a ball
};

/// A Transform of the scene, or the world, which maps nothing; and what is known of numbers inside.
struct FlatTransform {
  const Transform* transform = nullptr;  // not owned; null for the world
  const FlatTransform* outer = nullptr;  // the one it stands in, not owned; null for the world
  Matrix toWorld{};                      ///< from its inside
  double largest = 0;                    ///< coordinate of a ray's origin or of a point, inside
  double error = 0;  ///< of a hit that is found inside, as a distance in the world

  /// A ray of the world as it is inside. The depth of recursion is the scene's nesting.
  Ray rayInside(const Ray& world) const;
  /// Takes a hit inside out to the world, step by step.
  void restate(const Ray& world, Hit& hit) const;
};

/// A primitive, a mesh or an object of a class that is not known here. Its questions are
/// Object3D's, asked of one face by a ray in the object's own space.
struct FlatObject {
  const Object3D* object;       // not owned
  const TriangleMesh* mesh;     ///< the object, where it is a mesh; else null
  const FlatTransform* around;  ///< whose inside it stands in; not owned
  std::uint32_t order;          ///< its number in the scene: of hits at one t the least wins
  std::uint32_t faceCount;      ///< of a mesh; 1 for anything else, which is then its face 0
  /// Whether it has a place in a grid; not where it is unbounded, or its numbers are so extreme
  /// that a box says too little.
  bool isPlaced = false;

  /// A face in the world, without the margin.
  WorldShape shapeOf(std::uint32_t face) const;

  bool intersect(std::uint32_t face, const Ray& ray, Hit& hit, double tmin) const {
    if (!mesh) return object->intersect(ray, hit, tmin);
    double t;
    const bool isHit = mesh->nearestRoot(face, ray, tmin, hit.getT(), t);
    if (isHit) mesh->setHit(face, ray, t, hit);
    return isHit;
  }
  bool occluded(std::uint32_t face, const Ray& ray, double tmin, double tmax) const {
    double t;
    return mesh ? mesh->nearestRoot(face, ray, tmin, tmax, t) : object->occluded(ray, tmin, tmax);
  }
  void visitCrossings(std::uint32_t face, const Ray& ray, CrossingVisitor& visitor) const {
    mesh ? mesh->visitFace(face, ray, visitor) : object->visitCrossings(ray, visitor);
  }
};

/// A face of an object that has a place in a grid, its shape, and the cells that the shape's box,
/// widened, overlaps.
struct PlacedFace {
  const FlatObject& object;
  std::uint32_t face;
  WorldShape shape;
  CellRange cells;
};

/// Const once it is built.
struct FlatScene {
  /// Lists everything below `root`. `root` and what it holds are not owned.
  explicit FlatScene(const Object3D& root);
  FlatScene(const FlatScene&) = delete;  // its objects point into it

  /// Calls visit(const PlacedFace&) for all faces that have a place.
  template <class Visit>
  void forEachFace(const GridFrame& frame, double widening, const Visit& visit) const {
    for (const FlatObject& object : objects) {
      if (!object.isPlaced) continue;
      for (std::uint32_t face = 0; face < object.faceCount; ++face) {
        const WorldShape shape = object.shapeOf(face);
        const CellRange cells = frame.overlappedBy(shape.box().widened(widening));
        visit(PlacedFace{object, face, shape, cells});
      }
    }
  }

  std::deque<FlatTransform> transforms;  ///< the outer ones first
  std::vector<FlatObject> objects;       ///< in scene order
  BoundingBox box;                       ///< of all objects that have a place, in the world
  /// Of all that are bounded, corner by corner: of each Transform it holds the eight corners of the
  /// box inside.
  BoundingBox cornerBox;
  /// How far beyond its surface, in the world, anything placed may seem to be hit; for rays whose
  /// origin has no larger coordinate than `reach`, and beyond that in proportion to it.
  double margin = 0, reach = 0;

 private:
  BoundingBox add(const Object3D& object, const FlatTransform& around);
  void boundErrors();
};

}  // namespace accel
