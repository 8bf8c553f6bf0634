// Other processes, and the memory of this one.
#pragma once
#include <string>
#include <vector>

namespace bench {

/// What one run of a program took.
struct Run {
  double seconds = 0;    ///< from its start until its end is known
  double peakBytes = 0;  ///< the most memory that was resident
};

/// Runs words[0] with the rest as arguments, waits for it, and throws std::runtime_error where it
/// fails. Its output goes to `outputFile`, or nowhere if that is "".
Run runProcess(const std::vector<std::string>& words, const std::string& outputFile = "");

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
