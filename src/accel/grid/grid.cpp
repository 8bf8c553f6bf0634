// Grid: which cells list what, and the walk that asks them.
//
//   1. The frame is the finest one, at most as fine as wanted, for which the boxes of all faces,
//      widened by the margin, do not overlap too many cells together. An object that is no mesh is
//      one face.
//   2. Each of those cells lists the face if its surface can be there: if the cell, widened by the
//      margin, meets the shape and is not all inside of a ball. Lists are linked, all in one array.
//   3. A ray asks what stands beside the grid, then its cells, one after the other: Cells::walk,
//      for each of the three questions. An object is asked in its own space, and a hit stays there
//      until the nearest one is known; so every number is that of the tree of objects.
#include "accel/grid/grid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "accel/grid/flat_scene.h"
#include "geometry/ray_table.h"

namespace {

using accel::FlatObject;
using accel::FlatScene;
using accel::FlatTransform;
using accel::PlacedFace;

/// A ray as it is seen inside Transforms. Where it was last is kept: objects of one Transform come
/// in a row.
struct RayInTransforms {
  const Ray& world;
  const FlatTransform* last = nullptr;
  Ray ray{};

  const Ray& inside(const FlatTransform& transform) {
    if (&transform != last) ray = transform.rayInside(world);
    last = &transform;
    return ray;
  }
};

/// The finest frame, at most as fine as `size`, of which the boxes of all faces together overlap
/// few enough cells.
GridFrame frameFor(const FlatScene& scene, GridSize size, double mostOverlaps) {
  for (;;) {
    const GridFrame frame(scene.box.widened(scene.margin), size);
    double overlaps = 0, faces = 0;
    scene.forEachFace(frame, scene.margin, [&](const PlacedFace& each) {
      overlaps += each.cells.count();
      faces += 1;
    });
    if (overlaps <= std::max(mostOverlaps, 2 * faces)) return frame;
    size = {(size.x() + 1) / 2, (size.y() + 1) / 2, (size.z() + 1) / 2};
  }
}

/// True for numbers whose squares and cubes are in range; false for NaN, which maxAbs passes over.
bool isUsual(const Vec3d& v, double least, double most) {
  const double largest = maxAbs(v);
  return largest >= least && largest <= most && std::isfinite(v.x() + v.y() + v.z());
}

}  // namespace

/// Const once it is built.
struct Grid::Cells {
  /// In the list of a cell: a face of an object, which is given by its number in the scene; and the
  /// number of the list's next entry, or kEnd.
  struct Entry {
    std::uint32_t object, face, next;
  };
  static constexpr std::uint32_t kEnd = 0xffffffffu;

  Cells(const Object3D& root, const GridSize& size, double mostEntries)
      : scene(root), frame(frameFor(scene, size, mostEntries)), heads(frame.cellCount(), kEnd) {
    std::copy_if(scene.objects.begin(), scene.objects.end(), std::back_inserter(beside),
                 [](const FlatObject& object) { return !object.isPlaced; });
    scene.forEachFace(frame, scene.margin, [this](const PlacedFace& each) {
      forEachCell(each.cells, [&](const GridSize& cell) {
        const BoundingBox box = frame.boxOf(cell).widened(scene.margin);
        if (!each.shape.meets(box) || each.shape.surrounds(box)) return;
        std::uint32_t& head = heads[frame.indexOf(cell)];
        entries.push_back({each.object.order, each.face, head});
        head = std::uint32_t(entries.size() - 1);
      });
    });
  }

  /// Whether cells and what is beside them tell all that the ray can hit between tmin and tmax.
  /// Beyond the scene's reach the margin grows in proportion to the distance, so the grown box of
  /// everything is asked: as a grid of one cell.
  bool listAll(const Ray& ray, double tmin, double tmax) const {
    if (frame.cellCount() == 0) return true;
    if (!isUsual(ray.getDirection(), 0x1p-100, 0x1p100)) return false;
    if (isUsual(ray.getOrigin(), 0, scene.reach)) return true;
    if (!isUsual(ray.getOrigin(), 0, 0x1p250)) return false;
    const double margin = scene.margin * (maxAbs(ray.getOrigin()) / scene.reach);
    const GridFrame grown(frame.box().widened(margin), {1, 1, 1});
    const CellWalk walk(grown, ray, tmin);
    return walk.isAtEnd() || walk.enterT() >= tmax;
  }

  /// Calls visit(object, face) for what stands beside the grid, then cell by cell, up to the first
  /// true; whether there was one. No cell is entered beyond tmax, which `visit` may lower. A ray
  /// that cells do not serve asks all objects.
  template <class Visit>
  bool walk(const Ray& ray, double tmin, const double& tmax, TestCounts& counts,
            const Visit& visit) const {
    const auto endsAt = [&](const FlatObject& object, std::uint32_t face) {
      ++counts.primitives;
      return visit(object, face);
    };
    const bool isServed = listAll(ray, tmin, tmax);
    for (const FlatObject& object : isServed ? beside : scene.objects) {
      for (std::uint32_t face = 0; face < object.faceCount; ++face) {
        if (endsAt(object, face)) return true;
      }
    }
    if (!isServed) return false;
    // Of several objects at one t the first one wins: a cell entered at just that t counts.
    for (CellWalk at(frame, ray, tmin); !at.isAtEnd() && at.enterT() <= tmax; at.advance()) {
      ++counts.nodes;
      for (std::uint32_t next = heads[at.index()]; next != kEnd; next = entries[next].next) {
        if (endsAt(scene.objects[entries[next].object], entries[next].face)) return true;
      }
    }
    return false;
  }

  const FlatScene scene;
  const GridFrame frame;
  std::vector<FlatObject> beside;    // what has no place in cells
  std::vector<std::uint32_t> heads;  // of each cell the number of its first entry, or kEnd
  std::vector<Entry> entries;
};

Grid::Grid(const Object3D& root, const GridSize& size, TestTally* tally, double mostEntries)
    : tally_(tally), cells_(std::make_unique<const Cells>(root, size, mostEntries)) {}

Grid::~Grid() = default;

bool Grid::intersect(const Ray& ray, Hit& hit, double tmin) const {
  RayInTransforms rays{ray};
  NearestSoFar best{hit.getT()};
  Hit nearest;  // in the space of its object
  TestCounts counts;
  cells_->walk(ray, tmin, best.t, counts, [&](const FlatObject& object, std::uint32_t face) {
    Hit found(best.inclusiveBound());
    if (object.intersect(face, rays.inside(*object.around), found, tmin) &&
        best.accepts(found.getT(), object.order, face)) {
      best = {found.getT(), object.order, face};
      nearest = found;
    }
    return false;
  });
  if (tally_) tally_->addNearest(counts);
  if (best.order == NearestSoFar::kNothing) return false;
  cells_->scene.objects[best.order].around->restate(ray, nearest);
  hit = nearest;
  return true;
}

bool Grid::occluded(const Ray& ray, double tmin, double tmax) const {
  RayInTransforms rays{ray};
  TestCounts counts;
  const auto isInTheWay = [&](const FlatObject& object, std::uint32_t face) {
    return object.occluded(face, rays.inside(*object.around), tmin, tmax);
  };
  const bool isBlocked = cells_->walk(ray, tmin, tmax, counts, isInTheWay);
  if (tally_) tally_->addShadow(counts);
  return isBlocked;
}

/// What several cells list is asked once, in the end.
void Grid::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  TestCounts counts;
  std::vector<std::uint64_t> faces;  // the object's number, then the face's
  cells_->walk(ray, 0, kEndless, counts, [&](const FlatObject& object, std::uint32_t face) {
    faces.push_back(std::uint64_t(object.order) << 32 | face);
    return false;
  });
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  RayInTransforms rays{ray};
  for (const std::uint64_t each : faces) {
    const FlatObject& object = cells_->scene.objects[each >> 32];
    object.visitCrossings(std::uint32_t(each), rays.inside(*object.around), visitor);
  }
  counts.primitives = faces.size();
  if (tally_) tally_->addShadow(counts);
}

std::string Grid::describe() const {
  const GridSize& size = cells_->frame.size();
  return "grid of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
         std::to_string(size[2]) + " cells; " + std::to_string(cells_->entries.size()) +
         " entries, " + std::to_string(cells_->beside.size()) + " objects beside";
}
