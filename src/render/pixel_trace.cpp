// One pixel: the ray through its centre for those who watch, and a picture of this pixel alone.
#include "render/pixel_trace.h"

#include "image/float_image.h"
#include "render/renderer.h"
#include "render/tiles.h"
#include "render/watched_tracer.h"

namespace {

/// Traces the ray through the pixel's centre once for each observer: what one of them is told does
/// not depend on who else is there.
void traceCentralRay(const SceneParser& scene, const Object3D& geometry,
                     const RenderOptions& options, const PixelOfPicture& place,
                     const std::vector<RayObserver*>& observers) {
  const Camera& camera = *scene.getCamera();
  for (RayObserver* const observer : observers) {
    Ray ray =
        camera.generateRay(imagePoint(place.i + 0.5, place.j + 0.5, place.width, place.height));
    Hit hit;
    WatchedTracer(scene, geometry, options, *observer)
        .traceRay(ray, float(camera.getTMin()), 0, 1, 1, hit);
  }
}

}  // namespace

Vec3f tracePixel(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
                 const PixelOfPicture& place, const std::vector<RayObserver*>& observers) {
  runOnThreads(1, tracingStack(options),
               [&](int) { traceCentralRay(scene, geometry, options, place, observers); });
  // The renderer gives a pixel of a window the very colour that it has in the whole picture.
  Image pixel(1, 1);
  FloatImage color(1, 1);
  RenderTargets targets;
  targets.color = &pixel;
  targets.exactColor = &color;
  targets.window = {place.i, place.j, place.width, place.height};
  render(scene, geometry, options, 1, targets);
  return color.getPixel(0, 0);
}
