// What processes of the benchmark's own measure when it starts itself again.
#pragma once
#include <string>
#include <vector>

#include "accel/compiled_scene.h"

namespace bench {

/// Builds the mesh of about `triangles` triangles, by "ours" or "embree", and prints what is
/// kept, the peak, and the growth of the process, in bytes.
void measureBuildMemory(const std::string& side, double triangles, SimdLevel simd);

/// Reads, builds, traces and writes the scene file and prints the seconds of each.
void measurePhases(const std::string& scene, const std::string& image, int side, SimdLevel simd);

/// Runs what `words` (the arguments behind "_child") ask for.
void runChild(const std::vector<std::string>& words);

}  // namespace bench
