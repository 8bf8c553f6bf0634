// Grid: which cells list what, and the walk that asks them.
//
//   1. The scene is cut into items: objects, and runs of so many faces that there are not too many.
//   2. The frame is the finest one, at most as fine as wanted, for which the boxes of all items,
//      widened by the margin, do not overlap too many cells together.
//   3. Each of those cells lists the item if its surface can be there: if the cell, widened by the
//      margin, meets the shape and is not all inside of a ball. Lists are linked, all in one array.
//   4. A ray asks what stands beside the grid, then its cells, one after the other: Cells::walk,
//      for each of the three questions. An object is asked in its own space, and a hit stays there
//      until the nearest one is known; so every number is that of the tree of objects.
#include "accel/grid/grid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "accel/grid/flat_scene.h"
#include "geometry/ray_table.h"

namespace {

using accel::FlatObject;
using accel::FlatScene;
using accel::WorldShape;

/// A ray as it is seen inside Transforms. Where it was last is kept: objects of one Transform come
/// in a row.
class RayInTransforms {
 public:
  RayInTransforms(const FlatScene& scene, const Ray& world)
      : scene_(scene), world_(world), inside_(world) {}

  const Ray& in(int transform) {
    if (transform != last_) inside_ = scene_.rayInside(transform, world_);
    last_ = transform;
    return inside_;
  }

 private:
  const FlatScene& scene_;
  const Ray& world_;
  Ray inside_;
  int last_ = FlatScene::kWorld;
};

/// True for numbers whose squares and cubes are in range; false for NaN, which maxAbs passes over.
bool isUsual(const Vec3d& v, double least, double most) {
  const double largest = maxAbs(v);
  return largest >= least && largest <= most && std::isfinite(v.x() + v.y() + v.z());
}

}  // namespace

/// Const once it is built.
struct Grid::Cells {
  /// What cells list: faces [first, last) of a mesh, or the whole of any other object.
  struct Item {
    std::uint32_t object;  ///< its number in the scene
    std::uint32_t first, last;
  };
  /// An item in the list of a cell, and the number of the list's next entry, or kEnd.
  struct Entry {
    std::uint32_t item, next;
  };
  static constexpr std::uint32_t kEnd = 0xffffffffu;

  Cells(const Object3D& root, const GridSize& size, const GridLimits& limits) : scene(root) {
    listItems(limits.items);
    chooseFrame(size, limits.entries);
    fill();
  }
  void listItems(double most);
  void chooseFrame(GridSize size, double mostEntries);
  void fill();
  BoundingBox boxOf(const Item& item) const {
    const FlatObject& object = scene.objects()[item.object];
    return scene.boxOf(object, item.first, item.last).widened(scene.margin());
  }

  bool listAll(const Ray& ray, double tmin, double tmax) const;
  template <class Visit>
  bool walk(const Ray& ray, double tmin, const double& tmax, TestCounts& counts,
            const Visit& visit) const;

  const FlatScene scene;
  std::vector<Item> items, beside;  // what has a place in cells, and what has none
  GridFrame frame;
  std::vector<std::uint32_t> heads;  // of each cell the number of its first entry, or kEnd
  std::vector<Entry> entries;
};

void Grid::Cells::listItems(double most) {
  double faceCount = 0;
  for (const FlatObject& object : scene.objects()) {
    if (object.isPlaced) faceCount += object.faceCount();
  }
  const auto run = std::uint64_t(std::clamp(std::ceil(faceCount / most), 1.0, 0x1p32));
  for (std::uint32_t number = 0; number < scene.objects().size(); ++number) {
    const FlatObject& object = scene.objects()[number];
    const std::uint64_t end = object.faceCount();
    if (!object.isPlaced) beside.push_back({number, 0, object.faceCount()});
    for (std::uint64_t first = 0; object.isPlaced && first < end; first += run) {
      items.push_back({number, std::uint32_t(first), std::uint32_t(std::min(first + run, end))});
    }
  }
}

void Grid::Cells::chooseFrame(GridSize size, double mostEntries) {
  BoundingBox box;
  for (const Item& item : items) box.extend(boxOf(item));
  for (;;) {
    frame = GridFrame(box, size);
    double overlaps = 0;
    for (const Item& item : items) overlaps += frame.overlappedBy(boxOf(item)).count();
    if (overlaps <= mostEntries || frame.cellCount() == 1) return;
    size = {(size.x() + 1) / 2, (size.y() + 1) / 2, (size.z() + 1) / 2};
  }
}

void Grid::Cells::fill() {
  heads.assign(frame.cellCount(), kEnd);
  for (std::size_t number = 0; number < items.size(); ++number) {
    const Item& item = items[number];
    const bool isOneFace = item.last - item.first == 1;
    const WorldShape shape =
        isOneFace ? scene.shapeOf(scene.objects()[item.object], item.first) : WorldShape();
    forEachCell(frame.overlappedBy(boxOf(item)), [&](const GridSize& cell) {
      const BoundingBox box = frame.boxOf(cell).widened(scene.margin());
      if (!shape.meets(box) || shape.surrounds(box)) return;
      std::uint32_t& head = heads[frame.indexOf(cell)];
      entries.push_back({std::uint32_t(number), head});
      head = std::uint32_t(entries.size() - 1);
    });
  }
}

/// Whether cells and what is beside them tell all that the ray can hit between tmin and tmax.
/// Beyond the scene's reach the margin grows in proportion to the distance, so the grown box of
/// everything is asked: as a grid of one cell.
bool Grid::Cells::listAll(const Ray& ray, double tmin, double tmax) const {
  if (frame.cellCount() == 0) return true;
  if (!isUsual(ray.getDirection(), 0x1p-100, 0x1p100)) return false;
  if (isUsual(ray.getOrigin(), 0, scene.reach())) return true;
  if (!isUsual(ray.getOrigin(), 0, 0x1p250)) return false;
  const double margin = scene.margin() * (maxAbs(ray.getOrigin()) / scene.reach());
  const GridFrame grown(frame.box().widened(margin), {1, 1, 1});
  const CellWalk walk(grown, ray, tmin);
  return walk.isAtEnd() || walk.enterT() >= tmax;
}

/// Calls visit(item) for what stands beside the grid, then cell by cell, up to the first true;
/// whether there was one. No cell is entered beyond tmax, which `visit` may lower.
template <class Visit>
bool Grid::Cells::walk(const Ray& ray, double tmin, const double& tmax, TestCounts& counts,
                       const Visit& visit) const {
  for (const Item& item : beside) {
    if (visit(item)) return true;
  }
  // Of several objects at one t the first in the scene wins: a cell entered at just that t counts.
  for (CellWalk walk(frame, ray, tmin); !walk.isAtEnd() && walk.enterT() <= tmax; walk.advance()) {
    ++counts.nodes;
    for (std::uint32_t at = heads[walk.index()]; at != kEnd; at = entries[at].next) {
      if (visit(items[entries[at].item])) return true;
    }
  }
  return false;
}

Grid::Grid(const Object3D& root, const GridSize& size, const GridLimits& limits, TestTally* tally)
    : tally_(tally),
      plain_(tally ? &countedRoot_.emplace(root, *tally) : &root),
      cells_(std::make_unique<const Cells>(root, size, limits)) {}

Grid::~Grid() = default;

bool Grid::intersect(const Ray& ray, Hit& hit, double tmin) const {
  if (!cells_->listAll(ray, tmin, hit.getT())) return plain_->intersect(ray, hit, tmin);
  RayInTransforms rays(cells_->scene, ray);
  NearestSoFar best{hit.getT()};
  Hit nearest;  // in the space of its object
  TestCounts counts;
  cells_->walk(ray, tmin, best.t, counts, [&](const Cells::Item& item) {
    const FlatObject& object = cells_->scene.objects()[item.object];
    const Ray& inside = rays.in(object.transform);
    counts.primitives += item.last - item.first;
    for (std::uint32_t face = item.first; face < item.last; ++face) {
      Hit found(best.inclusiveBound());
      if (!object.intersect(face, inside, found, tmin)) continue;
      if (!best.accepts(found.getT(), item.object, face)) continue;
      best = {found.getT(), item.object, face};
      nearest = found;
    }
    return false;
  });
  if (tally_) tally_->addNearest(counts);
  if (best.order == NearestSoFar::kNothing) return false;
  cells_->scene.restate(cells_->scene.objects()[best.order].transform, ray, nearest);
  hit = nearest;
  return true;
}

bool Grid::occluded(const Ray& ray, double tmin, double tmax) const {
  if (!cells_->listAll(ray, tmin, tmax)) return plain_->occluded(ray, tmin, tmax);
  RayInTransforms rays(cells_->scene, ray);
  TestCounts counts;
  const bool isBlocked = cells_->walk(ray, tmin, tmax, counts, [&](const Cells::Item& item) {
    const FlatObject& object = cells_->scene.objects()[item.object];
    const Ray& inside = rays.in(object.transform);
    for (std::uint32_t face = item.first; face < item.last; ++face) {
      ++counts.primitives;
      if (object.occluded(face, inside, tmin, tmax)) return true;
    }
    return false;
  });
  if (tally_) tally_->addShadow(counts);
  return isBlocked;
}

/// What several cells list is visited once, in the end.
void Grid::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  if (!cells_->listAll(ray, 0, kEndless)) return plain_->visitCrossings(ray, visitor);
  TestCounts counts;
  std::vector<const Cells::Item*> items;
  cells_->walk(ray, 0, kEndless, counts, [&](const Cells::Item& item) {
    items.push_back(&item);
    return false;
  });
  std::sort(items.begin(), items.end(), std::less<>());
  items.erase(std::unique(items.begin(), items.end()), items.end());
  RayInTransforms rays(cells_->scene, ray);
  for (const Cells::Item* item : items) {
    const FlatObject& object = cells_->scene.objects()[item->object];
    counts.primitives += item->last - item->first;
    for (std::uint32_t face = item->first; face < item->last; ++face) {
      object.visitCrossings(face, rays.in(object.transform), visitor);
    }
  }
  if (tally_) tally_->addShadow(counts);
}

std::string Grid::describe() const {
  const GridSize& size = cells_->frame.size();
  return "grid of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
         std::to_string(size[2]) + " cells; " + std::to_string(cells_->entries.size()) +
         " entries, " + std::to_string(cells_->beside.size()) + " objects beside";
}
