// Eight bytes of a text at a time, side by side in one 64-bit number, the first one lowest.
// A mark is the highest bit of a byte; marks tell which bytes are of one kind.
#pragma once
#include <cstdint>
#include <cstring>

namespace eight_bytes {

inline constexpr std::uint64_t kMarks = 0x8080808080808080;

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

}  // namespace eight_bytes
