// Whether two names are one file.
#pragma once
#include <string>
#include <vector>

#include "cli/request.h"

/// True where both outputs go to the same place, whether or not there is a file yet: links are
/// followed, "-" is standard output, whatever that is. False where one of them is empty, or a
/// device such as /dev/null, which holds nothing that could be lost.
bool isSameOutput(const std::string& a, const std::string& b);

/// Throws UsageError where two outputs, of which `checkpoint` is one unless it is empty, name the
/// same file, or an output is the scene or one of `meshFiles`, or standard output (by whatever
/// name) where lines are printed there. Links are followed; a device such as /dev/null may be named
/// more than once.
void checkFiles(const RenderRequest& render, const std::string& checkpoint,
                const std::vector<std::string>& meshFiles = {});

/// Throws UsageError where the merged picture would replace one of its parts.
void checkMergedFiles(const MergeRequest& merge);
