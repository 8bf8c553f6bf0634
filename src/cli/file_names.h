// Whether two names are one file.
#pragma once
#include <string>

/// True where both outputs go to the same place, whether or not there is a file yet: links are
/// followed, "-" is standard output, whatever that is. False where one of them is empty, or a
/// device such as /dev/null, which holds nothing that could be lost.
bool isSameOutput(const std::string& a, const std::string& b);
