// The traversal kernels for baseline.
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>  // all of it: a build may have a wider baseline, e.g. with -march=native
#endif

#include "accel/packet.h"
#include "accel/traversal.h"

namespace accel {
namespace baseline {
#include "accel/kernels.inc"
}  // namespace baseline

Kernels baselineKernels() { return baseline::kernelsNamed("baseline"); }

}  // namespace accel
