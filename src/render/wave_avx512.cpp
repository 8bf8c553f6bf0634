// The kernels of a wave for avx512.
// Compiled with flags of its own where the processor may have it; elsewhere never chosen.
#include "math/lanes.h"
#include "render/wave_kernels.h"
#include "shading/light.h"
#include "shading/optics.h"
#include "shading/phong_material.h"

namespace avx512 {
#include "render/wave_kernels.inc"
}  // namespace avx512

WaveKernels avx512WaveKernels() { return avx512::waveKernels(); }
