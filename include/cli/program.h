// The run of the program: parse, compile, trace, write.
#pragma once
#include "cli/messages.h"
#include "cli/options.h"

/// Does what `options` ask for and returns the exit status. Mistakes that end the run at once are
/// thrown: UsageError, InputError, or any other std::exception with a message for the user.
int runProgram(const Options& options);
