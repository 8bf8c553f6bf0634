// The renderer: casts one ray through the centre of every pixel, in tiles, on several threads.
#pragma once
#include <vector>

#include "geometry/object3d.h"
#include "image/image.h"
#include "render/ray_observer.h"
#include "render/render_options.h"
#include "scene/scene_parser.h"

/// The pictures wanted; null where one is not. All that are given have the same size. Not owned.
struct RenderTargets {
  Image* color = nullptr;
  Image* depth = nullptr;
  Image* normals = nullptr;
  /// The t that is white and the t that is black in the depth image; they differ.
  double depthMin = 0, depthMax = 1;
};

/// What one worker thread asks and whom it tells, where threads are to be watched: `geometry`
/// answers as the common one does, `observer` may be null. Not owned.
struct WorkerView {
  const Object3D* geometry;
  RayObserver* observer;
};

/// Fills the targets with the scene as its camera sees it, `geometry` (the scene's group, or a
/// compiled form of it) answering for its objects. `threads` >= 1 never changes a byte. At least
/// one target must be given; each pixel's ray is cast once however many there are. `views` is empty
/// or holds one for each thread. Throws what a worker thread throws (std::bad_alloc,
/// std::system_error).
void render(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
            int threads, const RenderTargets& targets, const std::vector<WorkerView>& views = {});
