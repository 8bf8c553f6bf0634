// Powers of ten in 128 bits: integers times powers of ten, rounded to the nearest double.
#pragma once
#include <cstdint>

namespace powers_of_ten {

/// Stores the double nearest to mantissa * 10^exponent, ties to even, and returns true; false where
/// 128 bits cannot tell (ties and what lies within 2^-64 of one, exponents beyond 55 either way).
/// mantissa > 0.
bool nearest(std::uint64_t mantissa, std::int64_t exponent, double& value);

}  // namespace powers_of_ten
