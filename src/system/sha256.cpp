// SHA-256, by the letters of the standard: w, a to h and the constants are named as there.
//
// The content is taken in blocks of 64 bytes. Each is spread to 64 words, which in 64 rounds are
// stirred into a copy of the eight words of state; the copy is then added to the state. The digest
// is the state after the last block, which ends with the content's length.
#include "system/sha256.h"

#include <algorithm>
#include <cstring>

namespace {

/// The first 32 bits of the fractional parts of the cube roots of the first 64 primes.
constexpr std::uint32_t kRound[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

constexpr std::uint32_t rotated(std::uint32_t x, int bits) { return x >> bits | x << (32 - bits); }

std::uint32_t bigEndian(const std::uint8_t* bytes) {
  return std::uint32_t(bytes[0]) << 24 | std::uint32_t(bytes[1]) << 16 |
         std::uint32_t(bytes[2]) << 8 | std::uint32_t(bytes[3]);
}

}  // namespace

void Sha256::addBlock(const std::uint8_t* block) {
  // The block's 16 words, and 48 more, each mixed of four before it.
  std::uint32_t w[64];
  for (int t = 0; t < 16; ++t) w[t] = bigEndian(block + 4 * t);
  for (int t = 16; t < 64; ++t) {
    const std::uint32_t low = w[t - 15], high = w[t - 2];
    w[t] = (rotated(high, 17) ^ rotated(high, 19) ^ high >> 10) + w[t - 7] +
           (rotated(low, 7) ^ rotated(low, 18) ^ low >> 3) + w[t - 16];
  }
  // 64 rounds: two sums are stirred in, and every word moves on by one place.
  auto [a, b, c, d, e, f, g, h] = state_;
  for (int t = 0; t < 64; ++t) {
    const std::uint32_t first = h + (rotated(e, 6) ^ rotated(e, 11) ^ rotated(e, 25)) +
                                ((e & f) ^ (~e & g)) + kRound[t] + w[t];
    const std::uint32_t second =
        (rotated(a, 2) ^ rotated(a, 13) ^ rotated(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + first;
    d = c, c = b, b = a, a = first + second;
  }
  const std::uint32_t sums[8] = {a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < 8; ++i) state_[i] += sums[i];
}

/// All bytes go through the block that waits: a copy of 64 is nothing beside what a block takes.
void Sha256::add(const void* data, std::size_t size) {
  const auto* next = static_cast<const std::uint8_t*>(data);
  while (size > 0) {
    const std::size_t filled = size_ % kBlock, part = std::min(size, kBlock - filled);
    std::memcpy(waiting_.data() + filled, next, part);
    size_ += part;
    next += part;
    size -= part;
    if (filled + part == kBlock) addBlock(waiting_.data());
  }
}

void Sha256::addNumber(std::uint64_t number) {
  std::uint8_t bytes[8];
  for (int i = 0; i < 8; ++i) bytes[i] = std::uint8_t(number >> (8 * i) & 255);
  add(bytes, sizeof bytes);
}

Digest Sha256::finish() {
  // A one bit, zeros up to 8 bytes before the end of a block, and the length in bits.
  const std::uint64_t bits = size_ * 8;
  const std::uint8_t one = 0x80, zero = 0;
  add(&one, 1);
  while (size_ % kBlock != kBlock - 8) add(&zero, 1);
  std::uint8_t length[8];
  for (int i = 0; i < 8; ++i) length[i] = std::uint8_t(bits >> (56 - 8 * i) & 255);
  add(length, sizeof length);
  Digest digest;
  for (std::size_t i = 0; i < digest.size(); ++i) {
    digest[i] = std::uint8_t(state_[i / 4] >> (24 - 8 * (i % 4)) & 255);
  }
  return digest;
}

Digest sha256(const void* data, std::size_t size) {
  Sha256 hash;
  hash.add(data, size);
  return hash.finish();
}
