// FolderLock: one run at a time changes a file that is replaced as a whole.
#pragma once
#include <string>

/// Of a file that is read, added to and replaced, the lock can only be its folder: a lock on the
/// file itself would go with the old one.
class FolderLock {
 public:
  /// Waits while another run has the folder of `file` (links followed). Locks nothing, as if it
  /// had, where the folder cannot be opened or its file system has no locks.
  explicit FolderLock(const std::string& file);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;  // -1: none
};
