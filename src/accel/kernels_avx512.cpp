// The traversal kernels for avx512.
// Compiled with flags of its own where the processor may have it; elsewhere never chosen.
#include <cstdint>

#if defined(__SSE2__) || defined(__AVX2__)
#include <immintrin.h>
#endif

#include "accel/packet.h"
#include "accel/traversal.h"
#include "accel/triangle_hits.h"

namespace accel {
namespace avx512 {
#include "accel/kernels.inc"
}  // namespace avx512

const Kernels& avx512Kernels() {
  static const Kernels kernels = {"avx512",
                                  avx512::traverse<Purpose::nearest>,
                                  avx512::traverse<Purpose::any>,
                                  avx512::traverse<Purpose::all>,
                                  avx512::traversePacket<Purpose::nearest>,
                                  avx512::traversePacket<Purpose::any>,
                                  avx512::computeHits,
                                  avx512::prepareRay,
                                  avx512::prepareRays};
  return kernels;
}

}  // namespace accel
