// Random numbers without a state.
#include "check.h"
#include "math/functions.h"

TEST("the sequence that starts at 0 is the published one of SplitMix64") {
  // The first outputs of the authors' own program (Vigna, splitmix64.c, 2015) for the state 0.
  CHECK_EQUAL(math::randomBits(0, 0), 0xe220a8397b1dcdafu);
  CHECK_EQUAL(math::randomBits(0, 1), 0x6e789e6aa1b965f4u);
  CHECK_EQUAL(math::randomBits(0, 2), 0x06c45d188009454fu);
}

TEST("unit numbers are at least 0 and below 1") {
  CHECK_EQUAL(math::unitNumber(0), 0.0);
  CHECK_EQUAL(math::unitNumber(~std::uint64_t{0}), 1 - 0x1p-32);
  CHECK_EQUAL(math::unitNumber(std::uint64_t{1} << 63), 0.5);
}

TEST("one bit of the argument changes about half of the bits") {
  // 64 x 64 bits, each of which flips with probability 1/2: 2048 with a standard deviation of 32.
  int flipped = 0;
  for (int bit = 0; bit < 64; ++bit) {
    std::uint64_t change = math::mixBits(0x123456789abcdefu) ^
                           math::mixBits(0x123456789abcdefu ^ std::uint64_t{1} << bit);
    for (; change != 0; change &= change - 1) ++flipped;
  }
  CHECK_NEAR(flipped, 2048, 160);
}

TEST("the sequence of drand48 begun at 0 has the numbers that counting gives") {
  // Worked out with whole numbers: 11, then 11 (0x5DEECE66D + 1), then on by the rule itself.
  CHECK_EQUAL(math::sequenceNumber(0), 11 * 0x1p-48);
  CHECK_EQUAL(math::sequenceNumber(1), 277363943098.0 * 0x1p-48);
  std::uint64_t x = 0;
  for (std::uint64_t index = 0; index < 1000; ++index) {
    x = (0x5DEECE66Du * x + 0xB) % (std::uint64_t{1} << 48);
    CHECK_EQUAL(math::sequenceNumber(index), double(x) * 0x1p-48);
  }
}

TEST("a jump in the sequence of drand48 is as far as two jumps") {
  // From number n the sequence goes on by the rule, wherever n lies; it comes back after 2^48.
  for (const std::uint64_t n : {std::uint64_t{1} << 20, (std::uint64_t{1} << 46) + 12345,
                                (std::uint64_t{1} << 48) - 1, (std::uint64_t{1} << 48) + 7}) {
    const auto x = std::uint64_t(math::sequenceNumber(n) * 0x1p48);
    const std::uint64_t next = (0x5DEECE66Du * x + 0xB) % (std::uint64_t{1} << 48);
    CHECK_EQUAL(math::sequenceNumber(n + 1), double(next) * 0x1p-48);
  }
  CHECK_EQUAL(math::sequenceNumber((std::uint64_t{1} << 48) + 7), math::sequenceNumber(7));
}
