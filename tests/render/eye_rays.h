// Eye rays as the table that a WaveTracer takes.
#pragma once
#include <limits>
#include <vector>

#include "render/wave_tables.h"

namespace eye_rays {

/// Each has the weight of a whole pixel and sees all that is before the eye.
inline WaveRays tableOf(const std::vector<Ray>& rays, Arena& arena) {
  WaveRays table(arena, int(rays.size()), false);
  table.count = int(rays.size());
  for (int i = 0; i < table.count; ++i) {
    table.setRow(i, rays[std::size_t(i)], 0, std::numeric_limits<double>::infinity());
    table.weight[i] = 1;
  }
  return table;
}

}  // namespace eye_rays
