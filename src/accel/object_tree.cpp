// ObjectTree: the questions of many rays at once.
//
// What has no box (planes, objects of unknown classes) and what is too few for a tree is asked one
// after the other, in scene order, each for all rays. Then the rays walk the tree as a stream
// (stream.h). Where floats prove that a leaf's triangle or sphere is missed, nothing more happens;
// every other one becomes a Candidate, which the object's own double function decides. An object
// that the kernels do not know is asked when the walk comes to its box, for the rays that meet it.
// A hit lowers the ray's bound, so that farther boxes are passed over.
//
// A member that is a mesh with a tree is asked by mesh_questions.cpp. A Transform takes the rays
// into its inside, a table of their own, by one multiplication each, asks the mesh or the
// ObjectTree there, and takes the hits back out. t means the same on both sides. The depth of
// recursion is that of the Transforms in the scene.
//
// Of equal t the first in the scene wins, whatever the order of the walk: a hit is accepted if it
// is nearer, or as near and earlier in the scene (HitTable::accepts).
#include "accel/object_tree.h"

#include <algorithm>

namespace accel {
namespace {

/// The listed rays as they are inside of a Transform, one row for each.
RayTable movedRays(const Kernels& kernels, const Transform& transform, const RayTable& rays,
                   const RowList& list, Arena& arena) {
  RayTable inside(arena, list.count, rays.source != nullptr);
  kernels.moveRays(transform.getInverse(), rays, list, inside);
  for (int k = 0; inside.source && k < list.count; ++k) {
    inside.source[k] = rays.source[list.rows[k]];
    inside.sourceFace[k] = rays.sourceFace[list.rows[k]];
  }
  return inside;
}

/// Asks `ask(rays, list, hits)` inside of a Transform, and takes what is found back out.
template <class Ask>
void nearestInside(const Kernels& kernels, const Transform& transform, const RayTable& rays,
                   const RowList& list, HitTable& hits, Arena& arena, const Ask& ask) {
  const RayTable inside = movedRays(kernels, transform, rays, list, arena);
  HitTable found(arena, list.count);
  for (int k = 0; k < list.count; ++k) found.order[k] = hits.order[list.rows[k]];
  ask(inside, RowList::all(list.count, arena), found);
  auto* rowsInside = arena.take<std::uint16_t>(std::size_t(list.count));
  auto* rows = arena.take<std::uint16_t>(std::size_t(list.count));
  int count = 0;
  for (int k = 0; k < list.count; ++k) {
    const int row = list.rows[k];
    if (found.order[k] == hits.order[row]) continue;
    rays.tmax[row] = inside.tmax[k];
    hits.material[row] = found.material[k];
    hits.object[row] = found.object[k];
    hits.face[row] = found.face[k];
    hits.order[row] = found.order[k];
    rowsInside[count] = std::uint16_t(k);
    rows[count++] = std::uint16_t(row);
  }
  kernels.moveHits(transform.getInverse(), rays, {rows, count}, rowsInside, found, hits);
}

/// Asks `ask(rays, list, blocked)` inside of a Transform.
template <class Ask>
void occludedInside(const Kernels& kernels, const Transform& transform, const RayTable& rays,
                    const RowList& list, bool* blocked, Arena& arena, const Ask& ask) {
  const RayTable inside = movedRays(kernels, transform, rays, list, arena);
  bool* found = arena.take<bool>(std::size_t(list.count));
  std::fill(found, found + list.count, false);
  ask(inside, RowList::all(list.count, arena), found);
  for (int k = 0; k < list.count; ++k) {
    if (found[k]) blocked[list.rows[k]] = true;
  }
}

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

/// The object's own answer for each ray.
void nearestOfPlain(const TreeMember& member, const RayTable& rays, const RowList& list,
                    HitTable& hits) {
  for (const int row : list) {
    const NearestSoFar best{rays.tmax[row], hits.order[row]};
    // What comes later in the scene has to be nearer.
    Hit hit(best.order < member.order ? best.t : best.inclusiveBound());
    if (!member.object->intersect(rays.rayOf(row), hit, rays.tmin[row])) continue;
    if (!best.accepts(hit.getT(), member.order)) continue;
    rays.tmax[row] = hit.getT();
    hits.setRow(row, hit, member.order);
  }
}

/// Those of the list that are not blocked.
RowList openRows(const RowList& list, const bool* blocked, Arena& arena) {
  auto* rows = arena.take<std::uint16_t>(std::size_t(list.count));
  const auto* end =
      std::copy_if(list.begin(), list.end(), rows, [&](int row) { return !blocked[row]; });
  return {rows, int(end - rows)};
}

/// The rays of one stream, asking one tree.
struct TreeQuestion {
  const ObjectTree& tree;
  Arena& arena;

  const TreeMember& memberOf(const Stream& stream, const Candidate& c) const {
    const std::uint32_t* words = stream.words + c.leaf;
    const int n = countOf(*words);
    return tree.member(words[1 + rowsOf(kindOf(*words)) * n + c.lane] & ~kIdBit);
  }
  /// The rows of some rays of the stream.
  RowList tableRows(const Stream& stream, const std::uint16_t* list, int count) const {
    auto* rows = arena.take<std::uint16_t>(std::size_t(count));
    std::transform(list, list + count, rows,
                   [&](int ray) { return std::uint16_t(stream.rowOf(ray)); });
    return {rows, count};
  }
};

struct NearestInTree : TreeQuestion {
  HitTable& hits;

  static void resolve(Stream& stream) {
    const auto& self = *static_cast<const NearestInTree*>(stream.context);
    for (int k = 0; k < stream.candidateCount; ++k) {
      const Candidate& c = stream.candidates[k];
      if (c.tLow > stream.boxRays[c.ray].tmaxUp) continue;
      self.ask(stream, self.memberOf(stream, c), &c.ray, 1);
    }
    stream.candidateCount = 0;
  }
  static void askObject(Stream& stream, std::uint32_t id, const std::uint16_t* list, int count) {
    const auto& self = *static_cast<const NearestInTree*>(stream.context);
    self.ask(stream, self.tree.member(id), list, count);
  }
  void ask(Stream& stream, const TreeMember& member, const std::uint16_t* list, int count) const {
    const Arena::Frame frame(arena);
    tree.nearestOf(member, *stream.rays, tableRows(stream, list, count), hits, arena);
    for (int k = 0; k < count; ++k) {
      stream.lowerBound(list[k], stream.rays->tmax[stream.rowOf(list[k])]);
    }
  }
};

struct OccludedInTree : TreeQuestion {
  bool* blocked;

  static void resolve(Stream& stream) {
    const auto& self = *static_cast<const OccludedInTree*>(stream.context);
    for (int k = 0; k < stream.candidateCount; ++k) {
      const Candidate& c = stream.candidates[k];
      if (!stream.hasEnded(c.ray)) self.ask(stream, self.memberOf(stream, c), &c.ray, 1);
    }
    stream.candidateCount = 0;
  }
  static void askObject(Stream& stream, std::uint32_t id, const std::uint16_t* list, int count) {
    const auto& self = *static_cast<const OccludedInTree*>(stream.context);
    self.ask(stream, self.tree.member(id), list, count);
  }
  void ask(Stream& stream, const TreeMember& member, const std::uint16_t* list, int count) const {
    const Arena::Frame frame(arena);
    const RowList open = openRows(tableRows(stream, list, count), blocked, arena);
    tree.occludedBy(member, *stream.rays, open, blocked, arena);
    for (int k = 0; k < count; ++k) {
      if (blocked[stream.rowOf(list[k])]) stream.end(list[k]);
    }
  }
};

struct CrossingsInTree : TreeQuestion {
  RowCrossingVisitor& visitor;

  static void resolve(Stream& stream) {
    const auto& self = *static_cast<const CrossingsInTree*>(stream.context);
    for (int k = 0; k < stream.candidateCount; ++k) {
      const Candidate& c = stream.candidates[k];
      self.ask(stream, self.memberOf(stream, c), &c.ray, 1);
    }
    stream.candidateCount = 0;
  }
  static void askObject(Stream& stream, std::uint32_t id, const std::uint16_t* list, int count) {
    const auto& self = *static_cast<const CrossingsInTree*>(stream.context);
    self.ask(stream, self.tree.member(id), list, count);
  }
  void ask(const Stream& stream, const TreeMember& member, const std::uint16_t* list,
           int count) const {
    const Arena::Frame frame(arena);
    tree.visitCrossingsOf(member, *stream.rays, tableRows(stream, list, count), visitor, arena);
  }
};

template <class Question>
void attach(Question& question, Stream& stream) {
  stream.resolve = Question::resolve;
  stream.askObject = Question::askObject;
  stream.context = &question;
}

}  // namespace

void ObjectTree::nearestOf(const TreeMember& member, const RayTable& rays, const RowList& list,
                           HitTable& hits, Arena& arena) const {
  const Arena::Frame frame(arena);
  switch (member.kind) {
    case TreeMember::Kind::mesh:
      return nearestInMesh(*kernels_, member.meshInScene(), rays, list, hits, arena);
    case TreeMember::Kind::transformedMesh:
      return nearestInside(*kernels_, member.transform(), rays, list, hits, arena,
                           [&](const RayTable& inside, const RowList& all, HitTable& found) {
                             nearestInMesh(*kernels_, member.meshInScene(), inside, all, found,
                                           arena);
                           });
    case TreeMember::Kind::transformedTree:
      return nearestInside(*kernels_, member.transform(), rays, list, hits, arena,
                           [&](const RayTable& inside, const RowList& all, HitTable& found) {
                             member.objectTree->nearest(inside, all, found, arena);
                           });
    case TreeMember::Kind::plain:
      return nearestOfPlain(member, rays, list, hits);
  }
}

void ObjectTree::occludedBy(const TreeMember& member, const RayTable& rays, const RowList& list,
                            bool* blocked, Arena& arena) const {
  const Arena::Frame frame(arena);
  switch (member.kind) {
    case TreeMember::Kind::mesh:
      return occludedByMesh(*kernels_, member.meshInScene(), rays, list, blocked, arena);
    case TreeMember::Kind::transformedMesh:
      return occludedInside(*kernels_, member.transform(), rays, list, blocked, arena,
                            [&](const RayTable& inside, const RowList& all, bool* found) {
                              occludedByMesh(*kernels_, member.meshInScene(), inside, all, found,
                                             arena);
                            });
    case TreeMember::Kind::transformedTree:
      return occludedInside(*kernels_, member.transform(), rays, list, blocked, arena,
                            [&](const RayTable& inside, const RowList& all, bool* found) {
                              member.objectTree->occluded(inside, all, found, arena);
                            });
    case TreeMember::Kind::plain:
      for (const int row : list) {
        const double tmin = rays.tmin[row], tmax = rays.tmax[row];
        if (member.object->occluded(rays.rayOf(row), tmin, tmax)) blocked[row] = true;
      }
  }
}

void ObjectTree::visitCrossingsOf(const TreeMember& member, const RayTable& rays,
                                  const RowList& list, RowCrossingVisitor& visitor,
                                  Arena& arena) const {
  const Arena::Frame frame(arena);
  if (member.kind == TreeMember::Kind::mesh) {
    return visitMeshCrossings(*kernels_, member.meshInScene(), rays, list, visitor, arena);
  }
  if (member.kind == TreeMember::Kind::plain) {
    for (const int row : list) {
      CrossingsOfRow crossings(row, visitor);
      member.object->visitCrossings(rays.rayOf(row), crossings);
    }
    return;
  }
  const RayTable inside = movedRays(*kernels_, member.transform(), rays, list, arena);
  const RowList all = RowList::all(list.count, arena);
  CrossingsInside found(list, visitor);
  if (member.kind == TreeMember::Kind::transformedMesh) {
    visitMeshCrossings(*kernels_, member.meshInScene(), inside, all, found, arena);
  } else {
    member.objectTree->visitCrossings(inside, all, found, arena);
  }
}

/// The shapes, all for several rays at once; then the hits of each.
void ObjectTree::nearestShapes(const RayTable& rays, const RowList& list, HitTable& hits,
                               Arena& arena) const {
  const Arena::Frame frame(arena);
  auto* winners = arena.take<std::uint16_t>(std::size_t(list.count));
  kernels_->nearestOfShapes(shapes_.data(), int(shapes_.size()), rays, list, winners);
  auto* rows = arena.take<std::uint16_t>(std::size_t(list.count));
  for (std::size_t id = 0; id < shapes_.size(); ++id) {
    const ShapeNumbers& shape = shapes_[id];
    int count = 0;
    for (int k = 0; k < list.count; ++k) {
      if (winners[k] != id + 1) continue;
      const int row = list.rows[k];
      hits.material[row] = shape.material;
      hits.object[row] = shape.object;
      hits.face[row] = 0;
      hits.order[row] = shape.order;
      rows[count++] = std::uint16_t(row);
    }
    kernels_->hitsOfShape(shape, rays, {rows, count}, hits);
  }
}

void ObjectTree::nearest(const RayTable& rays, const RowList& list, HitTable& hits,
                         Arena& arena) const {
  const Arena::Frame frame(arena);
  if (!shapes_.empty()) {
    if (kernels_->tally) kernels_->tally->addNearest({0, shapes_.size() * std::size_t(list.count)});
    // What another object has been hit at may be as near as a shape that comes before it in the
    // scene: such rays are asked one by one.
    auto* fresh = arena.take<std::uint16_t>(std::size_t(list.count));
    auto* others = arena.take<std::uint16_t>(std::size_t(list.count));
    int freshCount = 0, otherCount = 0;
    for (const int row : list) {
      (hits.isFound(row) ? others[otherCount++] : fresh[freshCount++]) = std::uint16_t(row);
    }
    nearestShapes(rays, {fresh, freshCount}, hits, arena);
    for (const ShapeNumbers& shape : shapes_) {
      nearestOfPlain({shape.object, {}, shape.order, TreeMember::Kind::plain}, rays,
                     {others, otherCount}, hits);
    }
  }
  for (const std::uint32_t id : direct_) {
    countPlain(&TestTally::addNearest, members_[id], list.count);
    nearestOf(members_[id], rays, list, hits, arena);
  }
  if (bvh_.isEmpty()) return;
  Stream stream(bvh_, rays, list, arena);
  kernels_->prepare(stream);
  NearestInTree question{{*this, arena}, hits};
  attach(question, stream);
  kernels_->nearest(stream);
  kernels_->countNearest(stream);
  NearestInTree::resolve(stream);
}

void ObjectTree::occluded(const RayTable& rays, const RowList& list, bool* blocked,
                          Arena& arena) const {
  const Arena::Frame frame(arena);
  RowList open = list;
  if (!shapes_.empty()) {
    if (kernels_->tally) kernels_->tally->addShadow({0, shapes_.size() * std::size_t(list.count)});
    kernels_->occludedByShapes(shapes_.data(), int(shapes_.size()), rays, list, blocked);
    open = openRows(open, blocked, arena);
  }
  for (const std::uint32_t id : direct_) {
    countPlain(&TestTally::addShadow, members_[id], open.count);
    occludedBy(members_[id], rays, open, blocked, arena);
    open = openRows(open, blocked, arena);
  }
  if (bvh_.isEmpty() || open.count == 0) return;
  Stream stream(bvh_, rays, open, arena);
  kernels_->prepare(stream);
  OccludedInTree question{{*this, arena}, blocked};
  attach(question, stream);
  kernels_->any(stream);
  kernels_->countShadow(stream);
  OccludedInTree::resolve(stream);
  stream.markEnded(blocked);
}

void ObjectTree::visitCrossings(const RayTable& rays, const RowList& list,
                                RowCrossingVisitor& visitor, Arena& arena) const {
  for (const ShapeNumbers& shape : shapes_) {
    const TreeMember member = {shape.object, {}, shape.order, TreeMember::Kind::plain};
    countPlain(&TestTally::addShadow, member, list.count);
    visitCrossingsOf(member, rays, list, visitor, arena);
  }
  for (const std::uint32_t id : direct_) {
    countPlain(&TestTally::addShadow, members_[id], list.count);
    visitCrossingsOf(members_[id], rays, list, visitor, arena);
  }
  if (bvh_.isEmpty()) return;
  const Arena::Frame frame(arena);
  Stream stream(bvh_, rays, list, arena);
  kernels_->prepare(stream);
  CrossingsInTree question{{*this, arena}, visitor};
  attach(question, stream);
  kernels_->all(stream);
  kernels_->countShadow(stream);
  CrossingsInTree::resolve(stream);
}

}  // namespace accel
