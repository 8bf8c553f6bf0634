// SimdLevel: the instruction sets that a program for one processor family may use.
// What is computed several numbers at a time (math/lanes.h) is compiled once for each of them, and
// chosen when the program runs. All of them give the same bits. The functions are not inline, as
// what is compiled for one of the sets includes this.
#pragma once

/// Which instruction set the kernels use.
enum class SimdLevel { automatic, baseline, avx2, avx512 };

/// The best level that this processor has, at most `wanted` where that is not `automatic`.
SimdLevel availableSimd(SimdLevel wanted);
/// "baseline", "avx2" or "avx512" (for `automatic`, "auto").
const char* nameOf(SimdLevel level);
