// OpenFile: a file opened for reading, closed at the end of its life.
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <string>

class OpenFile {
 public:
  /// Waits for the writer of a FIFO. Where the file cannot be opened, errno says why.
  explicit OpenFile(const std::string& filename);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  bool isOpen() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }
  /// The size of a regular file; -1 for anything else.
  off_t regularSize() const;

 private:
  int descriptor_;
};

/// Reads once, up to `room` bytes, again where a signal interrupts; 0 at the end, < 0 on failure.
ssize_t readSome(int descriptor, char* target, std::size_t room);
