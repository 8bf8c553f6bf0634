// ObjectTree: the questions of many rays to one member.
//
// A mesh with a tree is asked by mesh_questions.cpp. A Transform takes the rays into its inside, a
// table of their own, by one multiplication each, asks the mesh or the ObjectTree there, and takes
// the hits back out. t means the same on both sides. The depth of recursion is that of the
// Transforms in the scene. Everything else answers ray by ray through its own functions.
#include <algorithm>

#include "accel/object_tree.h"

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

}  // namespace accel
