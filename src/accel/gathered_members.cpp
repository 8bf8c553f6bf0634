// ObjectTree: members that are very small beside the whole space.
//
// The floats of one tree cannot tell them apart: beside a ground of 1e6, nearly every ray that came
// near 2,000 spheres of 0.05 had to ask each in double, and took 200 times as long. So the space is
// divided into cells, and the small members of one cell become one member, with an ObjectTree of
// its own: in the same space, but with an anchor and a scale for them alone. That tree does the
// same with what is very small beside it.
#include <algorithm>
#include <tuple>

#include "accel/object_tree.h"

namespace accel {
namespace {

Vec3d centerOf(const BoundingBox& box) { return box.low() + (box.high() - box.low()) * 0.5; }

/// The middle one of all centres, on each axis by itself.
Vec3d middleOf(const std::vector<BoxedMember>& boxed) {
  Vec3d middle;
  std::vector<double> places(boxed.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(boxed.begin(), boxed.end(), places.begin(),
                   [axis](const BoxedMember& each) { return centerOf(each.box)[axis]; });
    const auto place = places.begin() + std::ptrdiff_t(places.size() / 2);
    std::nth_element(places.begin(), place, places.end());
    middle[axis] = *place;
  }
  return middle;
}

/// Which cell of a space, and which of a list.
struct CellMember {
  std::uint32_t cell, index;
};

/// The cells that the members are in, in their order, of a space whose longest side is `size`: 64
/// along it, of which one has the middle of all members in its own middle: where most stand
/// together, one cell mostly holds them.
std::vector<CellMember> cellMembers(const std::vector<BoxedMember>& boxed, double size) {
  std::vector<CellMember> all;
  const Vec3d middle = middleOf(boxed);
  for (const BoxedMember& each : boxed) {
    const Vec3d place = (centerOf(each.box) - middle) * (64 / size);  // -64 to 64
    std::uint32_t cell = 0;
    for (int axis = 0; axis < 3; ++axis) cell = cell << 8 | std::uint32_t(place[axis] + 64.5);
    all.push_back({cell, std::uint32_t(all.size())});
  }
  std::sort(all.begin(), all.end(), [](const CellMember& a, const CellMember& b) {
    return std::tie(a.cell, a.index) < std::tie(b.cell, b.index);
  });
  return all;
}

}  // namespace

BoxedMember ObjectTree::gather(const std::vector<std::uint32_t>& ids, int threads) {
  ObjectTree& tree = *gathered_.emplace_back(std::make_unique<ObjectTree>());
  for (const std::uint32_t id : ids) tree.add(members_[id], error_);
  tree.finish(threads);
  TreeMember member{};
  member.kind = TreeMember::Kind::tree;
  member.objectTree = &tree;
  members_.push_back(member);
  return {tree.box(), std::uint32_t(members_.size() - 1)};
}

/// Gathers the small members of each cell in which they are more than a few, and not a small part
/// of all: 300,000 specks spread over a square took 4 times the time to build in 4,000 trees, and
/// no less to trace. The depth of recursion is bounded by the range of measurable boxes, as a cell
/// is so much smaller than the space.
void ObjectTree::gatherSmall(std::vector<BoxedMember>& boxed, int threads) {
  constexpr double kSmall = 0x1p-12;
  constexpr std::size_t kFewSmall = 3, kMostTrees = 256;
  BoundingBox around;
  for (const BoxedMember& each : boxed) around.extend(each.box);
  const double size = around.longestSide();
  const auto isLarge = [&](const BoxedMember& each) {
    return each.box.longestSide() >= kSmall * size;
  };
  const auto largeCount = std::size_t(std::count_if(boxed.begin(), boxed.end(), isLarge));
  if (boxed.size() - largeCount <= kFewSmall) return;
  std::stable_partition(boxed.begin(), boxed.end(), isLarge);
  const std::vector<BoxedMember> small(boxed.begin() + std::ptrdiff_t(largeCount), boxed.end());
  boxed.resize(largeCount);
  const std::size_t few = std::max(kFewSmall, small.size() / kMostTrees);
  const std::vector<CellMember> all = cellMembers(small, size);
  for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
    std::vector<std::uint32_t> ids;
    while (end < all.size() && all[end].cell == all[first].cell) {
      ids.push_back(small[all[end++].index].id);
    }
    if (ids.size() > few) {
      boxed.push_back(gather(ids, threads));
    } else {
      for (; first < end; ++first) boxed.push_back(small[all[first].index]);
    }
  }
}

std::size_t ObjectTree::bytes() const {
  std::size_t bytes = bvh_.bytes();
  for (const auto& tree : gathered_) bytes += tree->bytes();
  return bytes;
}

bool ObjectTree::fits(const RayRange& range) const {
  return range.fits(bvh_.scale) && std::all_of(gathered_.begin(), gathered_.end(),
                                               [&](auto& tree) { return tree->fits(range); });
}

}  // namespace accel
