// Grid: nearest hits, shadow rays and crossings, cell by cell.
//
// The walk through the cells is written once (Grid::ask) for the three questions. A question says
//   ask(item)   what it asks of an object, or of some faces of a mesh; true ends the walk
//   farthest()  how far along the ray anything can matter still: no cell beyond is entered
//   counts      what it has taken so far
//
// Objects inside Transforms are listed in the world's cells and asked in their own space: the ray
// enters by one multiplication for each Transform, outermost first, as in the plain tree, and the
// hit is taken back out only when the nearest one is known. So every number is the plain tree's.
#include "accel/grid/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "accel/grid/cell_lists.h"
#include "accel/grid/grid_objects.h"
#include "geometry/ray_table.h"

namespace accel {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// A ray as it is seen inside Transforms. Where it was last is kept: objects of one Transform come
/// in a row.
class RayInTransforms {
 public:
  RayInTransforms(const GridObjects& objects, const Ray& ray)
      : objects_(objects), world_(ray), ray_(ray) {}

  const Ray& in(int transform) {
    if (transform != innermost_) ray_ = enter(transform, nullptr);
    innermost_ = transform;
    return ray_;
  }
  /// Takes a hit inside `transform` out to the world.
  void restate(int transform, Hit& hit) const {
    std::vector<Step> path;
    enter(transform, &path);
    for (auto step = path.rbegin(); step != path.rend(); ++step) {
      step->transform->toParent(step->outside, hit);
    }
  }

 private:
  struct Step {
    const Transform* transform;
    Ray outside;
  };
  /// The ray inside; `path`, where it is not null, gets the Transforms on the way, the outermost
  /// first. The depth of recursion is the scene's nesting.
  Ray enter(int transform, std::vector<Step>* path) const {
    if (transform == GridTransform::kWorld) return world_;
    const GridTransform& inner = objects_.transformAt(transform);
    const Ray outside = enter(inner.parent, path);
    if (path) path->push_back({inner.transform, outside});
    return inner.transform->toObject(outside);
  }

  const GridObjects& objects_;
  const Ray& world_;
  Ray ray_;
  int innermost_ = GridTransform::kWorld;
};

/// Which hit is the nearest. It stays in the space of its object until it is stored.
struct NearestQuestion {
  RayInTransforms rays;
  double tmin;
  NearestSoFar best;
  Hit nearest{};
  int transform = GridTransform::kWorld;
  TestCounts counts{};

  double farthest() const { return best.t; }
  bool ask(const GridItem& item) {
    const GridObject& object = *item.object;
    const Ray& ray = rays.in(object.transform);
    counts.primitives += item.last - item.first;
    for (std::uint32_t face = item.first; face < item.last; ++face) {
      Hit hit(best.inclusiveBound());
      if (!object.intersect(face, ray, hit, tmin)) continue;
      if (!best.accepts(hit.getT(), object.order, hit.getFace())) continue;
      best = {hit.getT(), object.order, hit.getFace()};
      nearest = hit;
      transform = object.transform;
    }
    return false;
  }
  /// Stores what was found; false where nothing was.
  bool store(Hit& hit) {
    if (best.order == NearestSoFar::kNothing) return false;
    rays.restate(transform, nearest);
    hit = nearest;
    return true;
  }
};

/// Whether anything is hit between tmin and tmax.
struct ShadowQuestion {
  RayInTransforms rays;
  double tmin, tmax;
  TestCounts counts{};

  double farthest() const { return tmax; }
  bool ask(const GridItem& item) {
    const Ray& ray = rays.in(item.object->transform);
    for (std::uint32_t face = item.first; face < item.last; ++face) {
      ++counts.primitives;
      if (item.object->occluded(face, ray, tmin, tmax)) return true;
    }
    return false;
  }
};

/// Which items the cells list. One that several cells list is visited once, in the end.
struct CrossingsQuestion {
  RayInTransforms rays;
  std::vector<GridItem> items{};
  TestCounts counts{};

  double farthest() const { return kInf; }
  bool ask(const GridItem& item) {
    items.push_back(item);
    return false;
  }
  void visitAll(CrossingVisitor& visitor) {
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    for (const GridItem& item : items) {
      const Ray& ray = rays.in(item.object->transform);
      counts.primitives += item.last - item.first;
      for (std::uint32_t face = item.first; face < item.last; ++face) {
        item.object->visitCrossings(face, ray, visitor);
      }
    }
  }
};

/// True for numbers whose squares and cubes are in range; false for NaN, which maxAbs passes over.
bool isUsual(const Vec3d& v, double least, double most) {
  const double largest = maxAbs(v);
  return largest >= least && largest <= most && std::isfinite(v.x() + v.y() + v.z());
}

}  // namespace
}  // namespace accel

Grid::Grid(const Object3D& root, const GridSize& size, const GridLimits& limits, TestTally* tally)
    : tally_(tally),
      plain_(tally ? &countedRoot_.emplace(root, *tally) : &root),
      objects_(std::make_unique<const accel::GridObjects>(root)),
      lists_(std::make_unique<const accel::CellLists>(*objects_, size, limits)) {}

Grid::~Grid() = default;

Grid::Way Grid::wayOf(const Ray& ray, double tmin, double tmax) const {
  if (!lists_->frame()) return Way::beside;
  if (!accel::isUsual(ray.getDirection(), 0x1p-100, 0x1p100)) return Way::everything;
  if (accel::isUsual(ray.getOrigin(), 0, objects_->reach())) return Way::cells;
  if (!accel::isUsual(ray.getOrigin(), 0, 0x1p250)) return Way::everything;
  return lists_->mayMeetFromAfar(ray, tmin, tmax) ? Way::everything : Way::beside;
}

/// Asks what stands beside the grid, then cell by cell; true where an answer ended it.
template <class Question>
bool Grid::ask(Way way, const Ray& ray, double tmin, Question& question) const {
  for (const accel::GridObject& object : objects_->beside()) {
    if (question.ask({&object, 0, object.faceCount()})) return true;
  }
  if (way == Way::beside) return false;
  // Of several objects at one t the first in the scene wins: a cell entered at just that t counts.
  for (CellWalk walk(*lists_->frame(), ray, tmin);
       !walk.isAtEnd() && walk.enterT() <= question.farthest(); walk.advance()) {
    ++question.counts.nodes;
    const std::uint32_t* const end = lists_->end(walk.index());
    for (const std::uint32_t* number = lists_->begin(walk.index()); number != end; ++number) {
      if (question.ask(lists_->item(*number))) return true;
    }
  }
  return false;
}

bool Grid::intersect(const Ray& ray, Hit& hit, double tmin) const {
  const Way way = wayOf(ray, tmin, hit.getT());
  if (way == Way::everything) return plain_->intersect(ray, hit, tmin);
  accel::NearestQuestion question{{*objects_, ray}, tmin, {hit.getT()}};
  ask(way, ray, tmin, question);
  if (tally_) tally_->addNearest(question.counts);
  return question.store(hit);
}

bool Grid::occluded(const Ray& ray, double tmin, double tmax) const {
  const Way way = wayOf(ray, tmin, tmax);
  if (way == Way::everything) return plain_->occluded(ray, tmin, tmax);
  accel::ShadowQuestion question{{*objects_, ray}, tmin, tmax};
  const bool isBlocked = ask(way, ray, tmin, question);
  if (tally_) tally_->addShadow(question.counts);
  return isBlocked;
}

void Grid::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  const Way way = wayOf(ray, 0, accel::kInf);
  if (way == Way::everything) return plain_->visitCrossings(ray, visitor);
  accel::CrossingsQuestion question{{*objects_, ray}};
  ask(way, ray, 0, question);
  question.visitAll(visitor);
  if (tally_) tally_->addShadow(question.counts);
}

std::string Grid::describe() const {
  const GridSize size = lists_->frame() ? lists_->frame()->size() : GridSize{0, 0, 0};
  return "grid of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
         std::to_string(size[2]) + " cells; " + std::to_string(lists_->entryCount()) +
         " entries, " + std::to_string(objects_->beside().size()) + " objects beside";
}
