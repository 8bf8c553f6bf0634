// The run of `raytracer -compare`.
#pragma once
#include "cli/request.h"

/// Exit status of a comparison.
enum CompareStatus {
  kSame = 0,
  kDifferent = 1,   ///< also: an output failed
  kUnreadable = 3,  ///< a picture, a folder, a table, or the scene of a command
};

/// Compares what `compare` names, prints the figures to standard output and writes the
/// picture, report and table that are wanted. Returns the worst CompareStatus of all pairs, where
/// kUnreadable is the worst. Two files are compared as pictures, two folders by picturePairs. Of a
/// folder and a file, the file is a table of commands: each is rendered, and its pictures are
/// compared with those of the same name, or the same name but for the ending, in the folder;
/// pictures of the folder that no command gives are a difference too.
/// Throws UsageError.
int runComparison(const CompareRequest& compare, const RunRequest& run);
