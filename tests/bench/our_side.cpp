// Calls of our compiled scene, one by one or a tile at a time.
#include "our_side.h"

namespace bench {
namespace {

void nearestOfTile(const CompiledScene& scene, const Ray* rays, int count, double tmin, Hit* hits) {
  for (int i = 0; i < count; ++i) scene.intersect(rays[i], hits[i], tmin);
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
  if (anyHit) return traceOurSingle(scene, set, first, end, anyHit);
  std::size_t found = 0;
  for (std::size_t tile = first; tile < end; ++tile) {
    const std::size_t start = set.firstRay[tile];
    const int count = int(set.firstRay[tile + 1] - start);
    Hit hits[256];
    nearestOfTile(scene, set.rays.data() + start, count, set.tmin, hits);
    for (int i = 0; i < count; ++i) found += hits[i].getMaterial() != nullptr;
  }
  return found;
}

}  // namespace bench
