// Grid: nearest hits, shadow rays and crossings, cell by cell.
#include "accel/grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "accel/counting_tree.h"
#include "accel/grid_lists.h"
#include "accel/grid_parts.h"
#include "accel/space.h"

namespace {

using accel::GridItem;
using accel::GridLists;
using accel::GridParts;
using accel::GridSpace;
using accel::NearestQuery;
using accel::PlacedObject;

/// A ray in the spaces that it enters. Each is entered from its parent, the outermost first; the
/// last one is kept, for items of one space come in a row.
class RayInSpaces {
 public:
  RayInSpaces(const GridParts& parts, const Ray& ray)
      : spaces_(parts.spaces()), world_(ray), last_(ray) {}

  const Ray& in(int space) {
    if (space != lastSpace_) last_ = moved(space);
    lastSpace_ = space;
    return last_;
  }
  /// Takes a hit in `space` out to the world.
  void restate(int space, Hit& hit) const {
    std::vector<int> path;
    for (; space != GridSpace::kWorld; space = at(space).parent) path.push_back(space);
    std::vector<Ray> rays(1, world_);
    for (std::size_t i = path.size(); i-- > 1;) {
      rays.push_back(at(path[i]).transform->toObject(rays.back()));
    }
    for (const int inner : path) {
      at(inner).transform->toParent(rays.back(), hit);
      rays.pop_back();
    }
  }

 private:
  const GridSpace& at(int space) const { return spaces_[std::size_t(space)]; }
  Ray moved(int space) const {
    if (space == GridSpace::kWorld) return world_;
    return at(space).transform->toObject(moved(at(space).parent));
  }

  const std::vector<GridSpace>& spaces_;
  const Ray& world_;
  Ray last_;
  int lastSpace_ = GridSpace::kWorld;
};

GridItem whole(const PlacedObject& object) { return {&object, 0, object.partCount()}; }

/// The nearest hit so far, in the space of the object that was hit.
class NearestHit {
 public:
  NearestHit(RayInSpaces& rays, double tmin, double tmax, TestCounts& counts)
      : rays_(rays), counts_(counts) {
    query_.hit = &hit_;
    query_.tmin = tmin;
    query_.t = tmax;
  }

  double t() const { return query_.t; }
  void ask(const GridItem& item) {
    counts_.primitives += item.last - item.first;
    item.object->mesh ? askFaces(item) : askObject(*item.object);
  }
  bool store(Hit& hit) {
    if (query_.order == NearestQuery::kNothing) return false;
    rays_.restate(space_, hit_);
    hit = hit_;
    return true;
  }

 private:
  void askFaces(const GridItem& item) {
    const PlacedObject& object = *item.object;
    const Ray& ray = rays_.in(object.space);
    for (std::uint32_t face = item.first; face < item.last; ++face) {
      double t;
      if (!object.mesh->nearestRoot(face, ray, query_.tmin, query_.inclusiveBound(), t)) continue;
      if (!query_.accepts(t, object.order, face)) continue;
      object.mesh->setHit(face, ray, t, hit_);
      query_.found(t, object.order, face);
      space_ = object.space;
    }
  }
  void askObject(const PlacedObject& object) {
    Hit hit(query_.inclusiveBound());
    if (!object.object->intersect(rays_.in(object.space), hit, query_.tmin)) return;
    if (!query_.accepts(hit.getT(), object.order, hit.getFace())) return;
    hit_ = hit;
    query_.found(hit.getT(), object.order, hit.getFace());
    space_ = object.space;
  }

  RayInSpaces& rays_;
  TestCounts& counts_;
  Hit hit_;
  NearestQuery query_;
  int space_ = GridSpace::kWorld;
};

/// What a shadow ray wants to know.
struct ShadowWay {
  RayInSpaces& rays;
  double tmin, tmax;
  TestCounts& counts;
};

bool isBlockedBy(const GridItem& item, const ShadowWay& way) {
  const Ray& ray = way.rays.in(item.object->space);
  if (!item.object->mesh) {
    ++way.counts.primitives;
    return item.object->object->occluded(ray, way.tmin, way.tmax);
  }
  double t;
  for (std::uint32_t face = item.first; face < item.last; ++face) {
    ++way.counts.primitives;
    if (item.object->mesh->nearestRoot(face, ray, way.tmin, way.tmax, t)) return true;
  }
  return false;
}

void visitCrossingsOf(const GridItem& item, RayInSpaces& rays, CrossingVisitor& visitor,
                      TestCounts& counts) {
  const Ray& ray = rays.in(item.object->space);
  counts.primitives += item.last - item.first;
  if (!item.object->mesh) return item.object->object->visitCrossings(ray, visitor);
  for (std::uint32_t face = item.first; face < item.last; ++face) {
    item.object->mesh->visitFace(face, ray, visitor);
  }
}

/// What a ray may ask the cells.
enum class Way {
  cells,       ///< the cells it passes
  nothing,     ///< nothing listed can be met
  everything,  ///< the cells tell too little: the plain objects are asked
};

/// True for numbers whose squares and cubes are in range; false for NaN, which maxAbs passes over.
bool isUsual(const Vec3d& v, double least, double most) {
  const double largest = maxAbs(v);
  return largest >= least && largest <= most && std::isfinite(v.x() + v.y() + v.z());
}

}  // namespace

struct Grid::Content {
  Content(const Object3D& root, const GridSize& size, const GridLimits& limits)
      : parts(root), lists(parts, size, limits) {}

  Way wayOf(const Ray& ray, double tmin, double tmax) const {
    if (!lists.frame()) return Way::nothing;
    if (!isUsual(ray.getDirection(), 0x1p-100, 0x1p100)) return Way::everything;
    if (isUsual(ray.getOrigin(), 0, parts.reach())) return Way::cells;
    if (!isUsual(ray.getOrigin(), 0, 0x1p250)) return Way::everything;
    return lists.mayMeetFromAfar(ray, tmin, tmax) ? Way::everything : Way::nothing;
  }

  const GridParts parts;
  const GridLists lists;
};

Grid::Grid(const Object3D& root, const GridSize& size, const GridLimits& limits)
    : content_(std::make_unique<const Content>(root, size, limits)), root_(&root) {}

Grid::~Grid() = default;

bool Grid::intersect(const Ray& ray, Hit& hit, double tmin, RayTestCounts& counts) const {
  const Way way = content_->wayOf(ray, tmin, hit.getT());
  if (way == Way::everything) return CountingTree(*root_, counts).intersect(ray, hit, tmin);
  RayInSpaces rays(content_->parts, ray);
  NearestHit nearest(rays, tmin, hit.getT(), counts.nearest);
  for (const PlacedObject& object : content_->parts.beside()) nearest.ask(whole(object));
  if (way == Way::nothing) return nearest.store(hit);
  const GridLists& lists = content_->lists;
  // Of several objects at one t the first in the scene wins: a cell entered at just that t counts.
  for (CellWalk walk(*lists.frame(), ray, tmin); !walk.isAtEnd() && walk.enterT() <= nearest.t();
       walk.advance()) {
    ++counts.nearest.nodes;
    const std::uint32_t* end = lists.end(walk.index());
    for (const std::uint32_t* i = lists.begin(walk.index()); i != end; ++i) {
      nearest.ask(lists.item(*i));
    }
  }
  return nearest.store(hit);
}

bool Grid::occluded(const Ray& ray, double tmin, double tmax, RayTestCounts& counts) const {
  const Way way = content_->wayOf(ray, tmin, tmax);
  if (way == Way::everything) return CountingTree(*root_, counts).occluded(ray, tmin, tmax);
  RayInSpaces rays(content_->parts, ray);
  const ShadowWay shadow = {rays, tmin, tmax, counts.shadow};
  for (const PlacedObject& object : content_->parts.beside()) {
    if (isBlockedBy(whole(object), shadow)) return true;
  }
  if (way == Way::nothing) return false;
  const GridLists& lists = content_->lists;
  for (CellWalk walk(*lists.frame(), ray, tmin); !walk.isAtEnd() && walk.enterT() <= tmax;
       walk.advance()) {
    ++counts.shadow.nodes;
    const std::uint32_t* end = lists.end(walk.index());
    for (const std::uint32_t* i = lists.begin(walk.index()); i != end; ++i) {
      if (isBlockedBy(lists.item(*i), shadow)) return true;
    }
  }
  return false;
}

void Grid::visitCrossings(const Ray& ray, CrossingVisitor& visitor, RayTestCounts& counts) const {
  const Way way = content_->wayOf(ray, 0, Hit().getT());
  if (way == Way::everything) return CountingTree(*root_, counts).visitCrossings(ray, visitor);
  RayInSpaces rays(content_->parts, ray);
  for (const PlacedObject& object : content_->parts.beside()) {
    visitCrossingsOf(whole(object), rays, visitor, counts.shadow);
  }
  if (way == Way::nothing) return;
  // An item that several cells list is asked once.
  const GridLists& lists = content_->lists;
  std::vector<std::uint32_t> found;
  for (CellWalk walk(*lists.frame(), ray, 0); !walk.isAtEnd(); walk.advance()) {
    ++counts.shadow.nodes;
    found.insert(found.end(), lists.begin(walk.index()), lists.end(walk.index()));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  for (const std::uint32_t number : found) {
    visitCrossingsOf(lists.item(number), rays, visitor, counts.shadow);
  }
}

bool Grid::intersect(const Ray& ray, Hit& hit, double tmin) const {
  RayTestCounts unused;
  return intersect(ray, hit, tmin, unused);
}

bool Grid::occluded(const Ray& ray, double tmin, double tmax) const {
  RayTestCounts unused;
  return occluded(ray, tmin, tmax, unused);
}

void Grid::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  RayTestCounts unused;
  visitCrossings(ray, visitor, unused);
}

void Grid::addBounds(const Matrix& toWorld, BoundingBox& box) const {
  root_->addBounds(toWorld, box);
}

bool Grid::isBounded() const { return root_->isBounded(); }

std::string Grid::describe() const {
  const GridLists& lists = content_->lists;
  const GridSize size = lists.frame() ? lists.frame()->size() : GridSize{0, 0, 0};
  return "grid of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
         std::to_string(size[2]) + " cells; " + std::to_string(lists.entryCount()) + " entries, " +
         std::to_string(content_->parts.beside().size()) + " objects beside";
}
