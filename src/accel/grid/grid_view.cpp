// GridView: counts the objects of each cell, then walks to the first cell that has any.
//
// Both rules name for each face a range of cells, and the shape in it where that is known. A known
// shape is tested against every cell of its range. Any other counts in all of them at once, however
// many they are: the change of the count is noted at the eight corners of the range, and sums along
// x, then y, then z make counts of the changes. Source: Crow, "Summed-Area Tables for Texture
// Mapping", 1984, read backwards.
#include "accel/grid/grid_view.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "accel/grid/flat_scene.h"
#include "geometry/group.h"
#include "geometry/sphere.h"

namespace {

using accel::FlatObject;
using accel::FlatScene;
using accel::WorldShape;

/// Calls visit(object, face) for all faces of all objects that are placed.
template <class Visit>
void forEachFace(const FlatScene& scene, const Visit& visit) {
  for (const FlatObject& object : scene.objects()) {
    const std::uint32_t count = object.isPlaced ? object.faceCount() : 0;
    for (std::uint32_t face = 0; face < count; ++face) visit(object, face);
  }
}

/// The count grows by 1 at the first cell of a range and falls back behind the last one, along each
/// axis: signs multiply. Corners outside the frame change nothing.
void addToCorners(const CellRange& range, CellCounts& cells) {
  for (int corner = 0; corner < 8; ++corner) {
    GridSize cell = range.first;
    std::uint32_t change = 1;  // modulo 2^32, which sums undo
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) == 0) continue;
      cell[axis] = range.last[axis] + 1;
      change = 0 - change;
      isInside = isInside && cell[axis] < cells.frame.size()[axis];
    }
    if (isInside) cells.counts[cells.frame.indexOf(cell)] += change;
  }
}

/// Makes counts of the changes.
void sumCorners(CellCounts& cells) {
  for (int axis = 0; axis < 3; ++axis) {
    forEachCell(cells.frame.allCells(), [&](const GridSize& cell) {
      if (cell[axis] == 0) return;
      GridSize before = cell;
      --before[axis];
      cells.counts[cells.frame.indexOf(cell)] += cells.at(before);
    });
  }
}

/// Counts each face of the scene in the cells of a range: in those that its shape meets, or in all
/// where that is not known. reachOf(object, face) gives both.
template <class ReachOf>
CellCounts count(const FlatScene& scene, const GridFrame& frame, const ReachOf& reachOf) {
  const std::vector<std::uint32_t> zeros(frame.cellCount());
  CellCounts cells{frame, zeros}, changes{frame, zeros};
  forEachFace(scene, [&](const FlatObject& object, std::uint32_t face) {
    const auto [range, shape] = reachOf(object, face);
    if (!shape.isKnown()) return addToCorners(range, changes);
    forEachCell(range, [&, &known = shape](const GridSize& cell) {
      cells.counts[frame.indexOf(cell)] += known.meets(frame.boxOf(cell));
    });
  });
  sumCorners(changes);
  std::transform(cells.counts.begin(), cells.counts.end(), changes.counts.begin(),
                 cells.counts.begin(), std::plus<>());
  return cells;
}

/// A sphere of the world, taken to be in all cells whose centres are near its own.
struct NearCells {
  Vec3d center;
  double reach = 0;  ///< unknown where it is 0

  bool isKnown() const { return reach > 0; }
  bool meets(const BoundingBox& cell) const {
    return length((cell.low() + cell.high()) * 0.5 - center) <= reach;
  }
};

/// The box of what is bounded below `object`, corner by corner of the box inside at each Transform.
/// The depth of recursion is the scene's nesting.
BoundingBox cornerBox(const Object3D& object) {
  BoundingBox box;
  if (const auto* group = exactly<Group>(&object)) {
    for (const Object3D* member : group->getObjects()) {
      if (member) box.extend(cornerBox(*member));
    }
  } else if (const auto* transform = exactly<Transform>(&object)) {
    const BoundingBox inside = cornerBox(*transform->getObject());
    if (!inside.isEmpty()) box = inside.moved(transform->getMatrix());
  } else if (object.isBounded()) {
    object.addBounds(Matrix(), box);
  }
  return box;
}

}  // namespace

CellCounts countReached(const Object3D& root, const GridSize& size, double mostTests) {
  const FlatScene scene(root);
  const GridFrame frame(scene.box(), size);
  const auto rangeOf = [&](const FlatObject& object, std::uint32_t face) {
    return frame.overlappedBy(scene.boxOf(object, face, face + 1));
  };
  double tests = 0;
  forEachFace(scene, [&](const FlatObject& object, std::uint32_t face) {
    tests += rangeOf(object, face).count();
  });
  return count(scene, frame, [&](const FlatObject& object, std::uint32_t face) {
    return std::make_pair(rangeOf(object, face),
                          tests <= mostTests ? scene.shapeOf(object, face) : WorldShape());
  });
}

CellCounts countTouched(const Object3D& root, const GridSize& size) {
  constexpr double kTolerance = 3e-5;  // of a cell
  const FlatScene scene(root);
  const GridFrame frame(cornerBox(root), size);
  const BoundingBox cell = frame.boxOf({});
  const double halfDiagonal = length(cell.high() - cell.low()) / 2;
  return count(scene, frame, [&](const FlatObject& object, std::uint32_t face) {
    BoundingBox box = scene.boxOf(object, face, face + 1);
    NearCells near;
    const auto* sphere = exactly<Sphere>(object.object);
    if (sphere && object.transform == FlatScene::kWorld) {
      near = {sphere->getCenter(), sphere->getRadius() + halfDiagonal};
      box = BoundingBox(near.center, near.center).widened(near.reach);
    } else if (sphere) {
      box = cornerBox(*sphere).moved(scene.transformAt(object.transform).toWorld);
    }
    return std::make_pair(frame.touchedBy(box, kTolerance), near);
  });
}

bool GridView::intersect(const Ray& ray, Hit& hit, double tmin) const {
  const GridFrame& frame = cells_.frame;
  for (CellWalk walk(frame, ray, tmin); !walk.isAtEnd() && walk.enterT() < hit.getT();
       walk.advance()) {
    const auto cell = std::uint32_t(walk.index());
    if (cells_.counts[cell] == 0 || ray.leaves(this, cell)) continue;
    const bool enters = walk.enterAxis() >= 0 && walk.enterT() > tmin;
    const double t = enters ? walk.enterT() : walk.exitT();
    if (!(t > tmin && t < hit.getT())) continue;
    const int axis = enters ? walk.enterAxis() : walk.exitAxis();
    const bool towardsMore = ray.getDirection()[axis] > 0;
    Vec3d normal;
    normal[axis] = towardsMore == enters ? -1 : 1;
    const std::size_t color = std::min<std::size_t>(cells_.counts[cell], palette_.size()) - 1;
    const Vec3d point = ray.pointAtParameter(t);
    const double extent = std::max(maxAbs(frame.box().low()), maxAbs(frame.box().high()));
    hit.record(t, palette_[color], normal, point, {this, cell, magnitudeOf(t, point, ray, extent)});
    return true;
  }
  return false;
}
