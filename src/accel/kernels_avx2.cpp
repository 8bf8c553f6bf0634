// The traversal kernels for avx2.
// Compiled with flags of its own where the processor may have it; elsewhere never chosen.
#include <cstdint>

#if defined(__SSE2__) || defined(__AVX2__)
#include <immintrin.h>
#endif

#include "accel/stream.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"
#include "math/lanes.h"

namespace accel {
namespace avx2 {
#include "accel/kernels.inc"
}  // namespace avx2

Kernels avx2Kernels() { return avx2::kernelsNamed("avx2"); }

}  // namespace accel
