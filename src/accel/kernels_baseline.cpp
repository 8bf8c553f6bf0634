// The traversal kernels for baseline.
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>  // all of it: a build may have a wider baseline, e.g. with -march=native
#endif

#include "accel/stream.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"
#include "math/lanes.h"

namespace accel {
namespace baseline {
#include "accel/kernels.inc"
}  // namespace baseline

Kernels baselineKernels() { return baseline::kernelsNamed("baseline"); }

}  // namespace accel
