// Inspection: what a run tells besides its pictures: how long it took and how many rays there were
// (-stats), how many rays each pixel takes (-heatmap), and all that becomes of one ray (-pixel,
// -pixel_obj).
#pragma once
#include <string>
#include <vector>

#include "accel/test_tally.h"
#include "cli/outputs.h"
#include "render/ray_counts.h"
#include "scene/object_places.h"

/// What -stats prints.
struct Stats {
  std::string simd, tree;  ///< SceneGeometry's simd() and description()
  double readSeconds = 0, buildSeconds = 0, traceSeconds = 0, writeSeconds = 0;

  RayCounts rays;
  RayTestCounts tests;  ///< not filled where cells are drawn

  /// A line `name: value` for each entry, in a fixed order, each with its end; of this picture.
  /// `pictureBytes` is the memory of textures and cube maps.
  std::string text(const PictureRequest& picture, int threads, std::size_t pictureBytes) const;
};

/// Draws the heat map in its output and stores its scale there, where `outputs` has it.
void drawHeatmap(const RayTracer& tracer, const RunRequest& run, std::vector<Output>& outputs);

/// Writes the tree of the pixel's rays to standard output, as far as that takes it (the caller
/// looks at ferror(stdout)), and stores their lines where `outputs` has them. Returns what is to be
/// printed last: the pixel's colour in numbers and in bytes, or "" where no pixel is asked for.
/// `places` says where the objects stand in the scene's file.
std::string inspectPixel(const RayTracer& tracer, const ObjectPlaces& places,
                         const RenderRequest& render, std::vector<Output>& outputs);
