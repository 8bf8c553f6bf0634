// GridLists: counts what each cell will hold, then fills one array for all of them.
#include "accel/grid_lists.h"

#include <algorithm>
#include <cmath>

namespace accel {
namespace {

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

/// For each cell that the box of each item touches, whether a surface of the item, moved by at most
/// its margin, may be in it: found once, for it takes longer than the rest.
std::vector<bool> GridLists::findMeetings() const {
  std::vector<bool> meetings;
  for (std::uint32_t number = 0; number < items_.size(); ++number) {
    const PlacedObject& object = *item(number).object;
    const PartShape shape = run_ == 1 ? parts_.shapeOf(object, items_[number].first) : PartShape();
    forEachCell(frame_->touchedBy(widenedBox(number)), [&](const GridSize& cell) {
      const BoundingBox box = widened(frame_->boxOf(cell), object.margin);
      meetings.push_back(shape.meets(box) && !shape.surrounds(box));
    });
  }
  return meetings;
}

void GridLists::fill() {
  starts_.assign(frame_->cellCount() + 1, 0);
  const std::vector<bool> meetings = findMeetings();
  const auto forEachEntry = [&](const auto& visit) {
    auto meeting = meetings.begin();
    for (std::uint32_t number = 0; number < items_.size(); ++number) {
      forEachCell(frame_->touchedBy(widenedBox(number)), [&](const GridSize& cell) {
        if (*meeting++) visit(frame_->indexOf(cell), number);
      });
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
