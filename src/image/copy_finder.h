// CopyFinder: earlier places where the bytes at a place stand too.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

/// A copy of `length` bytes (3..258) from `distance` bytes back (1..32768).
struct Copy {
  std::uint16_t length, distance;
};

/// Looks through one array of bytes, of which it sees no more than it has been shown.
class CopyFinder {
 public:
  /// `bytes` must stay where they are while the finder is used. `depth` is how many earlier places
  /// with the same first three bytes are looked at, the nearest first.
  CopyFinder(const std::uint8_t* bytes, std::size_t size, unsigned depth);

  /// The copies for place `at`, of length at most `end - at`: longer and longer, each at the least
  /// distance that such a length is found at. All places before `at` that are to be found must
  /// have been given to add. Puts them at the end of `copies`.
  void find(std::size_t at, std::size_t end, std::vector<Copy>& copies) const;
  /// From now on place `at` may be found; places come in rising order.
  void add(std::size_t at);
  /// Takes back add for the places from..to - 1, which must be the last that were given. Some far
  /// places may be forgotten by that.
  void remove(std::size_t from, std::size_t to);

 private:
  static constexpr unsigned kHashBits = 15;
  static constexpr std::size_t kNone = ~std::size_t{0};

  std::size_t hashAt(std::size_t at) const;

  const std::uint8_t* bytes_;
  std::size_t size_;
  unsigned depth_;
  std::vector<std::size_t> newest_;    // by hash of three bytes
  std::vector<std::size_t> previous_;  // by place modulo the window: the one before, same hash
};
