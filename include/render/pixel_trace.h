// One pixel of a picture, traced on its own.
#pragma once
#include <vector>

#include "geometry/object3d.h"
#include "render/ray_observer.h"
#include "render/render_options.h"
#include "scene/scene_parser.h"

/// A pixel, counted from 0 from the lower left corner, of a picture of width x height.
struct PixelOfPicture {
  int width, height, i, j;
};

struct PixelColors {
  Vec3f centralRay;  ///< what arrives along the ray through the pixel's centre
  Vec3f pixel;  ///< the picture's colour there; the same where RenderOptions::sampling is plain
};

/// Traces the central ray of a pixel, telling `observers` of it, and then what else the pixel's
/// colour depends on: to the last bit that of a whole picture. `geometry` answers for the scene's
/// objects. Takes a thread of its own, for as much stack as the bounces need.
PixelColors tracePixel(const SceneParser& scene, const Object3D& geometry,
                       const RenderOptions& options, const PixelOfPicture& place,
                       const std::vector<RayObserver*>& observers);
