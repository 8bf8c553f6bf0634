// Inspection: what a run finds out besides the pictures that rays make: how many rays each pixel
// takes (-heatmap), and all that becomes of one ray (-pixel, -pixel_obj).
#pragma once
#include <string>
#include <vector>

#include "cli/outputs.h"
#include "cli/request.h"
#include "scene/object_places.h"
#include "scene/scene_parser.h"

/// True where any of it is wanted.
bool wantsInspection(const ResultRequest& results);

/// The scene, where its objects stand in its file (filled where a pixel is traced), and what
/// answers for them. Nothing is owned.
struct InspectedScene {
  const SceneParser& scene;
  const ObjectPlaces& places;
  const Object3D& geometry;
};

/// Draws the heat map in its output and stores its scale there, where `outputs` has it.
void drawHeatmap(const InspectedScene& inspected, const PictureRequest& picture,
                 const RunRequest& run, std::vector<Output>& outputs);

/// Writes the tree of the pixel's rays to standard output, as far as that takes it (the caller
/// looks at ferror(stdout)), and stores their lines where `outputs` has them. Returns what is to be
/// printed last: the pixel's colour in numbers and in bytes, or "" where no pixel is asked for.
std::string inspectPixel(const InspectedScene& inspected, const RenderRequest& render,
                         std::vector<Output>& outputs);

/// What the pictures among `outputs` mean, in lines: the materials that -materials shows and the
/// scale of -heatmap; "" where neither is there.
std::string legendOf(const SceneParser& scene, const std::vector<Output>& outputs);
