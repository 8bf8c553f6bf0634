// What a run that renders does.
#pragma once
#include <vector>

#include "cli/options.h"
#include "cli/outputs.h"

/// Reads the scene, renders and writes the outputs that `options` name, prints what they ask for,
/// and returns the exit status. Throws UsageError, InputError, std::runtime_error.
int renderScene(const Options& options);

/// Reads the scene and renders the outputs that `options` name, without writing them. Prints the
/// scene's warnings unless -quiet is given. Throws InputError, std::runtime_error.
std::vector<Output> renderPictures(const Options& options);
