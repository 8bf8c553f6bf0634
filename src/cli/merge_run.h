// The run of `raytracer -merge`.
#pragma once
#include "cli/request.h"

/// Puts the parts together and writes the whole picture in the format of its file's ending.
/// Returns kDone; or, after complaining of each mistake, kSceneAtFault where a part cannot be read,
/// belongs to another picture, overlaps another or is missing: nothing is then written. Throws
/// OutputError where the picture cannot be written.
int runMerge(const MergeRequest& options);
