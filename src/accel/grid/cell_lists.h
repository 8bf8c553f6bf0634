// CellLists: for each cell of a grid the items whose surface may be met in it.
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "accel/grid/grid.h"
#include "accel/grid/grid_frame.h"
#include "accel/grid/grid_objects.h"

namespace accel {

/// Faces [first, last) of a mesh, or the whole of any other object.
struct GridItem {
  const GridObject* object;  // not owned
  std::uint32_t first, last;

  friend bool operator<(const GridItem& a,
                        const GridItem& b) {  // in scene order
    return std::make_pair(a.object->order, a.first) < std::make_pair(b.object->order, b.first);
  }
  friend bool operator==(const GridItem& a, const GridItem& b) { return !(a < b) && !(b < a); }
};

class CellLists {
 public:
  /// `objects` is not owned. See Grid about the limits that `size` gives way to.
  CellLists(const GridObjects& objects, const GridSize& size, const GridLimits& limits);

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
  CellRange cellsOf(std::uint32_t number) const { return frame_->overlappedBy(widenedBox(number)); }
  void chooseFrame(const GridSize& size, double mostEntries);
  std::vector<bool> findMeetings() const;
  void fill();

  const GridObjects& objects_;
  std::uint32_t run_ = 1;  // how many faces of a mesh make one item
  std::vector<Item> items_;
  BoundingBox box_;
  std::optional<GridFrame> frame_;
  std::vector<std::uint32_t> starts_, entries_;
};

}  // namespace accel
