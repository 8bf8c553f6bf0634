// Other processes, and the memory of this one.
#pragma once
#include <string>
#include <vector>

namespace bench {

/// What one run of a program took.
struct Run {
  double seconds = 0;  ///< from its start until its end is known
  /// The most memory that was resident, in it or, before it started, in the process that called.
  double peakBytes = 0;
};

/// Runs words[0] with the rest as arguments, waits for it, and throws std::runtime_error where it
/// fails. Its output goes to `outputFile`.
Run runProcess(const std::vector<std::string>& words, const std::string& outputFile = "/dev/null");

/// The same from a fresh small process, so that peakBytes is the program's own.
Run runFresh(const std::vector<std::string>& words, const std::string& outputFile = "/dev/null");

/// The same; returns what the program wrote to standard output.
std::string outputOf(const std::vector<std::string>& words);

/// The path of this very program.
std::string ownProgram();

/// Makes the resident memory of now, which is returned in bytes, the peak so far.
double startPeakMemory();
/// The most bytes resident since then.
double peakMemory();

/// A folder for this run, removed with everything in it at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace bench
