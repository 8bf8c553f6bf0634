// OutputFile: a file that is either the old one or the whole new one.
// Bytes go to NAME.tmp.PID beside the place, which commit() renames to NAME. What is not a plain
// file (a device, a FIFO, /dev/stdout, /dev/fd/N, /proc/...) is written in place. The name "-" is
// standard output, "./-" a file. And what a signal that ends the program must know of: these files,
// and whether a line of standard error is open.
#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>

/// How messages call an output: its path, or "standard output" for "-".
std::string outputTitle(const std::string& path);

/// An output that cannot be written. what() is "PATH: cannot be written: reason".
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& path, const std::string& reason)
      : std::runtime_error(outputTitle(path) + ": cannot be written: " + reason) {}
};

class OutputFile {
 public:
  /// Opens the output. A symbolic link is followed: the file that it points to is the one that
  /// commit() replaces. A new file gets the permissions 0666 & ~umask; a replaced one keeps its
  /// permission bits, and its owner where the system allows that. One that is write-protected is
  /// an error, although a rename could replace it. A descriptor of this process (/dev/fd/N) is
  /// written from where it stands, without truncating. Opening a FIFO waits for its reader.
  /// Throws OutputError.
  explicit OutputFile(const std::string& path);
  /// Without commit() before it: removes the temporary file; the old file stays as it was.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends `size` bytes. Throws OutputError; the object can then only be destroyed.
  void write(const void* data, std::size_t size);
  /// Flushes to the disk, checks that the file has as many bytes as were written, closes it, and
  /// puts it in its place. Nothing can be written after. Throws OutputError; the old file is then
  /// still in its place, unless the folder alone could not be flushed to the disk.
  void commit();

 private:
  /// Creates temporary_ for writing and notes its name for the signal handler, as one step that no
  /// signal can split. Sets descriptor_; where it cannot, leaves it, and sets errno.
  void createTemporary(unsigned permissions);
  /// Renames the temporary file to target_, or, where it is not `isWhole`, removes it; in the same
  /// way, one step. False where it cannot be renamed: errno says why, and it is still there.
  bool endTemporary(bool isWhole);
  void discard();
  [[noreturn]] void fail(int error) const;

  std::string path_;          // as the user gave it, for messages
  std::string target_;        // the file to replace, links followed
  std::string temporary_;     // the name being written
  int descriptor_ = -1;       // closed: -1
  std::size_t size_ = 0;      // bytes written
  bool isTemporary_ = false;  // a file of the name temporary_ stands there
};

/// Writes a whole file: OutputFile, write, commit. Throws OutputError.
void writeFile(const std::string& path, const void* data, std::size_t size);

/// Tells before a long render that OutputFile(path) could not succeed: the folder is missing or
/// not writable, the name is a folder or a write-protected file. Writes and creates nothing, and
/// opens no FIFO. A disk that fills up later is not foreseen. Throws OutputError.
void checkOutput(const std::string& path);

/// Where OutputFile(path) would put the file, whether or not there is one: an absolute path, its
/// links followed as far as that can be done.
std::string outputTarget(const std::string& path);

/// A line of standard error is being redrawn: a signal that ends the program ends the line too, and
/// a message begins below it.
void setLineOpen(bool isOpen);
bool isLineOpen();

/// To be called once, by main: from then on a signal that ends the program (SIGINT, SIGTERM,
/// SIGHUP, a crash, ...) removes every temporary file first. Signals that ask the program to end
/// give exit status 128 + signal; those that were ignored stay ignored. SIGPIPE and SIGXFSZ are
/// ignored, so that a closed pipe or the file size limit becomes an OutputError.
void removeTemporaryOnSignals();
