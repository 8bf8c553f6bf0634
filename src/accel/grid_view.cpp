// GridView: counts the objects of each cell, then walks to the first cell that has any.
#include "accel/grid_view.h"

#include <algorithm>

#include "accel/grid_parts.h"

namespace {

/// The frame with one more cell on each axis, where a box that ends at the last cell may end.
GridSize grown(const GridSize& size) { return {size[0] + 1, size[1] + 1, size[2] + 1}; }

std::size_t indexIn(const GridSize& size, const GridSize& cell) {
  return (std::size_t(cell[2]) * std::size_t(size[1]) + std::size_t(cell[1])) *
             std::size_t(size[0]) +
         std::size_t(cell[0]);
}

CellRange allOf(const GridSize& size) {
  return {{0, 0, 0}, {size[0] - 1, size[1] - 1, size[2] - 1}};
}

/// Calls visit(object, part) for all parts of all objects.
template <class Visit>
void forEachPart(const accel::GridParts& parts, const Visit& visit) {
  for (const accel::PlacedObject& object : parts.placed()) {
    for (std::uint32_t part = 0; part < object.partCount(); ++part) visit(object, part);
  }
}

}  // namespace

GridView::GridView(const Object3D& root, const GridSize& size, std::vector<const Material*> palette,
                   double mostTests)
    : palette_(std::move(palette)) {
  const accel::GridParts parts(root);
  box_ = parts.box();
  if (box_.isEmpty()) return;
  frame_.emplace(box_, size);
  const auto rangeOf = [&](const accel::PlacedObject& object, std::uint32_t part) {
    return frame_->overlappedBy(parts.boxOf(object, part, part + 1));
  };
  double tests = 0;
  forEachPart(parts, [&](const auto& object, std::uint32_t part) {
    tests += rangeOf(object, part).count();
  });
  const auto shapeOf = [&](const accel::PlacedObject& object, std::uint32_t part) {
    return tests <= mostTests ? parts.shapeOf(object, part) : accel::PartShape();
  };
  const GridSize corners = grown(size);
  counts_.resize(std::size_t(corners[0]) * std::size_t(corners[1]) * std::size_t(corners[2]));
  forEachPart(parts, [&](const auto& object, std::uint32_t part) {
    if (!shapeOf(object, part).isKnown()) countCorners(rangeOf(object, part));
  });
  sumCorners();
  forEachPart(parts, [&](const auto& object, std::uint32_t part) {
    const accel::PartShape shape = shapeOf(object, part);
    if (!shape.isKnown()) return;
    forEachCell(rangeOf(object, part), [&](const GridSize& cell) {
      counts_[frame_->indexOf(cell)] += shape.meets(frame_->boxOf(cell));
    });
  });
}

/// Notes at the eight corners of a range that the count grows or falls behind them; sums along each
/// axis then give every cell its count, however many cells a range has. Source: Crow, "Summed-Area
/// Tables for Texture Mapping", 1984, read backwards.
void GridView::countCorners(const CellRange& range) {
  const GridSize corners = grown(frame_->size());
  for (int corner = 0; corner < 8; ++corner) {
    GridSize cell;
    bool grows = true;
    for (int axis = 0; axis < 3; ++axis) {
      const bool behind = (corner >> axis & 1) != 0;
      cell[axis] = behind ? range.last[axis] + 1 : range.first[axis];
      grows = grows != behind;
    }
    counts_[indexIn(corners, cell)] += grows ? 1u : ~0u;  // modulo 2^32, which sums undo
  }
}

void GridView::sumCorners() {
  const GridSize corners = grown(frame_->size());
  for (int axis = 0; axis < 3; ++axis) {
    forEachCell(allOf(corners), [&](const GridSize& cell) {
      if (cell[axis] == 0) return;
      GridSize before = cell;
      --before[axis];
      counts_[indexIn(corners, cell)] += counts_[indexIn(corners, before)];
    });
  }
  // The corners beyond the last cells have done their work.
  forEachCell(allOf(frame_->size()), [&](const GridSize& cell) {
    counts_[frame_->indexOf(cell)] = counts_[indexIn(corners, cell)];
  });
  counts_.resize(frame_->cellCount());
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
    const double extent = std::max(maxAbs(box_.low()), maxAbs(box_.high()));
    hit.record(t, palette_[color], normal, point,
               {this, std::uint32_t(index), magnitudeOf(t, point, ray, extent)});
    return true;
  }
  return false;
}

void GridView::addBounds(const Matrix& toWorld, BoundingBox& box) const {
  for (int corner = 0; frame_ && corner < 8; ++corner) {
    box.extend(toWorld.transformPoint({((corner & 1) ? box_.high() : box_.low()).x(),
                                       ((corner & 2) ? box_.high() : box_.low()).y(),
                                       ((corner & 4) ? box_.high() : box_.low()).z()}));
  }
}
