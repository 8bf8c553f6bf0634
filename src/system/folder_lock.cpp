// FolderLock, by flock on the folder: it ends with the process, however that ends.
#include "system/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

FolderLock::FolderLock(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path folder =
      std::filesystem::weakly_canonical(std::filesystem::absolute(file, ignored), ignored)
          .parent_path();
  descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) return;
  while (flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
  }
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) close(descriptor_);
}
