// WorldShape: a ball or a triangle of the world, and whether it reaches into a cell of a grid. What
// is neither (a squashed ball, an object of an unknown class) is known by its box alone, and is
// taken to reach into every cell that is asked about.
#pragma once
#include <array>

#include "math/bounding_box.h"
#include "math/matrix.h"

namespace accel {

class WorldShape {
 public:
  /// Known by its box alone: meets every cell.
  WorldShape() = default;
  /// The ball around `center` that `toWorld` makes of one of this radius > 0; known by its box
  /// alone where it is no ball, because the map does not stretch all directions alike.
  static WorldShape ball(const Matrix& toWorld, const Vec3d& center, double radius);
  /// What `toWorld` makes of the triangle of these corners.
  static WorldShape triangle(const Matrix& toWorld, const std::array<Vec3d, 3>& corners);

  bool isKnown() const { return kind_ != Kind::box; }

  /// Whether the shape, a ball being solid, and `cell` have points in common; a cell that overlaps
  /// the shape's box. Touching alone does not count, but for a triangle that lies in the plane of a
  /// side. Sources: Arvo, "A Simple Method for Box-Sphere Intersection Testing", Graphics Gems,
  /// 1990; Akenine-Moeller, "Fast 3D Triangle-Box Overlap Testing", 2001.
  bool meets(const BoundingBox& cell) const;
  /// Whether the whole cell is inside the ball, so that the ball's surface is nowhere in it.
  bool surrounds(const BoundingBox& cell) const;

 private:
  enum class Kind { box, ball, triangle };

  bool isSeparated(const Vec3d& axis, const BoundingBox& cell) const;

  Kind kind_ = Kind::box;
  std::array<Vec3d, 3> points_;  // the centre alone of a ball
  double radius_ = 0;
};

}  // namespace accel
