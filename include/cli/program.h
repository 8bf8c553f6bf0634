// The program: what it does with a command line, what it says, and the status that it ends with.
#pragma once
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Exit status of the program.
enum ExitStatus {
  kDone = 0,
  kOutputFailed = 1,  ///< also: not enough memory
  kWrongUsage = 2,
  kSceneAtFault = 3
};

/// A mistake in the command line: what() says what was expected and what was found.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The pieces one after the other, numbers with 6 significant digits at most; `inf` for infinity.
template <class... Pieces>
std::string joined(const Pieces&... pieces) {
  std::ostringstream text;
  (text << ... << pieces);
  return text.str();
}

/// Throws UsageError with all the `pieces` in a row.
template <class... Pieces>
[[noreturn]] void failUsage(const Pieces&... pieces) {
  throw UsageError(joined(pieces...));
}

/// Throws it where the claim holds.
template <class... Pieces>
void refuseIf(bool isWrong, const Pieces&... pieces) {
  if (isWrong) failUsage(pieces...);
}

/// "640 x 480".
inline std::string sizeText(int width, int height) { return joined(width, " x ", height); }

/// Does what the command line `words`, without the program's own name, asks for and returns the
/// exit status. Mistakes that end the run at once are thrown: UsageError, InputError, or any other
/// std::exception with a message for the user.
int runProgram(const std::vector<std::string>& words);

/// Writes "raytracer: " + message + a line break to standard error, every byte of it and all at
/// once, so that the lines of several threads or programs do not mix. Asks for no memory.
void complain(std::string_view message);

/// Writes `text` to standard output and returns kDone, or complains and returns kOutputFailed.
int print(const std::string& text);

/// Ends a run, and says what memory was wanted for.
class OutOfMemory : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns work(); where memory runs out, throws OutOfMemory with `purpose`, "to ...".
template <class Work>
auto withMemory(const std::string& purpose, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw OutOfMemory("not enough memory " + purpose);
  }
}
