// Which of a run's pictures the renderer fills.
#pragma once
#include <vector>

#include "cli/outputs.h"
#include "cli/request.h"
#include "render/renderer.h"

/// Where the pictures go that the renderer fills. Where there is none and -stats needs one, or
/// -preview has nothing else to show, it is `unwritten`, which then gets an image of its size. What
/// is returned points into both.
RenderTargets targetsOf(const RenderRequest& render, std::vector<Output>& outputs,
                        Image& unwritten);

/// False where the renderer has nothing to do.
bool wantsRays(const RenderTargets& targets);

/// The heat map, or else the picture of the filter, which the renderer does not fill; null where
/// neither is among the outputs.
const Image* untracedPicture(const std::vector<Output>& outputs);
