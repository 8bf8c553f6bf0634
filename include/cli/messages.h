// What the program says, and the status that it ends with.
#pragma once
#include <string>
#include <string_view>

/// Exit status of the program.
enum ExitStatus {
  kDone = 0,
  kOutputFailed = 1,  ///< also: not enough memory
  kWrongUsage = 2,
  kSceneAtFault = 3
};

/// Writes "raytracer: " + message + a line break to standard error, every byte of it and all at
/// once, so that the lines of several threads or programs do not mix. Asks for no memory.
void complain(std::string_view message);

/// Writes `text` to standard output and returns kDone, or complains and returns kOutputFailed.
int print(const std::string& text);
