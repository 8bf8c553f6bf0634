// Question: what all three kinds have in common, and whether anything is in the way: any candidate
// that is hit between tmin and tmax blocks its ray.
#include "accel/question.h"

#include <algorithm>

#include "accel/question_walk.h"

namespace accel {
namespace {

/// So many rays walk together: 1,024 leave the processor's first cache, 1.06 of the walk's time.
constexpr int kTogether = 512;

}  // namespace

void Question::askTree(const AskedTree& tree, const RowList& rows) {
  if (tree.bvh().isEmpty()) return;
  for (int first = 0; first < rows.count; first += kTogether) {
    askStream(tree, {rows.rows + first, std::min(kTogether, rows.count - first)});
  }
}

void Question::askStream(const AskedTree& tree, const RowList& rows) {
  const Arena::Frame frame(arena_);
  Stream stream(tree.bvh(), tree.inverse(), raysFor(tree), rows, arena_);
  kernels_.prepare(stream);
  if (stream.count == 0) return;
  walk(tree, stream);
  count({stream.nodesVisited, stream.primitivesTested});
}

RowList Question::rowsAt(const BoxNumbers& box, const RowList& rows) const {
  auto* met = arena_.take<std::uint16_t>(std::size_t(rows.count));
  return {met, kernels_.rowsAtBox(box, rays_, rows, met)};
}

/// The depth of recursion is that of the Transforms in the scene, and of trees in trees.
void Question::askMember(const TreeMember& member, const RowList& rows) {
  if (rows.count == 0) return;
  const Arena::Frame frame(arena_);
  switch (member.kind) {
    case TreeMember::Kind::plain:
      return askObject(*member.object, member.order, rows);
    case TreeMember::Kind::shape:
      return askShapes(member.shape, 1, rows);
    case TreeMember::Kind::mesh:
      return askTree(AskedMesh(*member.mesh, member.inverse, *member.meshTree, member.order), rows);
    case TreeMember::Kind::tree:
      return member.inverse ? askInside(member, rows) : member.objectTree->ask(*this, rows);
  }
}

RayTable Question::movedBy(const Matrix& inverse, const RowList& rows) const {
  RayTable inside(arena_, rows.count, rays_.source != nullptr);
  kernels_.moveRays(inverse, rays_, rows, inside);
  for (int k = 0; inside.source && k < rows.count; ++k) {
    inside.source[k] = rays_.source[rows.rows[k]];
    inside.sourceFace[k] = rays_.sourceFace[rows.rows[k]];
  }
  return inside;
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
  const RayTable inside = movedBy(*member.inverse, rows);
  bool* found = arena_.take<bool>(std::size_t(rows.count));
  std::fill(found, found + rows.count, false);
  OccludedQuestion within(kernels_, inside, found, arena_);
  member.objectTree->ask(within, RowList::all(rows.count, arena_));
  for (int k = 0; k < rows.count; ++k) {
    if (found[k]) blocked_[rows.rows[k]] = true;
  }
}

}  // namespace accel
