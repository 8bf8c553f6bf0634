// Calls of our compiled scene, one by one or a tile at a time.
#include "our_side.h"

#include <limits>

namespace bench {
namespace {

/// The rays of a tile as a table, put together here, as a renderer has to.
RayTable tableOf(const RaySet& set, std::size_t start, int count, bool anyHit, Arena& arena) {
  RayTable rays(arena, count, false);
  for (int i = 0; i < count; ++i) {
    const std::size_t ray = start + std::size_t(i);
    rays.setRow(i, set.rays[ray], set.tmin,
                anyHit ? set.tmax[ray] : std::numeric_limits<double>::infinity());
  }
  return rays;
}

std::size_t nearestOfTile(const CompiledScene& scene, const RayTable& rays, Arena& arena) {
  HitTable hits(arena, rays.count);
  scene.intersectAll(rays, hits, arena);
  std::size_t found = 0;
  for (int i = 0; i < rays.count; ++i) found += hits.isFound(i);
  return found;
}

std::size_t blockedInTile(const CompiledScene& scene, const RayTable& rays, Arena& arena) {
  bool* const blocked = arena.take<bool>(std::size_t(rays.count));
  scene.occludedAll(rays, blocked, arena);
  std::size_t found = 0;
  for (int i = 0; i < rays.count; ++i) found += blocked[i];
  return found;
}

}  // namespace

std::size_t traceOurSingle(const CompiledScene& scene, const RaySet& set, std::size_t first,
                           std::size_t end, bool anyHit) {
  std::size_t hits = 0;
  for (std::size_t i = set.firstRay[first]; i < set.firstRay[end]; ++i) {
    if (anyHit) {
      hits += scene.occluded(set.rays[i], set.tmin, set.tmax[i]);
    } else {
      Hit hit;
      hits += scene.intersect(set.rays[i], hit, set.tmin);
    }
  }
  return hits;
}

std::size_t traceOurStreams(const CompiledScene& scene, const RaySet& set, std::size_t first,
                            std::size_t end, bool anyHit) {
  thread_local Arena arena;  // a renderer keeps its own as long
  std::size_t found = 0;
  for (std::size_t tile = first; tile < end; ++tile) {
    const std::size_t start = set.firstRay[tile];
    const int count = int(set.firstRay[tile + 1] - start);
    if (count == 0) continue;
    const Arena::Frame frame(arena);
    const RayTable rays = tableOf(set, start, count, anyHit, arena);
    found += anyHit ? blockedInTile(scene, rays, arena) : nearestOfTile(scene, rays, arena);
  }
  return found;
}

}  // namespace bench
