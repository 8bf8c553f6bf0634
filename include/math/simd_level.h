// SimdLevel: the instruction sets that a program for one processor family may use.
// What is computed several numbers at a time (math/lanes.h) is compiled once for each of them, and
// chosen when the program runs. All of them give the same bits.
#pragma once
#include <string_view>

/// Which instruction set the kernels use.
enum class SimdLevel { automatic, baseline, avx2, avx512 };
/// Their names, in that order.
inline constexpr std::string_view kSimdNames[] = {"auto", "baseline", "avx2", "avx512"};

/// The best level that this processor has, at most `wanted` where that is not `automatic`. Not
/// inline, as what is compiled for one of the sets includes this.
SimdLevel availableSimd(SimdLevel wanted);
constexpr const char* nameOf(SimdLevel level) { return kSimdNames[int(level)].data(); }
