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

class Grid : public Object3D {
 public:
  /// Sorts everything below `root` into cells. `root` and what it holds are not owned, must outlive
  /// the grid and must not change any more. Memory is bounded: where the lists of all cells
  /// together would exceed 2^26 entries, the sides of `size` are halved until they do not; where a
  /// scene has more than 2^25 triangles, 2, 4, 8 ... neighbours of a mesh are listed as one.
  Grid(const Object3D& root, const GridSize& size);
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
