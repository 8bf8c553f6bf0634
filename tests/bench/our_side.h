// Our side of the ray rows: what a renderer gets, a Hit with t, material, normal and point.
#pragma once
#include <cstddef>

#include "accel/compiled_scene.h"
#include "ray_set.h"

namespace bench {

/// Traces the rays of tiles `first` .. end - 1 one call each, for the nearest hit or for any, and
/// returns how many hit.
std::size_t traceOurSingle(const CompiledScene& scene, const RaySet& set, std::size_t first,
                           std::size_t end, bool anyHit);

/// The same, all rays of a tile in one call.
std::size_t traceOurStreams(const CompiledScene& scene, const RaySet& set, std::size_t first,
                            std::size_t end, bool anyHit);

}  // namespace bench
