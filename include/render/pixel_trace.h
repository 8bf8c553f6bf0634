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

/// Tells each of the observers, one after the other, what becomes of the ray through the pixel's
/// centre. Returns the pixel's colour, which its other samples may have a share in: to the last bit
/// that of a whole picture, unclamped. `geometry` answers for the scene's objects. Traces on a
/// thread of its own, for as much stack as the bounces need.
Vec3f tracePixel(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
                 const PixelOfPicture& place, const std::vector<RayObserver*>& observers);
