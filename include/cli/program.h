// The run of the program: parse, compile, trace, write.
#pragma once
#include <string_view>

#include "cli/options.h"

/// Exit status of the program.
enum ExitStatus {
  kDone = 0,
  kOutputFailed = 1,  ///< also: not enough memory
  kWrongUsage = 2,
  kSceneAtFault = 3
};

/// Does what `options` ask for and returns the exit status. Mistakes that end the run at once are
/// thrown: UsageError, InputError, or any other std::exception with a message for the user.
int runProgram(const Options& options);

/// Writes "raytracer: " + message + a line break to standard error. Asks for no memory.
void complain(std::string_view message);

/// Writes `text` to standard output and returns kDone, or complains and returns kOutputFailed.
int print(const std::string& text);
