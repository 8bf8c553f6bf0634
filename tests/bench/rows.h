// The rows of the table, one function for each group of them.
#pragma once
#include <string>
#include <vector>

#include "options.h"

namespace bench {

/// Rays per second on every size; thread scaling; cost per ray from 1 M to 10 M triangles.
void runRayRows(const BenchOptions& options);
/// Build time, scaling, and bytes per triangle.
void runBuildRows(const BenchOptions& options);
/// Reading OBJ files, against a pass of memchr.
void runReadRows(const BenchOptions& options);
/// Whole runs of the program on a mesh, a mirror floor and a glass ball.
void runProgramRows(const BenchOptions& options);
/// Whole runs on the mirror-ball scene; seconds tracing of scenes/'s small ones.
void runTinyRows(const BenchOptions& options);
/// Whole runs on meshes that defeat a careless tree, against ordinary meshes of their size.
void runBadMeshRows(const BenchOptions& options);
/// Writing a large PNG file.
void runPngRows(const BenchOptions& options);

}  // namespace bench
