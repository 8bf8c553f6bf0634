// The renderer: tiles are handed out one by one, so that no thread waits for a slow one.
#include "render/renderer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "render/image_plane.h"
#include "render/sampled_renderer.h"
#include "render/tiles.h"
#include "render/watched_tracer.h"
#include "render/wave_tracer.h"
#include "system/worker_threads.h"

namespace {

constexpr int kTileSize = 16, kTilePixels = kTileSize * kTileSize;
static_assert(kTilePixels <= kBatchSize, "a tile is one batch");
/// Where rays are counted, tiles are small enough for so many threads, however many there are.
constexpr int kCountedThreads = 16;

const Image* anyOf(const RenderTargets& targets) {
  for (const Image* image : {targets.color, targets.depth, targets.normals}) {
    if (image) return image;
  }
  return targets.materials;
}

/// The size of the pictures in pixels.
Vec2<int> sizeOf(const RenderTargets& targets) {
  if (const Image* image = anyOf(targets)) return {image->Width(), image->Height()};
  const int zoom = targets.samplesZoom;
  // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): one target is given at least
  return {targets.samples->Width() / zoom, targets.samples->Height() / zoom};
}

/// The window, its width and height filled in where the targets are the whole picture.
PictureWindow windowOf(const RenderTargets& targets) {
  if (targets.window.width > 0) return targets.window;
  const Vec2<int> size = sizeOf(targets);
  return {0, 0, size.x(), size.y()};
}

class TileRenderer {
 public:
  TileRenderer(const SceneParser& scene, const WaveTracer& tracer, const RenderTargets& targets)
      : camera_(*scene.getCamera()),
        tracer_(tracer),
        targets_(targets),
        window_(windowOf(targets)),
        width_(sizeOf(targets).x()),
        height_(sizeOf(targets).y()) {}

  int tileCount() const { return columns() * rows(); }

  PixelRectangle areaOf(int tile) const {
    const int left = tile % columns() * kTileSize, bottom = tile / columns() * kTileSize;
    return {left, bottom, std::min(left + kTileSize, width_),
            std::min(bottom + kTileSize, height_)};
  }

  void renderTile(int tile) const {
    const PixelRectangle area = areaOf(tile);
    Pixel pixels[kTilePixels];
    RayBatch rays;
    rays.reserve(kTilePixels);
    int count = 0;
    for (int place = 0; place < kTilePixels; ++place) {
      const Pixel pixel = {area.left + evenBits(place), area.bottom + evenBits(place >> 1)};
      if (!area.contains(pixel)) continue;
      pixels[count++] = pixel;
      TracedRay& ray = rays.emplace_back();
      ray.ray = camera_.generateRay(centreOf(pixel));
      ray.tmin = camera_.getTMin();
    }
    Hit hits[kTilePixels];
    if (targets_.color) {
      setColors(rays, hits, pixels);
    } else {
      tracer_.intersect(rays, hits);
    }
    for (int k = 0; k < count; ++k) setSurface(hits[k], pixels[k]);
  }

 private:
  /// On the image plane.
  Vec2d centreOf(Pixel pixel) const {
    return imagePoint(window_.left + pixel.i + 0.5, window_.bottom + pixel.j + 0.5, window_.width,
                      window_.height);
  }

  int columns() const { return (width_ + kTileSize - 1) / kTileSize; }
  int rows() const { return (height_ + kTileSize - 1) / kTileSize; }

  void setColors(const RayBatch& rays, Hit* hits, const Pixel* pixels) const {
    Vec3f colors[kTilePixels];
    tracer_.trace(rays, 0, hits, colors);
    for (std::size_t k = 0; k < rays.size(); ++k) {
      set(targets_.color, targets_.exactColor, pixels[k], colors[k]);
    }
  }

  void setSurface(const Hit& hit, Pixel at) const {
    const bool found = hit.getT() < Hit().getT();
    if (targets_.depth) {
      set(targets_.depth, targets_.exactDepth, at, found ? depthColor(hit) : Vec3f());
    }
    if (targets_.normals) {
      set(targets_.normals, targets_.exactNormals, at, found ? normalColor(hit) : Vec3f());
    }
    if (targets_.materials) {
      targets_.materials->setPixel(at.i, at.j,
                                   found ? targets_.materialColors->of(hit.getMaterial()) : Rgb8());
    }
  }

  static void set(Image* image, FloatImage* exact, Pixel at, const Vec3f& color) {
    image->setPixel(at.i, at.j, color);  // clamps
    if (exact) exact->setPixel(at.i, at.j, color);
  }

  Vec3f depthColor(const Hit& hit) const {
    const double span = targets_.depthMax - targets_.depthMin;
    const float grey = float((targets_.depthMax - hit.getT()) / span);
    return {grey, grey, grey};
  }

  static Vec3f normalColor(const Hit& hit) {
    const Vec3f n(hit.getNormal());
    return {std::fabs(n.x()), std::fabs(n.y()), std::fabs(n.z())};
  }

  const Camera& camera_;
  const WaveTracer& tracer_;
  const RenderTargets targets_;
  const PictureWindow window_;
  const int width_, height_;  // of the targets
};

/// What one thread traces with: the tracer of all threads or, where rays are counted, one of its
/// own.
class ThreadTracer {
 public:
  /// `view` is null where nothing is counted. Nothing is owned.
  ThreadTracer(const RayTracer& common, const WorkerView* view)
      : counting_(view ? countingTracer(common, *view) : nullptr),
        waves_(counting_ ? *counting_ : common, view ? view->counts : nullptr) {}
  const WaveTracer& waves() const { return waves_; }

 private:
  static std::unique_ptr<const RayTracer> countingTracer(const RayTracer& common,
                                                         const WorkerView& view) {
    return std::make_unique<WatchedTracer>(common.scene(), *view.geometry,
                                           common.shader().options(), *view.counts);
  }

  const std::unique_ptr<const RayTracer> counting_;
  const WaveTracer waves_;
};

/// Rays for each pixel, as far as they can be foretold.
double raysOf(const RenderTargets& targets, const RenderOptions& options) {
  const bool isSampled = targets.samples || (targets.color && !options.sampling.isPlain());
  return isSampled ? options.sampling.samples : 1;
}

/// Those of the whole picture: a second pass for depth and normals has one for each pixel.
double allRaysOf(const RenderTargets& targets, const RenderOptions& options) {
  const Vec2<int> size = sizeOf(targets);
  RenderTargets central = targets;
  central.color = central.samples = nullptr;
  const double first = raysOf(targets, options);
  const bool isSecond = anyOf(central) && (targets.samples || !options.sampling.isPlain()) &&
                        (targets.samples || targets.color);
  return double(size.x()) * size.y() * (first + isSecond);
}

/// Renders all tiles for `targets` on so many threads, but those that are kept, each thread with a
/// renderer that makeRenderer(tracer) gives.
template <class MakeRenderer>
void renderTiles(const RayTracer& tracer, const std::vector<WorkerView>& views,
                 const RenderTargets& targets, int threads, const MakeRenderer& makeRenderer) {
  const RenderOptions& options = tracer.shader().options();
  const WaveTracer waves(tracer);
  const int tiles = makeRenderer(waves).tileCount();
  std::atomic<int> next{0};
  runOnThreads(std::min(threads, tiles), tracingStack(options), [&](int thread) {
    const ThreadTracer own(tracer, views.empty() ? nullptr : &views[std::size_t(thread)]);
    const auto renderer = makeRenderer(own.waves());
    for (int tile; (tile = next++) < tiles;) {
      const PixelRectangle area = renderer.areaOf(tile);
      if (!targets.store || !targets.store->isFinished(targets, area)) {
        renderer.renderTile(tile);
        if (targets.store) targets.store->finish(targets, area);
      }
      if (!targets.listener) continue;
      targets.listener->tileIsDone(area, raysOf(targets, options) * double(area.pixelCount()));
    }
  });
}

}  // namespace

void render(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
            int threads, const RenderTargets& targets, const std::vector<WorkerView>& views) {
  const RayTracer tracer(scene, geometry, options);
  RenderTargets central = targets;
  if (targets.listener) targets.listener->begins(allRaysOf(targets, options));
  if (targets.samples || (targets.color && !options.sampling.isPlain())) {
    const PictureWindow window = windowOf(targets);
    RenderTargets ofSamples = targets;
    ofSamples.depth = ofSamples.normals = nullptr;
    ofSamples.exactDepth = ofSamples.exactNormals = nullptr;
    // Rays around a tile are traced again: to count the same, tiles must have the same size.
    const int tileThreads = views.empty() ? threads : kCountedThreads;
    renderTiles(tracer, views, ofSamples, threads, [&](const WaveTracer& own) {
      return SampledRenderer({*scene.getCamera(), own, window.width, window.height},
                             options.sampling, ofSamples, sizeOf(targets), tileThreads);
    });
    central.color = central.samples = nullptr;
    central.exactColor = nullptr;
    if (!anyOf(central)) return;
  }
  renderTiles(tracer, views, central, threads,
              [&](const WaveTracer& own) { return TileRenderer(scene, own, central); });
}
