// Random numbers that are a function of what they are for: no state, so no order to depend on.
#pragma once
#include <cstdint>

namespace math {

/// 64 bits in which every bit of `x` has stirred every other; one to one.
/// Source: the finaliser of SplitMix64, in Steele, Lea and Flood, "Fast Splittable Pseudorandom
/// Number Generators", 2014, with the multipliers of Stafford's "Better Bit Mixing", 2011.
constexpr std::uint64_t mixBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Number `index` of the random sequence that belongs to `seed`: SplitMix64 started there.
constexpr std::uint64_t randomBits(std::uint64_t seed, std::uint64_t index) {
  return mixBits(seed + (index + 1) * 0x9e3779b97f4a7c15u);
}

/// The upper half of `bits` as one of 2^32 evenly spaced numbers from 0 to below 1.
constexpr double unitNumber(std::uint64_t bits) { return double(bits >> 32) * 0x1p-32; }

}  // namespace math
