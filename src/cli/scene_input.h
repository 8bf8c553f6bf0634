// The scene of a run: reading it, and what is to be said of it.
#pragma once
#include "cli/request.h"
#include "scene/object_places.h"
#include "scene/scene_parser.h"
#include "system/sha256.h"

/// What is noted of a scene while it is read, as far as it is needed.
struct ReadNotes {
  Digest digest = {};   ///< of its bytes, for a checkpoint or a part
  ObjectPlaces places;  ///< for -pixel
};

/// Reads the scene that is wanted and its meshes. Throws InputError, OutOfMemory.
SceneParser readScene(const RenderRequest& render, const RunRequest& run, ReadNotes& notes);

/// Prints the warnings, unless `quiet`, and finds out what rendering will ask.
void prepareScene(SceneParser& scene, const PictureRequest& picture, bool quiet);

/// The run of -check of the scene `file`: prints all mistakes, or that there are none, and returns
/// the exit status.
int checkScene(const std::string& file, bool quiet);
