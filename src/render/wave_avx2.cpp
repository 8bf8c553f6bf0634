// The kernels of a wave for avx2.
// Compiled with flags of its own where the processor may have it; elsewhere never chosen.
#include "math/lanes.h"
#include "render/wave_kernels.h"
#include "shading/light.h"
#include "shading/optics.h"
#include "shading/phong_material.h"

namespace avx2 {
#include "render/wave_kernels.inc"
}  // namespace avx2

WaveKernels avx2WaveKernels() { return avx2::waveKernels(); }
