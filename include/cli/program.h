// The run of the program: parse, compile, trace, write.
#pragma once
#include <string>
#include <vector>

#include "cli/messages.h"
#include "cli/usage_error.h"

/// Does what the command line `words`, without the program's own name, asks for and returns the
/// exit status. Mistakes that end the run at once are thrown: UsageError, InputError, or any other
/// std::exception with a message for the user.
int runProgram(const std::vector<std::string>& words);
