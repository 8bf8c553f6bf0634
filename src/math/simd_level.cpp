// SimdLevel: what the processor says that it has. (Not in the header: what sources for one
// instruction set compile may be what all others then call.)
#include "math/simd_level.h"

SimdLevel availableSimd(SimdLevel wanted) {
  SimdLevel best = SimdLevel::baseline;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2")) {
    best = SimdLevel::avx2;
  }
  if (best == SimdLevel::avx2 && __builtin_cpu_supports("avx512f") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw")) {
    best = SimdLevel::avx512;
  }
#endif
  return wanted == SimdLevel::automatic || wanted > best ? best : wanted;
}
