// Bytes: reads a whole file, takes bytes of it, and appends numbers.
// Memory grows with what has been read, as a file's size may change meanwhile, and a pipe has none.
#include "image/bytes.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "system/files.h"

Bytes readBytes(const std::string& path) {
  // What is no plain file may never end, so that it is read to a limit only.
  constexpr std::size_t kStep = 65536;
  constexpr std::size_t kMostOfDevice = std::size_t{64} << 20;  // one such as /dev/zero never ends
  constexpr std::size_t kMostStreamed = std::size_t{1} << 30;
  const OpenFile file(path);
  struct stat status = {};
  if (!file.isOpen() || fstat(file.descriptor(), &status) != 0) {
    throw ImageError(path, std::strerror(errno));
  }
  Bytes bytes;
  for (ssize_t count = 1; count > 0;) {
    const std::size_t before = bytes.size();
    if (S_ISCHR(status.st_mode) && before > kMostOfDevice) {
      throw ImageError(path, "expected at most 64 MB from a device, found more");
    }
    if (!S_ISREG(status.st_mode) && before > kMostStreamed) {
      throw ImageError(path, "expected at most 1 GiB from what is no plain file, found more");
    }
    // One step more, then cut off to what has come; the vector doubles its memory as it grows.
    bytes.resize(before + kStep);
    count = readSome(file.descriptor(), reinterpret_cast<char*>(&bytes[before]), kStep);
    if (count < 0) throw ImageError(path, std::strerror(errno));
    bytes.resize(before + static_cast<std::size_t>(count));
  }
  return bytes;
}

// By shifts, and so the same on machines of either byte order.
void appendLittleEndian(std::uint32_t value, int count, Bytes& bytes) {
  for (; count > 0; --count, value >>= 8) bytes.push_back(std::uint8_t(value & 255));
}

void appendBigEndian(std::uint32_t value, Bytes& bytes) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(std::uint8_t(value >> shift & 255));
}

const std::uint8_t* ByteReader::take(std::size_t count, const std::string& what) {
  check(count <= remaining(), "expected ", count, " bytes of ", what, " at byte ", position_,
        ", found ", remaining());
  position_ += count;
  return bytes_.data() + position_ - count;
}

/// A small picture may be as dense as it likes: it costs little whatever the file says.
void ByteReader::checkSize(std::uint64_t width, std::uint64_t height, std::uint64_t most,
                           std::size_t found, const char* kind) const {
  // Sides below 2^31, so that the product is below 2^62.
  constexpr std::uint64_t kMostPixels = 1 << 26, kMostPerByte = 256;
  const std::uint64_t pixels = width * height;
  check(pixels <= most, "expected the data of ", width, " x ", height, " pixels, found ", found,
        kind, " bytes");
  check(pixels <= kMostPixels || pixels / kMostPerByte <= bytes_.size(), "a picture of ", width,
        " x ", height, " pixels in a file of ", bytes_.size(), " bytes is refused");
}
