// Eight bytes of a text at a time, side by side in one 64-bit number, the first one lowest.
// A mark is the highest bit of a byte; marks tell which bytes are of one kind.
// Source of the idea: Mycroft, comp.lang.c, 1987; Warren, "Hacker's Delight", 2002, chapter 6.
#pragma once
#include <cstdint>
#include <cstring>

namespace eight_bytes {

inline constexpr std::uint64_t kMarks = 0x8080808080808080;

/// A number whose bytes are all `byte`.
constexpr std::uint64_t all(unsigned char byte) { return 0x0101010101010101 * byte; }

/// The eight bytes from `p` on, all of which must be there.
inline std::uint64_t load(const char* p) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, p, 8);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  bytes = __builtin_bswap64(bytes);
#endif
  return bytes;
}

/// The same, with zeros where the text ends before.
inline std::uint64_t load(const char* p, const char* end) {
  if (end - p >= 8) return load(p);
  char bytes[8] = {};
  for (char* next = bytes; p != end; ++p) *next++ = *p;
  return load(bytes);
}

/// The number of the first byte that has any bit set; `marks` must not be 0.
inline int firstMarked(std::uint64_t marks) { return __builtin_ctzll(marks) / 8; }

/// Marks every byte of at least `bound`, from 1 to 127. No carry leaves a byte.
constexpr std::uint64_t markAtLeast(std::uint64_t bytes, unsigned char bound) {
  const std::uint64_t low = bytes & ~kMarks;
  return ((low + all(static_cast<unsigned char>(128 - bound))) | bytes) & kMarks;
}

}  // namespace eight_bytes
