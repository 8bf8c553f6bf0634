// GridView: counts the objects of each cell, then walks to the first cell that has any.
//
// Balls and triangles are tested against every cell that their box overlaps. What counts with its
// whole box is added to all cells at once, however many they are: the change of the count is noted
// at the eight corners of the range of cells, and sums along x, then y, then z make counts of the
// changes. Source: Crow, "Summed-Area Tables for Texture Mapping", 1984, read backwards.
#include "accel/grid/grid_view.h"

#include <algorithm>

#include "accel/grid/grid_objects.h"

namespace {

/// Calls visit(object, face) for all faces of all objects.
template <class Visit>
void forEachFace(const accel::GridObjects& objects, const Visit& visit) {
  for (const accel::GridObject& object : objects.placed()) {
    for (std::uint32_t face = 0; face < object.faceCount(); ++face) visit(object, face);
  }
}

}  // namespace

GridView::GridView(const Object3D& root, const GridSize& size, std::vector<const Material*> palette,
                   double mostTests)
    : palette_(std::move(palette)) {
  const accel::GridObjects objects(root);
  const BoundingBox& box = objects.box();
  if (box.isEmpty()) return;
  extent_ = std::max(maxAbs(box.low()), maxAbs(box.high()));
  frame_.emplace(box, size);
  counts_.resize(frame_->cellCount());
  const auto cellsOf = [&](const accel::GridObject& object, std::uint32_t face) {
    return frame_->overlappedBy(objects.boxOf(object, face, face + 1));
  };
  double tests = 0;
  forEachFace(objects, [&](const auto& object, std::uint32_t face) {
    tests += cellsOf(object, face).count();
  });
  const auto shapeOf = [&](const accel::GridObject& object, std::uint32_t face) {
    return tests <= mostTests ? objects.shapeOf(object, face) : accel::WorldShape();
  };
  forEachFace(objects, [&](const auto& object, std::uint32_t face) {
    if (!shapeOf(object, face).isKnown()) addToCorners(cellsOf(object, face));
  });
  sumCorners();
  forEachFace(objects, [&](const auto& object, std::uint32_t face) {
    const accel::WorldShape shape = shapeOf(object, face);
    if (!shape.isKnown()) return;
    forEachCell(cellsOf(object, face), [&](const GridSize& cell) {
      counts_[frame_->indexOf(cell)] += shape.meets(frame_->boxOf(cell));
    });
  });
}

/// The count grows by 1 at the first cell of a range and falls back behind the last one, along each
/// axis: signs multiply. Corners outside the frame change nothing.
void GridView::addToCorners(const CellRange& range) {
  for (int corner = 0; corner < 8; ++corner) {
    GridSize cell;
    std::uint32_t change = 1;  // modulo 2^32, which sums undo
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis) {
      const bool isBehind = (corner >> axis & 1) != 0;
      cell[axis] = isBehind ? range.last[axis] + 1 : range.first[axis];
      change = isBehind ? 0 - change : change;
      isInside = isInside && cell[axis] < frame_->size()[axis];
    }
    if (isInside) counts_[frame_->indexOf(cell)] += change;
  }
}

void GridView::sumCorners() {
  const GridSize& size = frame_->size();
  for (int axis = 0; axis < 3; ++axis) {
    forEachCell({{0, 0, 0}, {size[0] - 1, size[1] - 1, size[2] - 1}}, [&](const GridSize& cell) {
      if (cell[axis] == 0) return;
      GridSize before = cell;
      --before[axis];
      counts_[frame_->indexOf(cell)] += counts_[frame_->indexOf(before)];
    });
  }
}

bool GridView::intersect(const Ray& ray, Hit& hit, double tmin) const {
  if (!frame_) return false;
  for (CellWalk walk(*frame_, ray, tmin); !walk.isAtEnd() && walk.enterT() < hit.getT();
       walk.advance()) {
    const std::size_t index = walk.index();
    if (counts_[index] == 0 || ray.leaves(this, std::uint32_t(index))) continue;
    const bool enters = walk.enterAxis() >= 0 && walk.enterT() > tmin;
    const double t = enters ? walk.enterT() : walk.exitT();
    if (!(t > tmin && t < hit.getT())) continue;
    const int axis = enters ? walk.enterAxis() : walk.exitAxis();
    const bool towardsMore = ray.getDirection()[axis] > 0;
    Vec3d normal;
    normal[axis] = towardsMore == enters ? -1 : 1;
    const std::size_t color = std::min<std::size_t>(counts_[index], palette_.size()) - 1;
    const Vec3d point = ray.pointAtParameter(t);
    hit.record(t, palette_[color], normal, point,
               {this, std::uint32_t(index), magnitudeOf(t, point, ray, extent_)});
    return true;
  }
  return false;
}
