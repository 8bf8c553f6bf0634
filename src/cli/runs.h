// The runs of the program, each with sources of its own. Each says what is wrong and returns the
// exit status of the program.
#pragma once
#include <vector>

#include "cli/outputs.h"
#include "cli/request.h"

/// Reads the scene, renders and writes the outputs that are wanted, prints what they ask for,
/// and returns the exit status. Throws UsageError, InputError, std::runtime_error.
int renderScene(const RenderRequest& request, const RunRequest& run);

/// Of -check: reads the scene, prints all mistakes, or that there are none, and returns the exit
/// status.
int checkScene(const PictureRequest& picture, bool quiet);

/// Reads the scene and renders the outputs that are wanted, without writing them. Prints the
/// scene's warnings unless -quiet is given. Throws InputError, std::runtime_error.
std::vector<Output> renderPictures(const RenderRequest& request, const RunRequest& run);

/// Puts the parts together and writes the whole picture in the format of its file's ending.
/// Returns kDone; or, after complaining of each mistake, kSceneAtFault where a part cannot be read,
/// belongs to another picture, overlaps another or is missing: nothing is then written. Throws
/// UsageError where the picture would replace a part, OutputError where it cannot be written.
int runMerge(const MergeRequest& request);

/// Compares what `request` names, prints the figures to standard output and writes the picture,
/// report and table that are wanted. Two files are compared as pictures, two folders picture by
/// picture: those that have the same path in them, or the same but for the ending. Of a folder and
/// a file, the file is a table of commands: each is rendered, and its pictures are compared with
/// those of the same name in the folder, likewise; pictures of the folder that no command gives are
/// a difference too. `run` says how. Returns 0 where all pairs are the same; 3 where a picture, a
/// folder, the table or the scene of a command cannot be read; else 1: a pair is different or
/// alone, or an output failed. Throws UsageError.
int runComparison(const CompareRequest& request, const RunRequest& run);
