// ObjectTree: the questions of many rays at once.
//
// What has no box (planes, objects of unknown classes) and what is too few for a tree is asked one
// after the other, in scene order, each for all rays. Then the rays walk the tree as a stream
// (stream.h). Where floats prove that a leaf's triangle or sphere is missed, nothing more happens;
// every other one becomes a Candidate, which the object's own double function decides. An object
// that the kernels do not know is asked when the walk comes to its box, for the rays that meet it.
// A hit lowers the ray's bound, so that farther boxes are passed over.
//
// How one member is asked stands in member_questions.cpp.
//
// Of equal t the first in the scene wins, whatever the order of the walk: a hit is accepted if it
// is nearer, or as near and earlier in the scene (HitTable::accepts).
#include "accel/object_tree.h"

#include <algorithm>

namespace accel {
namespace {

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

}  // namespace

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
      nearestOf({shape.object, {}, shape.order, TreeMember::Kind::plain}, rays,
                {others, otherCount}, hits, arena);
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
  stream.attach(question);
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
  stream.attach(question);
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
  stream.attach(question);
  kernels_->all(stream);
  kernels_->countShadow(stream);
  CrossingsInTree::resolve(stream);
}

}  // namespace accel
