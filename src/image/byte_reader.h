// ByteReader: walks through the bytes of a picture file, and never past their end.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "image/bytes.h"

class ByteReader {
 public:
  /// `bytes` must outlive the reader. `name` is the file, for messages.
  ByteReader(const Bytes& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::size_t position() const { return position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }

  /// Goes `count` bytes on and gives a pointer to the first of them; `what` names them for the
  /// message. Throws ImageError where fewer are left.
  const std::uint8_t* take(std::size_t count, const char* what) {
    if (count > remaining()) {
      fail("expected " + std::to_string(count) + " bytes of " + what + " at byte " +
           std::to_string(position_) + ", found " + std::to_string(remaining()));
    }
    const std::uint8_t* const first = bytes_.data() + position_;
    position_ += count;
    return first;
  }
  unsigned takeByte(const char* what) { return *take(1, what); }

  /// Refuses a picture that is enormous for so small a file, before memory is asked for: one of
  /// more than 2^26 pixels has at least a byte for each 256 of them. (A PNG of nothing but zeros
  /// has 344 to 1032, a run-length encoded TGA at most 64.)
  void checkSize(std::uint64_t width, std::uint64_t height) const {
    constexpr std::uint64_t kMostPixels = 1 << 26, kMostPerByte = 256;
    if (width * height <= kMostPixels || width * height / kMostPerByte <= bytes_.size()) return;
    fail("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
         " pixels in a file of " + std::to_string(bytes_.size()) + " bytes is refused");
  }

  [[noreturn]] void fail(const std::string& message) const { throw ImageError(name_, message); }

 private:
  const Bytes& bytes_;
  std::string name_;
  std::size_t position_ = 0;
};

/// 16 bits, the low byte first, as TGA has them.
inline unsigned littleEndian16(const std::uint8_t* bytes) { return bytes[0] + 256u * bytes[1]; }

/// 32 bits, the high byte first, as PNG has them.
inline std::uint32_t bigEndian32(const std::uint8_t* bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
         std::uint32_t{bytes[2]} << 8 | std::uint32_t{bytes[3]};
}
