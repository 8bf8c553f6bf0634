// Stream: its memory, and ray parameters rounded outwards.
#include "accel/stream.h"

#include <algorithm>
#include <limits>

namespace accel {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

Stream::Stream(const WideBvh& tree, const Matrix* moves, const RayTable& table, const RowList& rows,
               Arena& arena)
    : bvh(&tree),
      nodes(tree.root()),
      words(tree.words()),
      rays(&table),
      list(rows),
      inverse(moves),
      count(0),
      octantCount{},
      outsideEnd(0),
      candidateCount(0),
      nodesVisited(0),
      primitivesTested(0),
      resolve(nullptr),
      askObject(nullptr),
      context(nullptr) {
  const auto most = std::size_t(rows.count);
  // One more, which takes what is computed for nothing.
  boxRays = arena.take<BoxRay>(most + 1);
  primitiveRays = arena.take<PrimitiveRay>(most + 1);
  maps = arena.take<ParameterMap>(most + 1);
  // To add to a list, and to read it, runs over its end by less than eight.
  octantRoom = std::uint32_t(most) + 8;
  // A visited node, or frame, leaves at most seven entries behind, besides the one that is visited
  // next; each of its boxes may have a list of its own, at most as long as that of the node.
  const auto levels = std::size_t(tree.levels);
  stack = arena.take<StreamEntry>(levels * (kWidth - 1) + 2);
  pool = arena.take<std::uint16_t>(8 * octantRoom + levels * kWidth * most + 16);
  masks = arena.take<std::uint8_t>(most + 16);
  outside = arena.take<OutsideRay>(std::size_t(tree.frameLevels) * most);
  candidates = arena.take<Candidate>(kMostCandidates);
}

void Stream::leaveFrame(const std::uint16_t* inside, int size) {
  outsideEnd -= size;
  for (int k = 0; k < size; ++k) {
    const OutsideRay& before = outside[outsideEnd + k];
    const int ray = inside[k];
    const bool ended = hasEnded(ray);
    boxRays[ray] = before.box;
    primitiveRays[ray] = before.primitive;
    maps[ray] = before.map;
    lowerBound(ray, rays->tmax[rowOf(ray)]);
    if (ended) end(ray);
  }
}

void Stream::lowerBound(int ray, double t) {
  // In the plane of a triangle its double function may give any t, even one before the tree; then
  // others at the same t must not drop out.
  double below, above;
  boundsOf(t, maps[ray].scale, maps[ray].shift, below, above);
  boxRays[ray].tmaxUp = std::min(boxRays[ray].tmaxUp, std::max(float(above), 0.0f));
  primitiveRays[ray].tmaxDown = std::min(primitiveRays[ray].tmaxDown, float(below));
}

void Stream::end(int ray) { boxRays[ray].tmaxUp = -kInfinity; }

void Stream::markEnded(bool* blocked) const {
  for (int ray = 0; ray < count; ++ray) {
    if (hasEnded(ray)) blocked[rowOf(ray)] = true;
  }
}

void LeafHits::fillUp() {
  for (int k = count; k % 8 != 0; ++k) {
    rows[k] = rows[count - 1];
    for (auto& row : numbers) row[k] = row[count - 1];
  }
}

}  // namespace accel
