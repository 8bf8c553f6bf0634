// Grid: the whole scene as one Object3D that finds hits through a uniform grid of cells.
// It gives exactly the answers of the objects it was made from: same t, material, normal.
//
// Each cell lists the spheres, the triangles and the faces of meshes, inside Transforms too, whose
// surface in the world may be met in it (of spheres that Transforms squash, the box); a ray asks
// the cells it passes, one after the other, and stops where no later cell can hold anything nearer.
// Cells count as wider by a bound on all rounding, so that no hit is lost; what has no bounds, or
// numbers too extreme for that, is asked one by one, and so is everything by a ray from more than a
// thousand sizes of the scene away.
#pragma once
#include <memory>
#include <string>

#include "accel/grid/grid_frame.h"
#include "accel/test_tally.h"
#include "geometry/object3d.h"

class Grid : public Object3D {
 public:
  /// Sorts everything below `root` into cells. `root` and what it holds are not owned, must outlive
  /// the grid and must not change any more. Where the lists of all cells together would have more
  /// than `mostEntries`, and than 2 for each face, the sides of `size` are halved until they have
  /// not. Where `tally` (not owned) is not null, it is told the cells visited and the objects and
  /// faces tested, each as often as cells list it; for crossings once.
  Grid(const Object3D& root, const GridSize& size, TestTally* tally = nullptr,
       double mostEntries = 0x1p26);
  ~Grid() override;

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;

  /// What was built, in one line: cells, entries of their lists, objects beside.
  std::string describe() const;

 private:
  struct Cells;

  TestTally* tally_;  // not owned
  std::unique_ptr<const Cells> cells_;
};
