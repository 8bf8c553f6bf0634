// GridLists: counts what each cell will hold, then fills one array for all of them.
#include "accel/grid_lists.h"

#include <algorithm>
#include <cmath>

namespace accel {
namespace {

/// Calls visit(index) for every cell of the range.
template <class Visit>
void forEachCell(const GridFrame& frame, const CellRange& range, const Visit& visit) {
  GridSize cell = range.first;
  for (cell[2] = range.first[2]; cell[2] <= range.last[2]; ++cell[2]) {
    for (cell[1] = range.first[1]; cell[1] <= range.last[1]; ++cell[1]) {
      cell[0] = range.first[0];
      const std::size_t first = frame.indexOf(cell);
      const std::size_t count = std::size_t(range.last[0] - range.first[0]) + 1;
      for (std::size_t index = first; index < first + count; ++index) visit(index);
    }
  }
}

BoundingBox widened(const BoundingBox& box, double margin) {
  const Vec3d margins(margin, margin, margin);
  return {box.low() - margins, box.high() + margins};
}

GridSize halved(const GridSize& size) {
  return {(size[0] + 1) / 2, (size[1] + 1) / 2, (size[2] + 1) / 2};
}

}  // namespace

GridLists::GridLists(const GridParts& parts, const GridSize& size, const GridLimits& limits)
    : parts_(parts) {
  if (parts.box().isEmpty() || parts.placed().empty()) return;
  listItems(limits.items);
  for (std::uint32_t number = 0; number < items_.size(); ++number) {
    box_.extend(widenedBox(number));
  }
  for (const PlacedObject& object : parts.placed()) {
    largestMargin_ = std::max(largestMargin_, object.margin);
  }
  chooseFrame(size, limits.entries);
  fill();
}

void GridLists::listItems(double most) {
  const auto countOf = [&](const PlacedObject& object) {
    return (std::uint64_t(object.partCount()) + run_ - 1) / run_;
  };
  for (;; run_ *= 2) {
    double count = 0;
    for (const PlacedObject& object : parts_.placed()) count += double(countOf(object));
    if (count <= most || run_ == 1u << 31) break;
  }
  for (std::uint32_t object = 0; object < parts_.placed().size(); ++object) {
    const std::uint64_t count = countOf(parts_.placed()[object]);
    for (std::uint64_t i = 0; i < count; ++i) items_.push_back({object, std::uint32_t(i * run_)});
  }
}

GridItem GridLists::item(std::uint32_t number) const {
  const Item& item = items_[number];
  const PlacedObject& object = parts_.placed()[item.object];
  return {&object, item.first, item.first + std::min(run_, object.partCount() - item.first)};
}

BoundingBox GridLists::widenedBox(std::uint32_t number) const {
  const GridItem parts = item(number);
  return widened(parts_.boxOf(*parts.object, parts.first, parts.last), parts.object->margin);
}

/// The finest frame, at most `size`, for which the lists are not too long.
void GridLists::chooseFrame(const GridSize& size, double mostEntries) {
  for (GridSize tried = size;; tried = halved(tried)) {
    frame_.emplace(box_, tried);
    double entries = 0;
    for (std::uint32_t number = 0; number < items_.size(); ++number) {
      entries += frame_->touchedBy(widenedBox(number)).count();
    }
    if (entries <= mostEntries || frame_->cellCount() == 1) return;
  }
}

void GridLists::fill() {
  starts_.assign(frame_->cellCount() + 1, 0);
  const auto forEachEntry = [&](const auto& visit) {
    for (std::uint32_t number = 0; number < items_.size(); ++number) {
      forEachCell(*frame_, frame_->touchedBy(widenedBox(number)),
                  [&](std::size_t index) { visit(index, number); });
    }
  };
  forEachEntry([&](std::size_t index, std::uint32_t) { ++starts_[index]; });
  // Each start becomes the end of its list, and filling from the back makes it the start again.
  std::uint32_t sum = 0;
  for (std::uint32_t& start : starts_) start = sum += start;
  entries_.resize(sum);
  forEachEntry(
      [&](std::size_t index, std::uint32_t number) { entries_[--starts_[index]] = number; });
}

bool GridLists::mayMeetFromAfar(const Ray& ray, double tmin, double tmax) const {
  const GridFrame frame(widened(box_, largestMargin_ * (maxAbs(ray.getOrigin()) / parts_.reach())),
                        {1, 1, 1});
  const CellWalk walk(frame, ray, tmin);
  return !walk.isAtEnd() && walk.enterT() < tmax;
}

}  // namespace accel
