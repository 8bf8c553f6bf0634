// The traversal kernels for baseline.
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "accel/traversal.h"

namespace accel {
namespace baseline {
#include "accel/simd.h"

#include "accel/kernels.inc"
}  // namespace baseline

const Kernels& baselineKernels() {
  static const Kernels kernels = {"baseline", baseline::traverse<Purpose::nearest>,
                                  baseline::traverse<Purpose::any>,
                                  baseline::traverse<Purpose::all>};
  return kernels;
}

}  // namespace accel
