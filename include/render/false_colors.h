// Pictures in false colours: which material a pixel shows, and how many rays it takes (a heat map).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "image/image.h"
#include "render/renderer.h"

/// The colour of the material of that number: red, green, yellow, blue, magenta, cyan, white, then
/// darker and mixed ones. The first 2^24 - 1 are all different, and none is black; then they begin
/// again. Below 0, where no scene has read the material: grey, (128, 128, 128).
Rgb8 materialColor(int number);

/// What `picture` shows: a line for each material of the scene whose colour is in it, by number:
/// "material 2: 255 255 0, PhongMaterial, 1234 pixels".
std::string materialLegend(const SceneParser& scene, const Image& picture);

/// The rays of each pixel's own samples, shadow rays too, row by row from the lowest: the central
/// ray and all that come of it, or those of all the samples in the pixel. Counts stop at 2^32 - 1.
/// Every ray is traced once more for this. The picture has at least 1 x 1 pixels. `threads` >= 1
/// and the form of the tracer's geometry never change a number. `listener`, where not null, is told
/// how far it is, in rays that samples begin with.
std::vector<std::uint32_t> countRays(const RayTracer& tracer, int threads, int width, int height,
                                     TileListener* listener = nullptr);

/// Draws the counts in `picture`, which has as many pixels, at least one: in proportion to the
/// largest count, from black (0) through blue, green and yellow to red. Returns the scale in words,
/// two lines.
std::string drawHeatmap(const std::vector<std::uint32_t>& counts, Image& picture);
