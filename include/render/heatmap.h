// The heat map: how many rays each pixel takes.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/object3d.h"
#include "image/image.h"
#include "render/render_options.h"
#include "render/tile_hooks.h"
#include "scene/scene_parser.h"

/// The rays of each pixel's own samples, shadow rays too, row by row from the lowest: the central
/// ray and all that come of it, or those of all the samples in the pixel. Counts stop at 2^32 - 1.
/// Every ray is traced once more for this. The picture has at least 1 x 1 pixels. `threads` >= 1
/// and the form of `geometry`, which answers for the scene's objects, never change a number.
/// `listener`, where not null, is told how far it is, in rays that samples begin with.
std::vector<std::uint32_t> countRays(const SceneParser& scene, const Object3D& geometry,
                                     const RenderOptions& options, int threads, int width,
                                     int height, TileListener* listener = nullptr);

/// Draws the counts in `picture`, which has as many pixels, at least one: in proportion to the
/// largest count, from black (0) through blue, green and yellow to red. Returns the scale in words,
/// two lines.
std::string drawHeatmap(const std::vector<std::uint32_t>& counts, Image& picture);
