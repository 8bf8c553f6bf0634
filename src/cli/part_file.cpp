// PartFile.
#include "cli/part_file.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "scene/input_error.h"
#include "system/files.h"

namespace {

constexpr std::size_t kHeader = 18;

[[noreturn]] void fail(const std::string& path, const std::string& message) {
  throw InputError(path, 0, message);
}

[[noreturn]] void failNoPart(const std::string& path, const std::string& found) {
  fail(path, "expected a TGA that -region or -tile has written, found " + found);
}

/// Reads as many bytes as there are, up to `size`.
std::size_t readAt(const std::string& path, int descriptor, std::int64_t offset,
                   std::uint8_t* target, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count =
        pread(descriptor, target + done, size - done, off_t(offset) + off_t(done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0) break;
    done += std::size_t(count);
  }
  return done;
}

int numberAt(const std::uint8_t* bytes) { return bytes[0] + 256 * bytes[1]; }

/// Apart from sizes and places, the header that a part has.
bool isHeader(const std::uint8_t* header) {
  const auto isZero = [](std::uint8_t byte) { return byte == 0; };
  return header[1] == 0 && header[2] == 2 && std::all_of(header + 3, header + 8, isZero) &&
         header[16] == 24 && header[17] == 0x20;
}

std::string bytesText(std::int64_t count) { return std::to_string(count) + " bytes"; }

std::int64_t pixelsStart(const PartFile& part) {
  return std::int64_t(kHeader + textOf(part.id).size());
}

void checkSize(const PartFile& part, std::int64_t found) {
  const std::int64_t expected = pixelsStart(part) + 3 * std::int64_t(part.width) * part.height;
  if (found < expected) {
    fail(part.path, "cut off: expected " + bytesText(expected) + ", found " + bytesText(found));
  }
  if (found > expected) {
    fail(part.path, "expected " + bytesText(expected) + ", found " + bytesText(found));
  }
}

void checkPlace(const PartFile& part) {
  const bool fits = part.width > 0 && part.height > 0 && part.x + part.width <= part.id.width &&
                    part.y + part.height <= part.id.height;
  if (!fits) fail(part.path, "damaged: its place is not in the picture that it is a part of");
}

}  // namespace

PartFile PartFile::read(const std::string& path) {
  const OpenFile file(path);
  if (!file.isOpen()) fail(path, std::string("cannot be read: ") + std::strerror(errno));
  const auto size = std::int64_t(file.regularSize());
  if (size < 0) failNoPart(path, "no plain file");
  std::uint8_t header[kHeader + 255] = {};
  const std::size_t found = readAt(path, file.descriptor(), 0, header, sizeof header);
  if (found < kHeader) failNoPart(path, bytesText(size));
  if (!isHeader(header)) failNoPart(path, "another kind of file");
  if (header[0] == 0) failNoPart(path, "a TGA without an image ID, which is no part");
  PartFile part;
  part.path = path;
  if (found < kHeader + header[0]) failNoPart(path, bytesText(size));
  const std::string text(header + kHeader, header + kHeader + header[0]);
  if (!readPartId(text, part.id)) failNoPart(path, "a TGA with another image ID");
  part.x = numberAt(header + 8);
  part.y = numberAt(header + 10);
  part.width = numberAt(header + 12);
  part.height = numberAt(header + 14);
  checkPlace(part);
  checkSize(part, size);
  return part;
}

void PartFile::readRow(int descriptor, int row, std::uint8_t* target) const {
  const std::size_t size = 3 * std::size_t(width);
  const std::int64_t offset = pixelsStart(*this) + std::int64_t(size) * row;
  if (readAt(path, descriptor, offset, target, size) < size) fail(path, "has become shorter");
}
