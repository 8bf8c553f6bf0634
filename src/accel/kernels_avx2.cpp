// The traversal kernels for avx2.
// Compiled with flags of its own where the processor may have it; elsewhere never chosen.
#include <cstdint>

#if defined(__SSE2__) || defined(__AVX2__)
#include <immintrin.h>
#endif

#include "accel/packet.h"
#include "accel/traversal.h"
#include "accel/triangle_hits.h"

namespace accel {
namespace avx2 {
#include "accel/kernels.inc"
}  // namespace avx2

const Kernels& avx2Kernels() {
  static const Kernels kernels = {"avx2",
                                  avx2::traverse<Purpose::nearest>,
                                  avx2::traverse<Purpose::any>,
                                  avx2::traverse<Purpose::all>,
                                  avx2::traversePacket<Purpose::nearest>,
                                  avx2::traversePacket<Purpose::any>,
                                  avx2::computeHits,
                                  avx2::prepareRay,
                                  avx2::prepareRays};
  return kernels;
}

}  // namespace accel
