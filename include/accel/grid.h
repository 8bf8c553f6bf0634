// Grid: the whole scene as one Object3D that finds hits through a uniform grid of cells.
// It gives exactly the answers of the objects it was made from: same t, material, normal.
//
// Each cell lists the spheres, the triangles and the faces of meshes, inside Transforms too, whose
// box in the world overlaps it; a ray asks the cells it passes, one after the other, and stops
// where no later cell can hold anything nearer. Boxes are wider than the objects by a bound on all
// rounding, so that no hit is lost; what has no bounds, or numbers too extreme for that, is asked
// one by one, and so is everything by a ray from more than a thousand sizes of the scene away.
#pragma once
#include <memory>
#include <string>

#include "accel/grid_frame.h"
#include "geometry/object3d.h"

/// What bounds the memory of a grid.
struct GridLimits {
  double items = 0x1p25;    ///< objects and triangles, at the most, that are listed one by one
  double entries = 0x1p26;  ///< of the lists of all cells together
};

class Grid : public Object3D {
 public:
  /// Sorts everything below `root` into cells. `root` and what it holds are not owned, must outlive
  /// the grid and must not change any more. Where the lists would have more entries than `limits`
  /// allow, the sides of `size` are halved until they have not; where the scene has more items, 2,
  /// 4, 8 ... faces of a mesh in a row are listed as one.
  Grid(const Object3D& root, const GridSize& size, const GridLimits& limits = {});
  ~Grid() override;

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override;
  bool isBounded() const override;

  /// What was built, in one line: cells, entries of their lists, objects beside.
  std::string describe() const;

 private:
  struct Content;
  std::unique_ptr<const Content> content_;
  const Object3D* root_;  // not owned
};
