// Bytes: reads a whole file, takes bytes of it, and appends numbers.
#include "image/bytes.h"

#include <cerrno>
#include <cstring>

#include "system/files.h"

Bytes readBytes(const std::string& path) {
  const OpenFile file(path);
  Bytes bytes;
  const ReadOutcome outcome = file.isOpen()
                                  ? readToEnd(file.descriptor(), bytes, std::size_t{1} << 30)
                                  : ReadOutcome::failed;
  if (outcome == ReadOutcome::failed) throw ImageError(path, std::strerror(errno));
  if (outcome == ReadOutcome::longDevice) {
    throw ImageError(path, "expected at most 64 MB from a device, found more");
  }
  if (outcome == ReadOutcome::longStream) {
    throw ImageError(path, "expected at most 1 GiB from what is no plain file, found more");
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

void ByteReader::checkSize(std::uint64_t width, std::uint64_t height, std::uint64_t most,
                           std::size_t found, const char* kind) const {
  // Sides below 2^31, so that the product is below 2^62.
  check(width * height <= most, "expected the data of ", width, " x ", height, " pixels, found ",
        found, kind, " bytes");
}
