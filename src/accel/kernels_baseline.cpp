// The traversal kernels for baseline.
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>  // all of it: a build may have a wider baseline, e.g. with -march=native
#endif

#include "accel/packet.h"
#include "accel/traversal.h"
#include "accel/triangle_hits.h"

namespace accel {
namespace baseline {
#include "accel/kernels.inc"
}  // namespace baseline

const Kernels& baselineKernels() {
  static const Kernels kernels = {"baseline",
                                  baseline::traverse<Purpose::nearest>,
                                  baseline::traverse<Purpose::any>,
                                  baseline::traverse<Purpose::all>,
                                  baseline::traversePacket<Purpose::nearest>,
                                  baseline::traversePacket<Purpose::any>,
                                  baseline::computeHits,
                                  baseline::prepareRay,
                                  baseline::prepareRays};
  return kernels;
}

}  // namespace accel
