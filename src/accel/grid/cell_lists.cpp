// CellLists: counts what each cell will hold, then fills one array for all of them.
//
//   1. The scene is cut into items: objects, and runs of so many faces that there are not too many.
//   2. The frame is the finest one, at most as fine as wanted, for which the boxes of all items,
//      widened by the margin, do not overlap too many cells together.
//   3. For each of those cells it is found out whether the item's surface can be there: the cell,
//      widened by the margin, meets the shape and is not all inside of a ball.
//   4. A first pass over the answers counts the entries of each cell, a second one enters them,
//      behind each other in one array (a counting sort).
#include "accel/grid/cell_lists.h"

#include <algorithm>

namespace accel {
namespace {

BoundingBox widened(const BoundingBox& box, double margin) {
  const Vec3d margins(margin, margin, margin);
  return {box.low() - margins, box.high() + margins};
}

}  // namespace

CellLists::CellLists(const GridObjects& objects, const GridSize& size, const GridLimits& limits)
    : objects_(objects) {
  if (objects.placed().empty()) return;
  listItems(limits.items);
  for (std::uint32_t number = 0; number < items_.size(); ++number) box_.extend(widenedBox(number));
  chooseFrame(size, limits.entries);
  fill();
}

void CellLists::listItems(double most) {
  const auto countOf = [&](const GridObject& object) {
    return (std::uint64_t(object.faceCount()) + run_ - 1) / run_;
  };
  for (;; run_ *= 2) {
    double count = 0;
    for (const GridObject& object : objects_.placed()) count += double(countOf(object));
    if (count <= most || run_ == 1u << 31) break;
  }
  for (std::uint32_t object = 0; object < objects_.placed().size(); ++object) {
    const std::uint64_t count = countOf(objects_.placed()[object]);
    for (std::uint64_t i = 0; i < count; ++i) items_.push_back({object, std::uint32_t(i * run_)});
  }
}

GridItem CellLists::item(std::uint32_t number) const {
  const Item& item = items_[number];
  const GridObject& object = objects_.placed()[item.object];
  return {&object, item.first, item.first + std::min(run_, object.faceCount() - item.first)};
}

BoundingBox CellLists::widenedBox(std::uint32_t number) const {
  const GridItem faces = item(number);
  return widened(objects_.boxOf(*faces.object, faces.first, faces.last), objects_.margin());
}

void CellLists::chooseFrame(const GridSize& size, double mostEntries) {
  for (GridSize tried = size;;) {
    frame_.emplace(box_, tried);
    double entries = 0;
    for (std::uint32_t number = 0; number < items_.size(); ++number) {
      entries += cellsOf(number).count();
    }
    if (entries <= mostEntries || frame_->cellCount() == 1) return;
    for (int& side : tried) side = (side + 1) / 2;
  }
}

/// The answers of step 3, item by item and cell by cell, as a bit each: found once, for finding
/// them takes longer than the rest.
std::vector<bool> CellLists::findMeetings() const {
  std::vector<bool> meetings;
  for (std::uint32_t number = 0; number < items_.size(); ++number) {
    const GridItem faces = item(number);
    const WorldShape shape =
        run_ == 1 ? objects_.shapeOf(*faces.object, faces.first) : WorldShape();
    forEachCell(cellsOf(number), [&](const GridSize& cell) {
      const BoundingBox box = widened(frame_->boxOf(cell), objects_.margin());
      meetings.push_back(shape.meets(box) && !shape.surrounds(box));
    });
  }
  return meetings;
}

void CellLists::fill() {
  starts_.assign(frame_->cellCount() + 1, 0);
  const std::vector<bool> meetings = findMeetings();
  const auto forEachEntry = [&](const auto& visit) {
    auto meeting = meetings.begin();
    for (std::uint32_t number = 0; number < items_.size(); ++number) {
      forEachCell(cellsOf(number), [&](const GridSize& cell) {
        if (*meeting++) visit(frame_->indexOf(cell), number);
      });
    }
  };
  // Sums make each count the end of its list, and entering from the back makes that its start.
  forEachEntry([&](std::size_t index, std::uint32_t) { ++starts_[index]; });
  std::uint32_t sum = 0;
  for (std::uint32_t& start : starts_) start = sum += start;
  entries_.resize(sum);
  forEachEntry(
      [&](std::size_t index, std::uint32_t number) { entries_[--starts_[index]] = number; });
}

/// The margin grows in proportion to the distance, so the grown box of everything is asked: as a
/// grid of one cell.
bool CellLists::mayMeetFromAfar(const Ray& ray, double tmin, double tmax) const {
  const double margin = objects_.margin() * (maxAbs(ray.getOrigin()) / objects_.reach());
  const GridFrame frame(widened(box_, margin), {1, 1, 1});
  const CellWalk walk(frame, ray, tmin);
  return !walk.isAtEnd() && walk.enterT() < tmax;
}

}  // namespace accel
