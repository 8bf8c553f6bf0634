// What a run that renders does.
#pragma once
#include <vector>

#include "cli/outputs.h"
#include "cli/request.h"

/// Reads the scene, renders and writes the outputs that are wanted, prints what they ask for,
/// and returns the exit status. Throws UsageError, InputError, std::runtime_error.
int renderScene(const RenderRequest& request, const RunRequest& run);

/// Reads the scene and renders the outputs that are wanted, without writing them. Prints the
/// scene's warnings unless -quiet is given. Throws InputError, std::runtime_error.
std::vector<Output> renderPictures(const RenderRequest& request, const RunRequest& run);
