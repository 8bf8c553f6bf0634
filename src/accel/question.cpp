// Question: the three kinds, and how candidates are decided.
//
// A stream has walked a tree and left candidates. The one double function of triangles, or that of
// spheres, decides them, on numbers that the leaf holds exactly or the scene is asked for. So t,
// face and normal are those of the plain objects, whatever the instruction set.
//   nearest    When the walk is over, what begins behind a ray's bound has dropped out. Where one
//              triangle is left and it is proven, nothing is to be decided; else each is asked. The
//              hits of all winners are then computed together.
//   occluded   Any candidate that is hit between tmin and tmax blocks its ray.
//   crossings  Of an object that is met before tmax, all crossings count, before and behind it; a
//              face once, in however many leaves it is met. Those with triangles that are proven to
//              be hit are computed together; they lie far enough from all edges to be crossed as
//              well.
// Where more candidates come than are kept, they are decided while the walk goes on.
#include "accel/question.h"

#include <algorithm>
#include <unordered_set>

#include "accel/object_tree.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"

namespace accel {
namespace {

/// Tells of what is found inside of a Transform, where the rays have rows of their own.
class CrossingsInside : public RowCrossingVisitor {
 public:
  CrossingsInside(const RowList& list, RowCrossingVisitor& visitor)
      : list_(list), visitor_(visitor) {}
  void visit(int row, const Crossing& crossing) override {
    visitor_.visit(list_.rows[row], crossing);
  }

 private:
  const RowList& list_;  // row i inside is list_.rows[i] outside
  RowCrossingVisitor& visitor_;
};

}  // namespace

/// The rays of one stream among the leaves of one tree.
class Question::Walk {
 public:
  Walk(Question& question, const AskedTree& tree, Stream& stream)
      : tree_(tree), stream_(stream), question_(question) {
    stream.attach(*this);
  }

  static void resolve(Stream& stream) {
    auto& self = *static_cast<Walk*>(stream.context);
    for (int k = 0; k < stream.candidateCount; ++k) self.decide(stream.candidates[k]);
    stream.candidateCount = 0;
  }
  static void askObject(Stream& stream, std::uint32_t id, const std::uint16_t* list, int count) {
    auto& self = *static_cast<Walk*>(stream.context);
    const Arena::Frame frame(self.question_.arena_);
    auto* rows = self.question_.arena_.take<std::uint16_t>(std::size_t(count));
    std::transform(list, list + count, rows,
                   [&](int ray) { return std::uint16_t(stream.rowOf(ray)); });
    self.tree_.askObject(id, self.question_, self.question_.openOf({rows, count}));
    for (int k = 0; k < count; ++k) self.objectWasAsked(list[k]);
  }

 protected:
  virtual ~Walk() = default;
  virtual void decide(const Candidate& c) = 0;
  /// Takes notice of what an object may have changed for a ray.
  virtual void objectWasAsked(int /*ray*/) {}

  LeafPrimitive primitiveOf(const Candidate& c) const {
    return tree_.primitiveAt(stream_.words + c.leaf, c.lane);
  }
  /// True where the ray hits the primitive, the first time above tmin at t.
  bool isHit(const Candidate& c, LeafPrimitive& p, double& t) const {
    const int row = stream_.rowOf(c.ray);
    const Ray ray = stream_.rays->rayOf(row);
    const double tmin = stream_.rays->tmin[row];
    const bool isLeft = ray.leaves(p.object, p.face);
    if (isLeft && !p.isSphere && !tree_.takesPlace(p)) return false;
    double numbers[9];
    tree_.getNumbers(stream_.words + c.leaf, c.lane, numbers, 1);
    const Vec3d a = Vec3d::of(numbers), b = Vec3d::of(numbers + 3);
    if (p.isSphere) {
      return sphere::nearestRoot(a, numbers[3], ray.getOrigin(), ray.getDirection(), tmin,
                                 Hit().getT(), isLeft, t);
    }
    return triangle::intersect(a, b, Vec3d::of(numbers + 6), ray, t) && t > tmin;
  }
  /// Appends the primitive's numbers.
  void add(std::uint32_t leaf, int lane, int row, LeafHits& list) const {
    tree_.getNumbers(stream_.words + leaf, lane, &list.numbers[0][list.count], LeafHits::kMost);
    list.rows[list.count++] = std::uint16_t(row);
  }

  const AskedTree& tree_;
  Stream& stream_;

 private:
  Question& question_;
};

void Question::askTree(const AskedTree& tree, const RowList& rows) {
  if (tree.bvh().isEmpty() || rows.count == 0) return;
  const Arena::Frame frame(arena_);
  Stream stream(tree.bvh(), raysFor(tree), rows, arena_);
  kernels_.prepare(stream);
  if (stream.count == 0) return;
  walk(tree, stream);
  count({stream.nodesVisited, stream.primitivesTested});
}

/// The depth of recursion is that of the Transforms in the scene.
void Question::askMember(const TreeMember& member, const RowList& rows) {
  if (rows.count == 0) return;
  const Arena::Frame frame(arena_);
  switch (member.kind) {
    case TreeMember::Kind::plain:
      return askObject(*member.object, member.order, rows);
    case TreeMember::Kind::shape:
      return askShapes(member.shape, 1, rows);
    case TreeMember::Kind::mesh:
      return askTree(member.askedMesh(), rows);
    case TreeMember::Kind::transformedMesh:
    case TreeMember::Kind::transformedTree:
      return askInside(member, rows);
  }
}

void Question::askWithin(const TreeMember& member, Question& inside) {
  const RowList all = RowList::all(inside.rays_.count, inside.arena_);
  if (member.kind == TreeMember::Kind::transformedMesh) {
    inside.askTree(member.askedMesh(), all);
  } else {
    member.objectTree->ask(inside, all);
  }
}

RayTable Question::movedInto(const Transform& transform, const RowList& rows) const {
  RayTable inside(arena_, rows.count, rays_.source != nullptr);
  kernels_.moveRays(transform.getInverse(), rays_, rows, inside);
  for (int k = 0; inside.source && k < rows.count; ++k) {
    inside.source[k] = rays_.source[rows.rows[k]];
    inside.sourceFace[k] = rays_.sourceFace[rows.rows[k]];
  }
  return inside;
}

class NearestQuestion::NearestWalk : public Walk {
 public:
  NearestWalk(NearestQuestion& question, const AskedTree& tree, Stream& stream)
      : Walk(question, tree, stream), hits_(question.hits_) {
    const auto count = std::size_t(stream.count);
    winners_ = question.arena_.take<Winner>(count);
    std::fill(winners_, winners_ + count, Winner{0, 0, 0});
    survivors_ = question.arena_.take<std::uint8_t>(count);
    std::fill(survivors_, survivors_ + count, std::uint8_t(0));
  }

  /// Decides what the walk has left, and computes the hits.
  void finish(const Kernels& kernels) {
    Candidate* const end = stream_.candidates + stream_.candidateCount;
    for (const Candidate* c = stream_.candidates; c != end; ++c) {
      if (survives(*c) && survivors_[c->ray] < 2) ++survivors_[c->ray];
    }
    for (const Candidate* c = stream_.candidates; c != end; ++c) {
      consider(*c, isUndecided_ && survivors_[c->ray] == 1);
    }
    computeHits(kernels);
  }

 private:
  struct Winner {
    std::uint32_t leaf;  // 0: none
    std::uint32_t face;
    std::uint8_t lane;
  };

  void decide(const Candidate& c) override {
    isUndecided_ = false;
    consider(c, false);
  }
  void objectWasAsked(int ray) override {
    isUndecided_ = false;
    stream_.lowerBound(ray, stream_.rays->tmax[stream_.rowOf(ray)]);
  }
  bool survives(const Candidate& c) const { return c.tLow <= stream_.boxRays[c.ray].tmaxUp; }

  /// Lets the candidate win where it is the nearest so far; `isOnly` where no other is left and
  /// nothing was hit before. Spheres are decided always, for their t.
  void consider(const Candidate& c, bool isOnly) {
    if (!survives(c)) return;
    LeafPrimitive primitive = primitiveOf(c);
    const int row = stream_.rowOf(c.ray);
    if (!(isOnly && c.isProven) || primitive.isSphere) {
      const NearestSoFar best{stream_.rays->tmax[row], hits_.order[row], winners_[c.ray].face};
      double t;
      if (!isHit(c, primitive, t) || !best.accepts(t, primitive.order, primitive.face)) return;
      stream_.rays->tmax[row] = t;
      stream_.lowerBound(c.ray, t);
    }
    winners_[c.ray] = {c.leaf, primitive.face, c.lane};
    hits_.order[row] = primitive.order;
  }

  void computeHits(const Kernels& kernels) {
    LeafHits triangles, spheres;
    for (int ray = 0; ray < stream_.count; ++ray) {
      const Winner& winner = winners_[ray];
      if (winner.leaf == 0) continue;
      const LeafPrimitive primitive = tree_.primitiveAt(stream_.words + winner.leaf, winner.lane);
      const int row = stream_.rowOf(ray);
      if (hits_.order[row] != primitive.order) continue;  // another member was nearer
      hits_.material[row] = primitive.material;
      hits_.object[row] = primitive.object;
      hits_.face[row] = winner.face;
      LeafHits& list = primitive.isSphere ? spheres : triangles;
      add(winner.leaf, winner.lane, row, list);
      if (list.count == LeafHits::kMost) computeHits(kernels, triangles, spheres);
    }
    computeHits(kernels, triangles, spheres);
  }
  void computeHits(const Kernels& kernels, LeafHits& triangles, LeafHits& spheres) {
    triangles.fillUp();
    kernels.hitsOfTriangles(triangles, *stream_.rays, hits_);
    tree_.shade({triangles.rows, triangles.count}, hits_);
    spheres.fillUp();
    kernels.hitsOfSpheres(spheres, *stream_.rays, hits_);
    triangles.count = spheres.count = 0;
  }

  HitTable& hits_;
  Winner* winners_;          // of each ray
  std::uint8_t* survivors_;  // of each ray, two at most
  bool isUndecided_ = true;  // no ray has been decided yet
};

void NearestQuestion::walk(const AskedTree& tree, Stream& stream) {
  NearestWalk walk(*this, tree, stream);
  kernels_.nearest(stream);
  walk.finish(kernels_);
}

void NearestQuestion::askObject(const Object3D& object, std::uint32_t order, const RowList& rows) {
  for (const int row : rows) {
    const NearestSoFar best{rays_.tmax[row], hits_.order[row]};
    // What comes later in the scene has to be nearer.
    Hit hit(best.order < order ? best.t : best.inclusiveBound());
    if (!object.intersect(rays_.rayOf(row), hit, rays_.tmin[row])) continue;
    if (!best.accepts(hit.getT(), order)) continue;
    rays_.tmax[row] = hit.getT();
    hits_.setRow(row, hit, order);
  }
}

void NearestQuestion::askShapes(const ShapeNumbers* shapes, int count, const RowList& rows) {
  kernels_.nearestOfShapes(shapes, count, rays_, rows, hits_);
}

void NearestQuestion::askInside(const TreeMember& member, const RowList& rows) {
  const RayTable inside = movedInto(member.transform(), rows);
  HitTable found(arena_, rows.count);
  for (int k = 0; k < rows.count; ++k) found.order[k] = hits_.order[rows.rows[k]];
  NearestQuestion within(kernels_, inside, found, arena_);
  askWithin(member, within);
  auto* rowsInside = arena_.take<std::uint16_t>(std::size_t(rows.count));
  auto* rowsOutside = arena_.take<std::uint16_t>(std::size_t(rows.count));
  const bool arePlacesGiven = found.hasTexturePlaces || hits_.hasTexturePlaces;
  int count = 0;
  for (int k = 0; k < rows.count; ++k) {
    const int row = rows.rows[k];
    if (found.order[k] == hits_.order[row]) continue;
    rays_.tmax[row] = inside.tmax[k];
    hits_.material[row] = found.material[k];
    hits_.object[row] = found.object[k];
    hits_.face[row] = found.face[k];
    if (arePlacesGiven) hits_.setTexturePlace(row, found.texturePlaceOf(k));
    hits_.order[row] = found.order[k];
    rowsInside[count] = std::uint16_t(k);
    rowsOutside[count++] = std::uint16_t(row);
  }
  kernels_.moveHits(member.transform().getInverse(), rays_, {rowsOutside, count}, rowsInside, found,
                    hits_);
}

class OccludedQuestion::OccludedWalk : public Walk {
 public:
  OccludedWalk(OccludedQuestion& question, const AskedTree& tree, Stream& stream)
      : Walk(question, tree, stream), blocked_(question.blocked_) {}

 private:
  void decide(const Candidate& c) override {
    if (stream_.hasEnded(c.ray)) return;
    LeafPrimitive primitive = primitiveOf(c);
    double t;
    if (isHit(c, primitive, t) && t < stream_.rays->tmax[stream_.rowOf(c.ray)]) stream_.end(c.ray);
  }
  void objectWasAsked(int ray) override {
    if (blocked_[stream_.rowOf(ray)]) stream_.end(ray);
  }

  const bool* blocked_;
};

void OccludedQuestion::walk(const AskedTree& tree, Stream& stream) {
  OccludedWalk walk(*this, tree, stream);
  kernels_.any(stream);
  Walk::resolve(stream);
  stream.markEnded(blocked_);
}

RowList OccludedQuestion::openOf(const RowList& rows) const {
  auto* open = arena_.take<std::uint16_t>(std::size_t(rows.count));
  const auto* end =
      std::copy_if(rows.begin(), rows.end(), open, [&](int row) { return !blocked_[row]; });
  return {open, int(end - open)};
}

void OccludedQuestion::askObject(const Object3D& object, std::uint32_t /*order*/,
                                 const RowList& rows) {
  for (const int row : rows) {
    const double tmin = rays_.tmin[row], tmax = rays_.tmax[row];
    if (object.occluded(rays_.rayOf(row), tmin, tmax)) blocked_[row] = true;
  }
}

void OccludedQuestion::askShapes(const ShapeNumbers* shapes, int count, const RowList& rows) {
  kernels_.occludedByShapes(shapes, count, rays_, rows, blocked_);
}

void OccludedQuestion::askInside(const TreeMember& member, const RowList& rows) {
  const RayTable inside = movedInto(member.transform(), rows);
  bool* found = arena_.take<bool>(std::size_t(rows.count));
  std::fill(found, found + rows.count, false);
  OccludedQuestion within(kernels_, inside, found, arena_);
  askWithin(member, within);
  for (int k = 0; k < rows.count; ++k) {
    if (found[k]) blocked_[rows.rows[k]] = true;
  }
}

CrossingsQuestion::CrossingsQuestion(const Kernels& kernels, const RayTable& rays,
                                     RowCrossingVisitor& visitor, Arena& arena)
    : Question(kernels, rays, arena), visitor_(visitor), endless_(rays) {
  endless_.tmax = arena.take<double>(std::size_t(rays.count));
  std::fill(endless_.tmax, endless_.tmax + rays.count, Hit().getT());
}

class CrossingsQuestion::CrossingsWalk : public Walk {
 public:
  CrossingsWalk(CrossingsQuestion& question, const AskedTree& tree, Stream& stream)
      : Walk(question, tree, stream),
        kernels_(question.kernels_),
        visitor_(question.visitor_),
        proven_(question.arena_.take<LeafHits>(1)),
        crossings_(question.arena_.take<Crossing>(LeafHits::kMost)) {
    proven_->count = 0;
  }

  /// Tells of the crossings with triangles that are surely crossed: several computed at a time took
  /// 0.92 of the instructions of a picture of wine glasses.
  void tellProven() {
    proven_->fillUp();
    kernels_.crossTriangles(*proven_, *stream_.rays, crossings_);
    for (int k = 0; k < proven_->count; ++k) {
      if (crossings_[k].t > 0) visitor_.visit(proven_->rows[k], crossings_[k]);
    }
    proven_->count = 0;
  }

 private:
  void decide(const Candidate& c) override {
    const std::uint32_t* words = stream_.words + c.leaf;
    const int row = stream_.rowOf(c.ray);
    if (stream_.bvh->isInParts && !isNew(row, tree_.primitiveAt(words, c.lane).face)) return;
    Crossing& crossing = crossings_[proven_->count] = tree_.crossingAt(words, c.lane);
    if (kindOf(*words) == LeafKind::spheres) {
      CrossingsOfRow crossings(row, visitor_);
      return crossing.object->visitCrossings(stream_.rays->rayOf(row), crossings);
    }
    if (c.isProven) {
      add(c.leaf, c.lane, row, *proven_);
      if (proven_->count == LeafHits::kMost) tellProven();
      return;
    }
    double numbers[9];
    tree_.getNumbers(words, c.lane, numbers, 1);
    if (triangle::crosses(Vec3d::of(numbers), Vec3d::of(numbers + 3), Vec3d::of(numbers + 6),
                          stream_.rays->rayOf(row), crossing.t, crossing.leaving) &&
        crossing.t > 0) {
      visitor_.visit(row, crossing);
    }
  }

  /// Whether the row's ray has not met the face in another leaf.
  bool isNew(int row, std::uint32_t face) {
    return met_.insert(std::uint64_t(row) << 32 | face).second;
  }

  const Kernels& kernels_;
  RowCrossingVisitor& visitor_;
  LeafHits* proven_;
  Crossing* crossings_;  // of these, but for t and `leaving`
  std::unordered_set<std::uint64_t> met_;
};

void CrossingsQuestion::walk(const AskedTree& tree, Stream& stream) {
  CrossingsWalk walk(*this, tree, stream);
  kernels_.all(stream);
  Walk::resolve(stream);
  walk.tellProven();
}

void CrossingsQuestion::askObject(const Object3D& object, std::uint32_t /*order*/,
                                  const RowList& rows) {
  for (const int row : rows) {
    CrossingsOfRow crossings(row, visitor_);
    object.visitCrossings(rays_.rayOf(row), crossings);
  }
}

void CrossingsQuestion::askShapes(const ShapeNumbers* shapes, int count, const RowList& rows) {
  const Arena::Frame frame(arena_);
  auto* some = arena_.take<std::uint16_t>(std::size_t(rows.count));
  for (int i = 0; i < count; ++i) {
    const int met = kernels_.rowsAtShape(shapes[i], rays_, rows, some);
    askObject(*shapes[i].whole, shapes[i].order, {some, met});
  }
}

void CrossingsQuestion::askInside(const TreeMember& member, const RowList& rows) {
  const RayTable inside = movedInto(member.transform(), rows);
  CrossingsInside found(rows, visitor_);
  CrossingsQuestion within(kernels_, inside, found, arena_);
  askWithin(member, within);
}

}  // namespace accel
