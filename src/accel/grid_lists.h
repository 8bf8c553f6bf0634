// GridLists: for each cell the items whose surface may be met in it.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "accel/grid.h"
#include "accel/grid_frame.h"
#include "accel/grid_parts.h"

namespace accel {

/// Parts [first, last) of an object: some faces of a mesh, or the whole of anything else.
struct GridItem {
  const PlacedObject* object;  // not owned
  std::uint32_t first, last;
};

class GridLists {
 public:
  /// `parts` is not owned. See Grid about the limits that `size` gives way to.
  GridLists(const GridParts& parts, const GridSize& size, const GridLimits& limits);

  /// Nothing where no object has a place in the grid.
  const std::optional<GridFrame>& frame() const { return frame_; }
  /// The items of cell `index`, in scene order.
  const std::uint32_t* begin(std::size_t index) const { return entries_.data() + starts_[index]; }
  const std::uint32_t* end(std::size_t index) const { return entries_.data() + starts_[index + 1]; }
  GridItem item(std::uint32_t number) const;
  std::size_t entryCount() const { return entries_.size(); }

  /// True where a ray from so far away that margins have to grow may meet anything listed.
  bool mayMeetFromAfar(const Ray& ray, double tmin, double tmax) const;

 private:
  struct Item {
    std::uint32_t object, first;
  };

  void listItems(double most);
  BoundingBox widenedBox(std::uint32_t number) const;
  void chooseFrame(const GridSize& size, double mostEntries);
  std::vector<bool> findMeetings() const;
  void fill();

  const GridParts& parts_;
  std::uint32_t run_ = 1;  // how many faces of a mesh make one item
  std::vector<Item> items_;
  BoundingBox box_;
  double largestMargin_ = 0;
  std::optional<GridFrame> frame_;
  std::vector<std::uint32_t> starts_, entries_;
};

}  // namespace accel
