// Bytes: the content of a file, and a walk through it that never goes past its end.
#pragma once
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using Bytes = std::vector<std::uint8_t>;

/// A picture that cannot be read. what() is "FILE: message"; the message says what was expected
/// and what was found.
class ImageError : public std::runtime_error {
 public:
  ImageError(const std::string& file, const std::string& message)
      : std::runtime_error(file + ": " + message) {}
};

/// The whole content of a file; a pipe is read to its end, but no further than 1 GiB, a
/// device no further than 64 MB. Throws ImageError.
Bytes readBytes(const std::string& path);

/// Reads a picture file from its first byte on.
class ByteReader {
 public:
  /// `bytes` must outlive the reader. `name` is the file, for messages.
  ByteReader(const Bytes& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::size_t position() const { return position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }
  /// The byte at hand, of which there must be one; it is not taken.
  unsigned peek() const { return bytes_[position_]; }

  /// Goes `count` bytes on and gives a pointer to the first of them; `what` names them for the
  /// message. Throws ImageError where fewer are left.
  const std::uint8_t* take(std::size_t count, const std::string& what);
  unsigned takeByte(const char* what) { return *take(1, what); }

  /// To be called before memory is asked for the picture: throws ImageError where it has more than
  /// `most` pixels, as many as the `found` bytes that are left, of a `kind` (" compressed"), can
  /// hold. Sides are below 2^31.
  void checkSize(std::uint64_t width, std::uint64_t height, std::uint64_t most, std::size_t found,
                 const char* kind = "") const;

  /// Throws ImageError with a message made of these texts and numbers.
  template <class... Words>
  [[noreturn]] void fail(const Words&... words) const {
    std::ostringstream message;
    (message << ... << words);
    throw ImageError(name_, message.str());
  }
  /// Does that where the claim does not hold.
  template <class... Words>
  void check(bool claim, const Words&... words) const {
    if (!claim) fail(words...);
  }
  /// An entry of a palette. Throws ImageError where there are not so many.
  template <class Color>
  const Color& entryAt(std::size_t index, const std::vector<Color>& palette) const {
    check(index < palette.size(), "expected a palette index below ", palette.size(), ", found ",
          index);
    return palette[index];
  }

 private:
  const Bytes& bytes_;
  std::string name_;
  std::size_t position_ = 0;
};

/// Numbers with the low byte first, as TGA, BMP and PFM have them.
inline unsigned littleEndian16(const std::uint8_t* bytes) {
  return unsigned(bytes[0] | bytes[1] << 8);
}
inline std::uint32_t littleEndian32(const std::uint8_t* bytes) {
  return littleEndian16(bytes) | std::uint32_t{littleEndian16(bytes + 2)} << 16;
}
/// Appends the `count` <= 4 low bytes of the value.
void appendLittleEndian(std::uint32_t value, int count, Bytes& bytes);

/// Numbers of 32 bits with the high byte first, as PNG has them.
inline std::uint32_t bigEndian32(const std::uint8_t* bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
         std::uint32_t{bytes[2]} << 8 | std::uint32_t{bytes[3]};
}
void appendBigEndian(std::uint32_t value, Bytes& bytes);
