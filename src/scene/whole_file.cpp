// Reading a whole file into memory, whatever kind of file it is.
#include "scene/whole_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>

#include "system/files.h"
#include "system/memory.h"

namespace {

constexpr std::size_t kChunk = std::size_t(1) << 20;
constexpr std::size_t kLeastRoom = 4096;
constexpr std::size_t kPipe = std::size_t(1) << 16;  // what a pipe holds, and gives at a time
/// Devices such as /dev/zero never end: more than this from one is a mistake.
constexpr std::size_t kMaxDeviceBytes = std::size_t(64) << 20;

/// What the system says of the last call that failed.
std::string systemReason() { return std::strerror(errno); }

/// Reads to the end. Memory is touched a chunk at a time, as the bytes come. Returns why it could
/// not, or nothing.
std::string readToEnd(int descriptor, std::string& bytes) {
  struct stat status;
  if (fstat(descriptor, &status) != 0) return systemReason();
  if (S_ISDIR(status.st_mode)) return "it is a folder, expected a file";
  if (S_ISREG(status.st_mode)) bytes.reserve(std::size_t(status.st_size) + 1);
  preferLargePages(bytes.data(), bytes.capacity());
  const std::size_t limit =
      S_ISCHR(status.st_mode) ? kMaxDeviceBytes : std::numeric_limits<std::size_t>::max();
  const std::size_t most = S_ISREG(status.st_mode) ? kChunk : kPipe;
  for (;;) {
    const std::size_t size = bytes.size();
    if (size > limit) return "the device gives more than 64 MB, expected a file";
    const std::size_t room = bytes.capacity() - size;
    // The end is found with what room there is: more would copy all that has been read.
    bytes.resize(size + (room > 0 ? std::min(room, most) : kLeastRoom));
    const ssize_t count = readSome(descriptor, &bytes[size], bytes.size() - size);
    bytes.resize(size + std::size_t(std::max(count, ssize_t(0))));
    if (count < 0) return systemReason();
    if (count == 0) return {};
  }
}

bool readOrExplain(int descriptor, std::string& bytes, std::string& reason) {
  try {
    bytes.clear();
    reason = readToEnd(descriptor, bytes);
  } catch (const std::length_error&) {  // more than any memory holds
    throw std::bad_alloc();
  }
  return reason.empty();
}

}  // namespace

bool readWholeFile(const std::string& filename, std::string& bytes, std::string& reason) {
  const OpenFile file(filename);
  if (file.isOpen()) return readOrExplain(file.descriptor(), bytes, reason);
  reason = systemReason();
  return false;
}

bool readStandardInput(std::string& bytes, std::string& reason) {
  return readOrExplain(STDIN_FILENO, bytes, reason);
}
