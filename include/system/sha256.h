// SHA-256: a digest that tells contents apart: no two different ones with the same are known.
// Source: FIPS PUB 180-4, "Secure Hash Standard", 2015, sections 4 to 6.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

using Digest = std::array<std::uint8_t, 32>;

class Sha256 {
 public:
  /// Appends bytes to the content, 2^61 - 1 of them at most in all.
  void add(const void* data, std::size_t size);
  void add(std::string_view text) { add(text.data(), text.size()); }
  void add(const Digest& digest) { add(digest.data(), digest.size()); }
  /// Appends a number as 8 bytes, the lowest first.
  void addNumber(std::uint64_t number);

  /// The digest of all that was added; nothing can be added after.
  Digest finish();

 private:
  static constexpr std::size_t kBlock = 64;
  void addBlock(const std::uint8_t* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::uint64_t size_ = 0;  // bytes added so far; those of the last, unfinished block wait
  std::array<std::uint8_t, kBlock> waiting_{};
};

/// The digest of `size` bytes.
Digest sha256(const void* data, std::size_t size);
