// The kernels of a wave for baseline.
#include "math/lanes.h"
#include "render/wave_kernels.h"
#include "shading/light.h"
#include "shading/optics.h"
#include "shading/phong_material.h"

namespace baseline {
#include "render/wave_kernels.inc"
}  // namespace baseline

WaveKernels baselineWaveKernels() { return baseline::waveKernels(); }
