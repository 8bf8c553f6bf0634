// Calls of our compiled scene, one by one or a tile at a time.
#include "our_side.h"

#include <algorithm>

namespace bench {
namespace {

std::size_t nearestOfTile(const CompiledScene& scene, const RaySet& set, std::size_t start,
                          int count) {
  Hit hits[kBatchSize];
  double tmins[kBatchSize];
  std::fill_n(tmins, count, set.tmin);
  scene.intersectBatch(set.rays.data() + start, tmins, count, hits);
  std::size_t found = 0;
  for (int i = 0; i < count; ++i) found += hits[i].getMaterial() != nullptr;
  return found;
}

/// The queries are put together here, as a renderer has to.
std::size_t blockedInTile(const CompiledScene& scene, const RaySet& set, std::size_t start,
                          int count) {
  ShadowQuery queries[kBatchSize];
  bool blocked[kBatchSize];
  for (int i = 0; i < count; ++i) {
    const std::size_t ray = start + std::size_t(i);
    queries[i] = {set.rays[ray], set.tmin, set.tmax[ray]};
  }
  scene.occludedBatch(queries, count, blocked);
  std::size_t found = 0;
  for (int i = 0; i < count; ++i) found += blocked[i];
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

std::size_t traceOurBatches(const CompiledScene& scene, const RaySet& set, std::size_t first,
                            std::size_t end, bool anyHit) {
  std::size_t found = 0;
  for (std::size_t tile = first; tile < end; ++tile) {
    const std::size_t start = set.firstRay[tile];
    const int count = int(set.firstRay[tile + 1] - start);
    if (count == 0) continue;
    found +=
        anyHit ? blockedInTile(scene, set, start, count) : nearestOfTile(scene, set, start, count);
  }
  return found;
}

}  // namespace bench
