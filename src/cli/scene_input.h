// The scene of a run: reading it, and what is to be said of it.
#pragma once
#include "cli/options.h"
#include "scene/object_places.h"
#include "scene/scene_parser.h"
#include "system/sha256.h"

/// What is noted of a scene while it is read, as far as it is needed.
struct ReadNotes {
  Digest digest = {};   ///< of its bytes, for a checkpoint or a part
  ObjectPlaces places;  ///< for -pixel
};

/// Reads the scene that `options` name and its meshes. Throws InputError, OutOfMemory.
SceneParser readScene(const Options& options, ReadNotes& notes);

/// Prints the warnings, unless -quiet is given, and finds out what rendering will ask.
void prepareScene(SceneParser& scene, const Options& options);

/// The run of -check: prints all mistakes, or that there are none, and returns the exit status.
int checkScene(const Options& options);
