// Files on POSIX: descriptors, owned by the objects that opened them.
//
// A signal may interrupt a call that waits (EINTR): it is then made again. A read may bring less
// than was asked for, and a write take less: it goes on until the end of the file, or of all bytes.
#include "system/files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <initializer_list>

static_assert(sizeof(off_t) == 8, "files beyond 2 GB need _FILE_OFFSET_BITS=64");

OpenFile::OpenFile(const std::string& filename, int flags)
    : descriptor_(open(filename.c_str(), flags | O_CLOEXEC, 0666)) {}

OpenFile::~OpenFile() {
  if (isOpen()) close(descriptor_);
}

off_t OpenFile::regularSize() const {
  struct stat status;
  if (fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return -1;
  return status.st_size;
}

ssize_t OpenFile::readAt(off_t offset, void* target, std::size_t size) const {
  std::size_t done = 0;
  for (ssize_t count = 1; done < size && count != 0; done += std::size_t(count)) {
    char* const next = static_cast<char*>(target) + done;
    count =
        uninterrupted([&] { return pread(descriptor_, next, size - done, offset + off_t(done)); });
    if (count < 0) return -1;
  }
  return ssize_t(done);
}

bool OpenFile::writeAt(off_t offset, const void* source, std::size_t size) const {
  for (std::size_t done = 0; done < size;) {
    const char* const next = static_cast<const char*>(source) + done;
    const ssize_t count =
        uninterrupted([&] { return pwrite(descriptor_, next, size - done, offset + off_t(done)); });
    if (count == 0) errno = EIO;
    if (count <= 0) return false;
    done += std::size_t(count);
  }
  return true;
}

/// Only "another has it" is a refusal: where there are no locks, the file is used without.
bool OpenFile::lock(bool waits) const {
  const int how = LOCK_EX | (waits ? 0 : LOCK_NB);
  return uninterrupted([&] { return flock(descriptor_, how); }) == 0 || errno != EWOULDBLOCK;
}

void keepStandardFiles() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) >= 0) continue;
    // The lowest free number is this one. Opened the wrong way round: any use is an error.
    const int wrongWay = descriptor == STDOUT_FILENO ? O_RDONLY : O_WRONLY;
    // Where there is no /dev, a folder does: to read and to write it are errors too.
    if (open("/dev/null", wrongWay) < 0 && open("/", O_RDONLY | O_DIRECTORY) < 0) return;
  }
}
