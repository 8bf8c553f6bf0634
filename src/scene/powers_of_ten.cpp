// Rounding m * 10^e: the product of m with the first 128 bits of 5^e nearly always tells the
// nearest double. Source: Lemire, "Number Parsing at a Gigabyte per Second", 2021, section 5; here
// with a plain error bound in place of its case analysis.
#include "scene/powers_of_ten.h"

#include <array>
#include <cstring>

namespace powers_of_ten {
namespace {

struct Bits128 {
  std::uint64_t high, low;
};

/// `bits`, of which the highest is set, times 2^exponent: at most the power meant, and less than
/// one unit of `bits` below it.
struct Power {
  Bits128 bits;
  int exponent;
};

constexpr int kLargest = 55;  // 5^55 is the last power of five below 2^128

constexpr Bits128 doubled(Bits128 a) { return {a.high << 1 | a.low >> 63, a.low << 1}; }
constexpr bool isLess(Bits128 a, Bits128 b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
constexpr Bits128 minus(Bits128 a, Bits128 b) {
  return {a.high - b.high - (a.low < b.low), a.low - b.low};
}
constexpr Bits128 timesFive(Bits128 a) {
  const Bits128 four = doubled(doubled(a));
  const std::uint64_t low = four.low + a.low;
  return {four.high + a.high + (low < a.low), low};
}

constexpr Power normalized(Bits128 bits) {
  Power power{bits, 0};
  for (; power.bits.high >> 63 == 0; --power.exponent) power.bits = doubled(power.bits);
  return power;
}

/// 1 / power.bits as a Power, by long division, bit by bit. The first bit of the quotient is that
/// of 2^128 / bits, which is 1 as bits > 2^127, unless bits = 2^127 exactly, which is no divisor
/// here.
constexpr Power inverse(const Power& power) {
  const Bits128 divisor = power.bits;
  Bits128 quotient{0, 1};
  Bits128 rest = minus({0, 0}, divisor);  // 2^128 - divisor, below divisor
  for (int i = 0; i < 127; ++i) {
    const bool isCarried = rest.high >> 63 != 0;
    rest = doubled(rest);
    quotient = doubled(quotient);
    if (!isCarried && isLess(rest, divisor)) continue;
    rest = minus(rest, divisor);
    quotient.low |= 1;
  }
  return {quotient, -power.exponent - 255};
}

/// Powers of five from -kLargest to kLargest.
constexpr std::array<Power, 2 * kLargest + 1> makePowers() {
  std::array<Power, 2 * kLargest + 1> powers{};
  Bits128 five{0, 1};
  for (int i = 0; i <= kLargest; ++i, five = timesFive(five)) {
    powers[std::size_t(kLargest + i)] = normalized(five);
    if (i > 0) powers[std::size_t(kLargest - i)] = inverse(normalized(five));
  }
  return powers;
}
constexpr std::array<Power, 2 * kLargest + 1> kPowersOfFive = makePowers();

/// The whole product of two 64-bit numbers, by halves.
Bits128 product(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kHalf = 0xffffffff;
  const std::uint64_t low = (a & kHalf) * (b & kHalf);
  const std::uint64_t first = (a >> 32) * (b & kHalf) + (low >> 32);
  const std::uint64_t second = (a & kHalf) * (b >> 32) + (first & kHalf);
  return {(a >> 32) * (b >> 32) + (first >> 32) + (second >> 32), second << 32 | (low & kHalf)};
}

/// The upper 128 bits of a * b, which lie less than one unit below the product's.
Bits128 upperProduct(std::uint64_t a, Bits128 b) {
  const Bits128 upper = product(a, b.high);
  const std::uint64_t carried = product(a, b.low).high;
  const std::uint64_t low = upper.low + carried;
  return {upper.high + (low < carried), low};
}

/// 2^exponent for the exponents of normal doubles.
double powerOfTwo(int exponent) {
  const std::uint64_t bits = std::uint64_t(exponent + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

}  // namespace

bool nearest(std::uint64_t mantissa, std::int64_t exponent, double& value) {
  if (exponent < -kLargest || exponent > kLargest) return false;
  const Power& power = kPowersOfFive[std::size_t(exponent + kLargest)];
  const int shift = __builtin_clzll(mantissa);
  Bits128 bits = upperProduct(mantissa << shift, power.bits);
  int binary = power.exponent + int(exponent) + 64 - shift;
  if (bits.high >> 63 == 0) {
    bits = doubled(bits);
    --binary;
  }
  // The number lies in [bits, bits + 4) * 2^binary: 2 for the power's error and the part of the
  // product left out, both doubled. Of bits.high, 53 bits stay and 11 and all of bits.low go.
  constexpr std::uint64_t kRest = (1 << 11) - 1, kHalf = 1 << 10;
  const std::uint64_t rest = bits.high & kRest;
  const bool isUnclear =
      (rest == kHalf && bits.low == 0) || (rest == kHalf - 1 && bits.low >= ~std::uint64_t(0) - 3);
  if (isUnclear) return false;
  const std::uint64_t kept = (bits.high >> 11) + (rest >= kHalf);
  value = double(kept) * powerOfTwo(binary + 64 + 11);
  return true;
}

}  // namespace powers_of_ten
