// Opening, reading and closing files on POSIX.
#include "system/open_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

static_assert(sizeof(off_t) == 8, "files beyond 2 GB need _FILE_OFFSET_BITS=64");

OpenFile::OpenFile(const std::string& filename)
    : descriptor_(open(filename.c_str(), O_RDONLY | O_CLOEXEC)) {}

OpenFile::~OpenFile() {
  if (isOpen()) close(descriptor_);
}

off_t OpenFile::regularSize() const {
  struct stat status;
  if (fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return -1;
  return status.st_size;
}

ssize_t readSome(int descriptor, char* target, std::size_t room) {
  for (;;) {
    const ssize_t count = ::read(descriptor, target, room);
    if (count >= 0 || errno != EINTR) return count;
  }
}
