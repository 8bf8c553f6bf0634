// Files as the operating system gives them: opened, read, locked; and the three that every process
// starts with. Outputs, which are all or nothing, are image/output_file.h.
#pragma once
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string>

#include "system/memory.h"

/// Makes a call of the system, and again as long as signals interrupt it; gives its result.
template <class Call>
auto uninterrupted(const Call& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

/// A file or folder that is open, and closed at the end of its life.
class OpenFile {
 public:
  /// For reading, or as `flags` of open(2) say. Waits for the writer of a FIFO. Where the file
  /// cannot be opened, errno says why.
  explicit OpenFile(const std::string& filename, int flags = 0);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  bool isOpen() const { return descriptor_ >= 0; }
  /// -1 where it is not open. Owned by this.
  int descriptor() const { return descriptor_; }
  /// The size in bytes of a regular file; -1 for anything else.
  off_t regularSize() const;

  /// Reads up to `size` bytes from `offset` on, again where a signal interrupts; fewer only at the
  /// end of the file. < 0 on failure, and errno then says why.
  ssize_t readAt(off_t offset, void* target, std::size_t size) const;

  /// Writes all of it at `offset`, likewise. False on failure, and errno then says why.
  bool writeAt(off_t offset, const void* source, std::size_t size) const;

  /// Keeps other processes from locking the same file until this one is closed, however its process
  /// ends. False where another one has it and `waits` is false. A file system without locks, or
  /// what is not open, is taken as it is.
  bool lock(bool waits) const;

 private:
  int descriptor_;
};

/// How reading a file to its end went.
enum class ReadOutcome {
  whole,
  failed,      ///< errno says why; EISDIR where it is a folder
  longDevice,  ///< it has given more than 64 MB: such as /dev/zero never ends
  longStream   ///< what is no plain file has given more than was allowed
};

/// Appends to `bytes`, a string or vector of bytes, all that is to come from an open file of any
/// kind. Memory is touched a little at a time, as the bytes come, whatever size was declared.
template <class Bytes>
ReadOutcome readToEnd(int descriptor, Bytes& bytes, std::size_t mostStreamed) {
  constexpr std::size_t kMostOfDevice = std::size_t(64) << 20;
  constexpr std::size_t kLeastRoom = 4096;
  constexpr std::size_t kMostRoom = 65536;  // what a pipe holds, and gives at a time
  struct stat status;
  if (fstat(descriptor, &status) != 0) return ReadOutcome::failed;
  const bool isPlain = S_ISREG(status.st_mode);
  if (isPlain) bytes.reserve(std::size_t(status.st_size) + 1);
  preferLargePages(bytes.data(), bytes.capacity());
  for (;;) {
    const std::size_t size = bytes.size();
    if (S_ISCHR(status.st_mode) && size > kMostOfDevice) return ReadOutcome::longDevice;
    if (!isPlain && size > mostStreamed) return ReadOutcome::longStream;
    // The end is found with what room there is: more would copy all that has been read.
    const std::size_t room = bytes.capacity() - size;
    bytes.resize(size + (room > 0 ? std::min(room, kMostRoom) : kLeastRoom));
    const ssize_t count =
        uninterrupted([&] { return ::read(descriptor, &bytes[size], bytes.size() - size); });
    bytes.resize(size + std::size_t(std::max(count, ssize_t(0))));
    if (count <= 0) return count < 0 ? ReadOutcome::failed : ReadOutcome::whole;
  }
}

/// To be called once, by main, before any file is opened. Where the caller has closed standard
/// input, output or error, its number is taken, so that no other file gets it and is read, or
/// written with messages, in its stead: reading standard input or writing standard output then
/// fails (EBADF), and messages go nowhere.
void keepStandardFiles();
