// The renderer.
//
// A picture is rendered tile by tile, in one pass or two. Where a pixel is the colour of the ray
// through its centre, a tile is one batch of rays, and colour, depth, normals and materials all
// come of what they hit. Where a pixel is made of samples, colours have a pass of their own, and
// the central rays follow for the other pictures.
//
// A tile of samples is computed from its own pixels and those around it that the filter reaches;
// these are traced again for each tile, so that memory does not grow with the picture. Samples are
// added in an order of the whole plane (that of pixelsInOrder, those of a pixel by number), so no
// byte depends on where tiles begin or end.
#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "render/film.h"
#include "render/sample_tracing.h"
#include "render/tiles.h"
#include "render/watched_tracer.h"
#include "render/wave_tracer.h"

namespace {

static_assert(kTileSide * kTileSide <= kBatchSize, "a tile of central rays is one batch");
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

/// What the camera sees: the whole picture, which the targets, of `size`, may be a window of.
PictureView viewOf(const SceneParser& scene, const PictureWindow& window, Vec2<int> size) {
  if (window.width > 0) return {*scene.getCamera(), window.width, window.height};
  return {*scene.getCamera(), size.x(), size.y()};
}

/// True where colours come of samples, or the samples themselves are wanted.
bool isSampled(const RenderTargets& targets, const SamplingOptions& sampling) {
  return targets.samples || (targets.color && !sampling.isPlain());
}

RenderTargets samplesAmong(const RenderTargets& targets) {
  RenderTargets some = targets;
  some.depth = some.normals = some.materials = nullptr;
  some.exactDepth = some.exactNormals = nullptr;
  return some;
}

RenderTargets surfacesAmong(const RenderTargets& targets) {
  RenderTargets some = targets;
  some.color = some.samples = nullptr;
  some.exactColor = nullptr;
  return some;
}

void set(Image* image, FloatImage* exact, Pixel at, const Vec3f& color) {
  image->setPixel(at.i, at.j, color);  // clamps
  if (exact) exact->setPixel(at.i, at.j, color);
}

/// Every picture but that of the samples, from the rays through the pixels' centres.
class CentralRenderer {
 public:
  CentralRenderer(const PictureView& view, const RenderTargets& targets, Vec2<int> size)
      : view_(view), targets_(targets), size_(size) {}

  Tiling tiling() const { return {size_.x(), size_.y(), kTileSide}; }
  double raysOfPixel() const { return 1; }

  void renderTile(const WaveTracer& tracer, const PixelRectangle& area) const {
    const std::vector<Pixel> pixels = pixelsInOrder(area);
    RayBatch rays(pixels.size());
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const Pixel inPicture = {targets_.window.left + pixels[k].i,
                               targets_.window.bottom + pixels[k].j};
      view_.setEyeRay({inPicture, {0.5, 0.5}}, rays[k]);
    }
    Hit hits[kBatchSize];
    if (targets_.color) {
      Vec3f colors[kBatchSize];
      tracer.trace(rays, 0, hits, colors);
      for (std::size_t k = 0; k < pixels.size(); ++k) {
        set(targets_.color, targets_.exactColor, pixels[k], colors[k]);
      }
    } else {
      tracer.intersect(rays, hits);
    }
    for (std::size_t k = 0; k < pixels.size(); ++k) setSurface(hits[k], pixels[k]);
  }

 private:
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

  /// 1 at depthMin, 0 at depthMax, and on beyond them.
  Vec3f depthColor(const Hit& hit) const {
    const double span = targets_.depthMax - targets_.depthMin;
    const float grey = float((targets_.depthMax - hit.getT()) / span);
    return {grey, grey, grey};
  }

  static Vec3f normalColor(const Hit& hit) {
    const Vec3f n(hit.getNormal());
    return {std::fabs(n.x()), std::fabs(n.y()), std::fabs(n.z())};
  }

  const PictureView view_;
  const RenderTargets targets_;
  const Vec2<int> size_;
};

/// Colours from samples, and the picture of the samples.
class SampledRenderer {
 public:
  /// Tiles are small enough to be shared by so many threads.
  SampledRenderer(const PictureView& view, const RenderTargets& targets, Vec2<int> size,
                  const SamplingOptions& options, int threads)
      : view_(view),
        targets_(targets),
        size_(size),
        options_(options),
        threads_(threads),
        sampler_(makeSampler(options)),
        filter_(options.filter, options.filterSize),
        reach_(targets.color ? filter_.getSupportRadius() : 0) {}

  double raysOfPixel() const { return options_.samples; }

  /// Tiles 32 times as long as the margin of pixels around them that are traced too, up to 128
  /// pixels, so that the margins are few; less where so many first samples could not be kept, or
  /// where there would be too few tiles to keep all threads busy.
  Tiling tiling() const {
    constexpr int kMostSquares = 8, kTilesPerThread = 4;
    constexpr std::size_t kMostBytes = 32 << 20;
    const int margin = reach_ + int(sampler_->isAdaptive());
    const auto isTooLarge = [&](const Tiling& tiling) {
      const auto side = std::size_t(tiling.side + 2 * margin);
      const std::size_t samples = side * side * std::size_t(sampler_->getNumFirst());
      const bool tooMany = sampler_->isAdaptive() && samples * kBytesPerSample > kMostBytes;
      return tooMany || tiling.count() / kTilesPerThread < threads_;
    };
    Tiling tiling = {size_.x(), size_.y(), kTileSide * std::clamp(2 * margin, 1, kMostSquares)};
    while (tiling.side > kTileSide && isTooLarge(tiling)) tiling.side -= kTileSide;
    return tiling;
  }

  void renderTile(const WaveTracer& tracer, const PixelRectangle& area) const {
    const PixelRectangle inPicture = area.moved(targets_.window.left, targets_.window.bottom);
    Film film(inPicture, filter_);
    if (targets_.samples) drawSamplesGround(*targets_.samples, targets_.samplesZoom, area);
    const auto take = [&](const Sample& sample, const Vec3f& color, double share) {
      film.addSample(sample, color, share);
      if (targets_.samples && area.contains(sample.at)) {
        drawSample(*targets_.samples, targets_.samplesZoom, sample, color);
      }
    };
    takeSamples({view_, tracer, *sampler_, options_.tolerance}, inPicture.grown(reach_), take);
    if (!targets_.color) return;
    for (const Pixel at : pixelsInOrder(inPicture)) {
      const Pixel inTargets = {at.i - targets_.window.left, at.j - targets_.window.bottom};
      set(targets_.color, targets_.exactColor, inTargets, film.getColor(at));
    }
  }

 private:
  const PictureView view_;
  const RenderTargets targets_;
  const Vec2<int> size_;
  const SamplingOptions options_;
  const int threads_;
  const std::unique_ptr<const Sampler> sampler_;
  const Filter filter_;
  const int reach_;  // pixels beyond a tile whose samples count in it
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

/// Renders all tiles for `targets` on so many threads, but those that are stored.
template <class Renderer>
void renderTiles(const Renderer& renderer, const RayTracer& tracer,
                 const std::vector<WorkerView>& views, const RenderTargets& targets, int threads) {
  const auto renderSome = [&](int thread, TileQueue& queue) {
    const ThreadTracer own(tracer, views.empty() ? nullptr : &views[std::size_t(thread)]);
    while (const auto area = queue.take()) {
      if (!targets.store || !targets.store->isFinished(targets, *area)) {
        renderer.renderTile(own.waves(), *area);
        if (targets.store) targets.store->finish(targets, *area);
      }
      if (!targets.listener) continue;
      targets.listener->tileIsDone(*area, renderer.raysOfPixel() * double(area->pixelCount()));
    }
  };
  shareTiles(renderer.tiling(), tracer.shader().options(), threads, renderSome);
}

}  // namespace

void render(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
            int threads, const RenderTargets& targets, const std::vector<WorkerView>& views) {
  const RayTracer tracer(scene, geometry, options);
  const Vec2<int> size = sizeOf(targets);
  const PictureView view = viewOf(scene, targets.window, size);
  const bool hasSamples = isSampled(targets, options.sampling);
  const RenderTargets sampled = samplesAmong(targets);
  const RenderTargets central = hasSamples ? surfacesAmong(targets) : targets;
  // Rays around a tile are traced again: to count the same, tiles must have the same size.
  const int tileThreads = views.empty() ? threads : kCountedThreads;
  const SampledRenderer samples(view, sampled, size, options.sampling, tileThreads);
  const CentralRenderer centres(view, central, size);
  if (targets.listener) {
    // As many rays as can be foretold: how many an adaptive sampler adds is not known.
    const double ofSamples = hasSamples ? samples.raysOfPixel() : 0;
    const double ofCentres = anyOf(central) ? centres.raysOfPixel() : 0;
    targets.listener->begins(double(size.x()) * size.y() * (ofSamples + ofCentres));
  }
  if (hasSamples) renderTiles(samples, tracer, views, sampled, threads);
  if (anyOf(central)) renderTiles(centres, tracer, views, central, threads);
}
