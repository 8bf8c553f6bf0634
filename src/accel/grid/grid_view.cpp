// GridView: counts the objects of each cell, then walks to the first cell that has any.
//
// countReached: balls and triangles are tested against every cell that their box overlaps. What
// counts with its whole box is added to all cells at once, however many they are: the change of the
// count is noted at the eight corners of the range of cells, and sums along x, then y, then z make
// counts of the changes. countTouched does so with all but plain spheres. Source: Crow,
// "Summed-Area Tables for Texture Mapping", 1984, read backwards.
#include "accel/grid/grid_view.h"

#include <algorithm>
#include <cmath>

#include "accel/grid/grid_objects.h"
#include "geometry/group.h"
#include "geometry/sphere.h"

namespace {

/// Calls visit(object, face) for all faces of all objects.
template <class Visit>
void forEachFace(const accel::GridObjects& objects, const Visit& visit) {
  for (const accel::GridObject& object : objects.placed()) {
    for (std::uint32_t face = 0; face < object.faceCount(); ++face) visit(object, face);
  }
}

/// The count grows by 1 at the first cell of a range and falls back behind the last one, along each
/// axis: signs multiply. Corners outside the frame change nothing.
void addToCorners(const CellRange& range, CellCounts& cells) {
  for (int corner = 0; corner < 8; ++corner) {
    GridSize cell;
    std::uint32_t change = 1;  // modulo 2^32, which sums undo
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis) {
      const bool isBehind = (corner >> axis & 1) != 0;
      cell[axis] = isBehind ? range.last[axis] + 1 : range.first[axis];
      change = isBehind ? 0 - change : change;
      isInside = isInside && cell[axis] < cells.frame->size()[axis];
    }
    if (isInside) cells.counts[cells.frame->indexOf(cell)] += change;
  }
}

/// Makes counts of the changes.
void sumCorners(CellCounts& cells) {
  const GridSize& size = cells.frame->size();
  for (int axis = 0; axis < 3; ++axis) {
    forEachCell({{0, 0, 0}, {size[0] - 1, size[1] - 1, size[2] - 1}}, [&](const GridSize& cell) {
      if (cell[axis] == 0) return;
      GridSize before = cell;
      --before[axis];
      cells.counts[cells.frame->indexOf(cell)] += cells.at(before);
    });
  }
}

CellCounts emptyCells(const BoundingBox& box, const GridSize& size) {
  CellCounts cells;
  cells.frame.emplace(box, size);
  cells.counts.resize(cells.frame->cellCount());
  return cells;
}

/// The cells that a box touches, and those a little beside.
CellRange touchedBy(const BoundingBox& box, const GridFrame& frame) {
  constexpr double kTolerance = 3e-5;  // of a cell
  CellRange range{};
  for (int axis = 0; axis < 3; ++axis) {
    const double slack = kTolerance * (frame.plane(axis, 1) - frame.plane(axis, 0));
    range.first[axis] = frame.cellAt(axis, box.low()[axis] - slack);
    range.last[axis] = frame.cellAt(axis, box.high()[axis] + slack);
  }
  return range;
}

/// The box of a box's eight corners as `matrix` maps them.
BoundingBox boxOfCorners(const BoundingBox& box, const Matrix& matrix) {
  BoundingBox around;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3d point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = (corner >> axis & 1) != 0 ? box.high()[axis] : box.low()[axis];
    }
    around.extend(matrix.transformPoint(point));
  }
  return around;
}

/// The box of what is bounded below `object`, corner by corner of the box inside at each Transform.
/// The depth of recursion is the scene's nesting.
BoundingBox cornerBox(const Object3D& object) {
  BoundingBox box;
  if (const auto* group = dynamic_cast<const Group*>(&object)) {
    for (const Object3D* member : group->getObjects()) {
      if (member) box.extend(cornerBox(*member));
    }
  } else if (const auto* transform = dynamic_cast<const Transform*>(&object)) {
    const BoundingBox inside = cornerBox(*transform->getObject());
    if (!inside.isEmpty()) box = boxOfCorners(inside, transform->getMatrix());
  } else if (object.isBounded()) {
    object.addBounds(Matrix(), box);
  }
  return box;
}

}  // namespace

CellCounts countReached(const Object3D& root, const GridSize& size, double mostTests) {
  const accel::GridObjects objects(root);
  if (objects.box().isEmpty()) return {};
  CellCounts cells = emptyCells(objects.box(), size);
  const auto cellsOf = [&](const accel::GridObject& object, std::uint32_t face) {
    return cells.frame->overlappedBy(objects.boxOf(object, face, face + 1));
  };
  double tests = 0;
  forEachFace(objects, [&](const auto& object, std::uint32_t face) {
    tests += cellsOf(object, face).count();
  });
  const auto shapeOf = [&](const accel::GridObject& object, std::uint32_t face) {
    return tests <= mostTests ? objects.shapeOf(object, face) : accel::WorldShape();
  };
  forEachFace(objects, [&](const auto& object, std::uint32_t face) {
    if (!shapeOf(object, face).isKnown()) addToCorners(cellsOf(object, face), cells);
  });
  sumCorners(cells);
  forEachFace(objects, [&](const auto& object, std::uint32_t face) {
    const accel::WorldShape shape = shapeOf(object, face);
    if (!shape.isKnown()) return;
    forEachCell(cellsOf(object, face), [&](const GridSize& cell) {
      cells.counts[cells.frame->indexOf(cell)] += shape.meets(cells.frame->boxOf(cell));
    });
  });
  return cells;
}

CellCounts countTouched(const Object3D& root, const GridSize& size) {
  const BoundingBox box = cornerBox(root);
  if (box.isEmpty()) return {};
  CellCounts cells = emptyCells(box, size);
  const accel::GridObjects objects(root);
  const auto plainSphere = [&](const accel::GridObject& object) {
    const bool isInWorld = object.transform == accel::GridTransform::kWorld;
    return isInWorld ? dynamic_cast<const Sphere*>(object.object) : nullptr;
  };
  forEachFace(objects, [&](const auto& object, std::uint32_t face) {
    if (plainSphere(object)) return;
    const bool isMovedSphere = dynamic_cast<const Sphere*>(object.object) != nullptr;
    const BoundingBox own =
        isMovedSphere
            ? boxOfCorners(cornerBox(*object.object), objects.transformAt(object.transform).toWorld)
            : objects.boxOf(object, face, face + 1);
    addToCorners(touchedBy(own, *cells.frame), cells);
  });
  sumCorners(cells);
  const BoundingBox firstCell = cells.frame->boxOf({0, 0, 0});
  const double halfDiagonal = length(firstCell.high() - firstCell.low()) / 2;
  forEachFace(objects, [&](const auto& object, std::uint32_t) {
    const Sphere* const sphere = plainSphere(object);
    if (!sphere) return;
    const double reach = sphere->getRadius() + halfDiagonal;
    const Vec3d center = sphere->getCenter(), reaches(reach, reach, reach);
    forEachCell(touchedBy({center - reaches, center + reaches}, *cells.frame),
                [&](const GridSize& cell) {
                  const BoundingBox around = cells.frame->boxOf(cell);
                  const Vec3d middle = (around.low() + around.high()) * 0.5;
                  const bool isNear = length(middle - center) <= reach;
                  cells.counts[cells.frame->indexOf(cell)] += isNear;
                });
  });
  return cells;
}

GridView::GridView(CellCounts cells, std::vector<const Material*> palette)
    : cells_(std::move(cells)), palette_(std::move(palette)) {
  if (!cells_.frame) return;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int number : {0, cells_.frame->size()[axis]}) {
      extent_ = std::max(extent_, std::fabs(cells_.frame->plane(axis, number)));
    }
  }
}

bool GridView::intersect(const Ray& ray, Hit& hit, double tmin) const {
  if (!cells_.frame) return false;
  for (CellWalk walk(*cells_.frame, ray, tmin); !walk.isAtEnd() && walk.enterT() < hit.getT();
       walk.advance()) {
    const std::size_t index = walk.index();
    if (cells_.counts[index] == 0 || ray.leaves(this, std::uint32_t(index))) continue;
    const bool enters = walk.enterAxis() >= 0 && walk.enterT() > tmin;
    const double t = enters ? walk.enterT() : walk.exitT();
    if (!(t > tmin && t < hit.getT())) continue;
    const int axis = enters ? walk.enterAxis() : walk.exitAxis();
    const bool towardsMore = ray.getDirection()[axis] > 0;
    Vec3d normal;
    normal[axis] = towardsMore == enters ? -1 : 1;
    const std::size_t color = std::min<std::size_t>(cells_.counts[index], palette_.size()) - 1;
    const Vec3d point = ray.pointAtParameter(t);
    hit.record(t, palette_[color], normal, point,
               {this, std::uint32_t(index), magnitudeOf(t, point, ray, extent_)});
    return true;
  }
  return false;
}
