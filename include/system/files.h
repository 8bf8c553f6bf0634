// Files as the operating system gives them: opened, read, locked; and the three that every process
// starts with. Outputs, which are all or nothing, are image/output_file.h.
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <string>

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

  /// Keeps other processes from locking the same file until this one is closed, however its process
  /// ends. False where another one has it and `waits` is false. A file system without locks, or
  /// what is not open, is taken as it is.
  bool lock(bool waits) const;

 private:
  int descriptor_;
};

/// Reads once, up to `room` bytes, again where a signal interrupts; returns how many were read, 0
/// at the end, < 0 on failure, which errno explains.
ssize_t readSome(int descriptor, char* target, std::size_t room);

/// To be called once, by main, before any file is opened. Where the caller has closed standard
/// input, output or error, its number is taken, so that no other file gets it and is read, or
/// written with messages, in its stead: reading standard input or writing standard output then
/// fails (EBADF), and messages go nowhere.
void keepStandardFiles();
