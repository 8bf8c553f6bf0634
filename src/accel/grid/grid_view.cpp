// GridView: counts the objects of each cell, then walks to the first cell that has any.
//
// Both rules name for each face a range of cells. A shape that is known is tested against every
// cell of its range. Any other counts in all of them at once, however many they are: the change of
// the count is noted at the eight corners of the range, and sums along x, then y, then z make
// counts of the changes. Source: Crow, "Summed-Area Tables for Texture Mapping", 1984, read
// backwards.
#include "accel/grid/grid_view.h"

#include <algorithm>
#include <utility>

#include "accel/grid/flat_scene.h"

namespace {

using accel::FlatScene;
using accel::FlatTransform;
using accel::PlacedFace;

/// Notes one more object in all cells of a range: the count grows by 1 at the first cell and falls
/// back behind the last one, along each axis: signs multiply. Corners outside the frame change
/// nothing.
void addTo(const CellRange& range, CellCounts& changes) {
  forEachCell({{0, 0, 0}, {1, 1, 1}}, [&](const GridSize& corner) {
    const GridSize cell = range.first + corner * range.size(), size = changes.frame.size();
    if (cell.x() >= size.x() || cell.y() >= size.y() || cell.z() >= size.z()) return;
    const bool isOdd = (corner.x() + corner.y() + corner.z()) % 2 != 0;
    changes.counts[changes.frame.indexOf(cell)] += isOdd ? ~0u : 1u;  // -1 modulo 2^32
  });
}

/// Makes counts of the changes.
CellCounts summed(CellCounts cells) {
  for (int axis = 0; axis < 3; ++axis) {
    forEachCell(cells.frame.allCells(), [&](GridSize cell) {
      const std::size_t index = cells.frame.indexOf(cell);
      if (--cell[axis] >= 0) cells.counts[index] += cells.at(cell);
    });
  }
  return cells;
}

}  // namespace

CellCounts countReached(const Object3D& root, const GridSize& size, double mostTests) {
  const FlatScene scene(root);
  const GridFrame frame(scene.box, size);
  double tests = 0;  // that it would take to look into every cell of every box
  scene.forEachFace(frame, 0, [&](const PlacedFace& each) { tests += each.cells.count(); });
  CellCounts changes(frame);
  scene.forEachFace(frame, 0, [&](const PlacedFace& each) {
    if (!each.shape.isKnown() || tests > mostTests) return addTo(each.cells, changes);
    forEachCell(each.cells, [&](const GridSize& cell) {
      if (each.shape.meets(frame.boxOf(cell))) addTo({cell, cell}, changes);
    });
  });
  return summed(std::move(changes));
}

CellCounts countTouched(const Object3D& root, const GridSize& size) {
  constexpr double kTolerance = 3e-5;  // of a cell
  const FlatScene scene(root);
  const GridFrame frame(scene.cornerBox, size);
  const Vec3d slack = frame.side() * kTolerance;
  const auto touchedBy = [&](const BoundingBox& box) {
    return frame.overlappedBy({box.low() - slack, box.high() + slack});
  };
  CellCounts changes(frame);
  scene.forEachFace(frame, 0, [&](const PlacedFace& each) {
    const auto* sphere = exactly<Sphere>(each.object.object);
    if (!sphere) return addTo(touchedBy(each.shape.box()), changes);
    // Under Transforms the eight corners of the sphere's own box count, in the world the distances
    // from its centre to those of cells.
    const Vec3d center = sphere->getCenter();
    const BoundingBox middle(center, center);
    const FlatTransform& around = *each.object.around;
    if (around.outer) {
      const BoundingBox own = middle.widened(sphere->getRadius());
      return addTo(touchedBy(own.moved(around.toWorld)), changes);
    }
    const double reach = sphere->getRadius() + length(frame.side()) / 2;
    forEachCell(touchedBy(middle.widened(reach)), [&](const GridSize& cell) {
      const BoundingBox box = frame.boxOf(cell);
      if (length((box.low() + box.high()) * 0.5 - center) <= reach) addTo({cell, cell}, changes);
    });
  });
  return summed(std::move(changes));
}

bool GridView::intersect(const Ray& ray, Hit& hit, double tmin) const {
  const GridFrame& frame = cells_.frame;
  for (CellWalk walk(frame, ray, tmin); !walk.isAtEnd() && walk.enterT() < hit.getT();
       walk.advance()) {
    const auto cell = std::uint32_t(walk.index());
    if (cells_.counts[cell] == 0 || ray.leaves(this, cell)) continue;
    // A ray that starts inside the cell sees it from there: the side by which it leaves.
    const bool enters = walk.enterAxis() >= 0 && walk.enterT() > tmin;
    const double t = enters ? walk.enterT() : walk.exitT();
    if (!(t > tmin && t < hit.getT())) continue;
    const int axis = enters ? walk.enterAxis() : walk.exitAxis();
    const bool towardsMore = ray.getDirection()[axis] > 0;
    Vec3d normal;
    normal[axis] = towardsMore == enters ? -1 : 1;
    const std::size_t color = std::min<std::size_t>(cells_.counts[cell], palette_.size()) - 1;
    const Vec3d point = ray.pointAtParameter(t);
    const double magnitude = magnitudeOf(t, point, ray, frame.box().extent());
    hit.record(t, palette_[color], normal, point, {this, cell, magnitude});
    return true;
  }
  return false;
}
