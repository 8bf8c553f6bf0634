// The renderer.
//
// A picture is rendered tile by tile, in one pass or two. Where a pixel is the colour of the ray
// through its centre, a tile is one table of rays, and colour, depth, normals and materials all
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
#include <functional>
#include <mutex>

#include "render/film.h"
#include "render/sample_tracing.h"
#include "render/tiles.h"
#include "render/watched_tracer.h"
#include "render/wave_tracer.h"

namespace {

/// The side of a tile of central rays, which are one table; of fewer where there are few tiles.
constexpr int kCentralSide = 2 * kTileSide;
static_assert(kCentralSide * kCentralSide <= RayTable::kMost);
/// Fewer tiles would not keep all threads busy.
constexpr int kTilesPerThread = 4;
/// Where rays are counted, tiles are small enough for so many threads, however many there are.
constexpr int kCountedThreads = 16;

const Image* anyOf(const RenderTargets& targets) {
  for (const Image* image : {targets.color, targets.depth, targets.normals}) {
    if (image) return image;
  }
  return targets.materials;
}

/// The size of the pictures in pixels. One target is given at least.
Vec2<int> sizeOf(const RenderTargets& targets) {
  const Image* const image = anyOf(targets);
  const Image& given = image ? *image : *targets.samples;
  const int zoom = image ? 1 : targets.samplesZoom;
  return {given.Width() / zoom, given.Height() / zoom};
}

/// What the camera sees: the whole picture, which the targets may be a window of.
PictureView viewOf(const SceneParser& scene, const PixelPlaces& places,
                   const RenderTargets& targets) {
  const Vec2<int> size = sizeOf(targets);
  const PictureWindow& window = targets.window;
  if (window.width > 0) return {*scene.getCamera(), places, window.width, window.height};
  return {*scene.getCamera(), places, size.x(), size.y()};
}

/// True where colours come of samples, or the samples themselves are wanted.
bool isSampled(const RenderTargets& targets, const SamplingOptions& sampling) {
  return targets.samples || (targets.color && !sampling.isPlain());
}

void set(Image* image, FloatImage* exact, Pixel at, const Vec3f& color) {
  image->setPixel(at.i, at.j, color);  // clamps
  if (exact) exact->setPixel(at.i, at.j, color);
}

/// A pixel of the whole picture where the targets hold it.
Pixel inTargets(const RenderTargets& targets, Pixel at) {
  return {at.i - targets.window.left, at.j - targets.window.bottom};
}

/// Once through all tiles.
struct Pass {
  RenderTargets targets;  // those that it fills, and no other
  Tiling tiling;
  double raysOfPixel;  // as many as can be foretold: what an adaptive sampler adds is not known
  std::function<void(WaveTracer& tracer, const PixelRectangle& area)> renderTile;
};

/// 1 at depthMin, 0 at depthMax, and on beyond them; what is not hit lies infinitely far.
Vec3f depthColor(const RenderTargets& targets, const Hit& hit) {
  const float grey = float((targets.depthMax - hit.getT()) / (targets.depthMax - targets.depthMin));
  return {grey, grey, grey};
}

Vec3f normalColor(const RenderTargets& targets, const Vec3f& n) {
  if (targets.hasSignedNormals) return (n + Vec3f(1, 1, 1)) * 0.5f;
  return {std::fabs(n.x()), std::fabs(n.y()), std::fabs(n.z())};
}

/// What the central ray has hit, in the pictures of surfaces.
void setSurface(const RenderTargets& targets, const Hit& hit, Pixel at) {
  const bool found = hit.getT() < Hit().getT();
  if (targets.depth) {
    targets.depth->setPixel(at.i, at.j, found ? depthColor(targets, hit) : Vec3f());
    if (targets.exactDepth) targets.exactDepth->setPixel(at.i, at.j, depthColor(targets, hit));
  }
  if (targets.normals) {
    const Vec3f normal = found ? Vec3f(hit.getNormal()) : Vec3f();
    set(targets.normals, targets.exactNormals, at, normalColor(targets, normal));
  }
  if (targets.materials) {
    targets.materials->setPixel(at.i, at.j,
                                found ? materialColor(hit.getMaterial()->getNumber()) : Rgb8());
  }
}

/// Every picture but that of the samples, from the rays through the pixels' centres.
Pass centralPass(const PictureView& view, const RenderTargets& targets, Vec2<int> size,
                 int threads) {
  const auto renderTile = [=](WaveTracer& tracer, const PixelRectangle& area) {
    // All memory is the arena's: that of vectors, given back and taken anew for each tile, cost a
    // sixth of the time of a picture of three objects.
    Arena& arena = tracer.arena();
    const Arena::Frame frame(arena);
    auto* samples = arena.take<Sample>(area.pixelCount());
    int count = 0;
    visitInOrder(area.moved(targets.window.left, targets.window.bottom), [&](Pixel at) {
      samples[count++] = {at, {0.5, 0.5}};
    });
    WaveRays rays(arena, count, false);
    setEyeRays(view, samples, count, tracer, rays);
    HitTable hits(arena, count);
    auto* colors = arena.take<Vec3f>(area.pixelCount());
    targets.color ? tracer.trace(rays, 0, hits, colors) : tracer.intersect(rays, hits);
    const bool hasSurfaces = targets.depth || targets.normals || targets.materials;
    for (int k = 0; k < count; ++k) {
      const Pixel at = inTargets(targets, samples[k].at);
      if (targets.color) set(targets.color, targets.exactColor, at, colors[k]);
      if (hasSurfaces) setSurface(targets, hits.hitOf(k, rays.tmax[k]), at);
    }
  };
  Tiling tiling = {size.x(), size.y(), kCentralSide};
  if (tiling.count() / kTilesPerThread < threads) tiling.side = kTileSide;
  return {targets, tiling, 1, renderTile};
}

/// Tiles for samples: 32 times as long as the margin of pixels around them that are traced too, up
/// to 128 pixels, so that the margins are few; less where so many first samples could not be kept,
/// or where there would be too few tiles to keep all threads busy.
Tiling tilingOf(Vec2<int> size, const Sampler& sampler, int reach, int threads) {
  constexpr int kMostSquares = 8;
  constexpr std::size_t kMostBytes = 32 << 20;
  const int margin = reach + int(sampler.isAdaptive());
  const auto isTooLarge = [&](const Tiling& tiling) {
    const auto side = std::size_t(tiling.side + 2 * margin);
    const std::size_t samples = side * side * std::size_t(sampler.getNumFirst());
    const bool tooMany = sampler.isAdaptive() && samples * kBytesPerSample > kMostBytes;
    return tooMany || tiling.count() / kTilesPerThread < threads;
  };
  Tiling tiling = {size.x(), size.y(), kTileSide * std::clamp(2 * margin, 1, kMostSquares)};
  while (tiling.side > kTileSide && isTooLarge(tiling)) tiling.side -= kTileSide;
  return tiling;
}

/// Colours from samples, and the picture of the samples. Tiles are small enough to be shared by so
/// many threads.
Pass sampledPass(const PictureView& view, const RenderTargets& targets, Vec2<int> size,
                 const SamplingOptions& options, int threads) {
  const Sampler sampler(options, view.height);
  const Filter filter(options);
  const int reach = targets.color ? filter.getSupportRadius() : 0;  // of samples that count
  const auto renderTile = [=](WaveTracer& tracer, const PixelRectangle& area) {
    const PixelRectangle inPicture = area.moved(targets.window.left, targets.window.bottom);
    const PixelRectangle whole = {0, 0, view.width, view.height};
    Film film(inPicture, filter, whole);
    if (targets.samples) drawSamplesGround(*targets.samples, targets.samplesZoom, area);
    const auto take = [&](const Sample& sample, const Vec3f& color, double share) {
      film.addSample(sample, color, share);
      if (targets.samples && area.contains(sample.at)) {
        drawSample(*targets.samples, targets.samplesZoom, sample, color);
      }
    };
    const PixelRectangle around = inPicture.grown(reach);
    takeSamples({view, tracer, sampler, options.tolerance},
                options.hasBorderSamples ? around : around.within(whole), take);
    if (!targets.color) return;
    for (const Pixel at : pixelsInOrder(inPicture)) {
      set(targets.color, targets.exactColor, inTargets(targets, at), film.getColor(at));
    }
  };
  const Tiling tiling = tilingOf(size, sampler, reach, threads);
  return {targets, tiling, double(options.samples), renderTile};
}

/// One pass, or two. `threads` are those that tiles are to be small enough for.
std::vector<Pass> passesOf(const PictureView& view, const RenderTargets& targets,
                           const SamplingOptions& options, int threads) {
  const Vec2<int> size = sizeOf(targets);
  if (!isSampled(targets, options)) return {centralPass(view, targets, size, threads)};
  RenderTargets sampled = targets, central = targets;
  sampled.depth = sampled.normals = sampled.materials = nullptr;
  sampled.exactDepth = sampled.exactNormals = nullptr;
  central.color = central.samples = nullptr;
  central.exactColor = nullptr;
  std::vector<Pass> passes = {sampledPass(view, sampled, size, options, threads)};
  if (anyOf(central)) passes.push_back(centralPass(view, central, size, threads));
  return passes;
}

/// Renders all tiles of a pass but those that are stored. Each thread counts its rays, if they are
/// to be counted, with a tracer of its own.
void renderTiles(const Pass& pass, const RayTracer& tracer, int threads, RayCounts* counts) {
  const RenderTargets& targets = pass.targets;
  const RenderOptions& options = tracer.shader().options();
  std::mutex mutex;  // guards *counts
  shareTiles(pass.tiling, options, threads, [&](const NextTile& next) {
    RayCounts own;
    const WatchedTracer counting(tracer.scene(), tracer.geometry(), options, own);
    WaveTracer waves(counts ? counting : tracer, counts ? &own : nullptr);
    while (const auto area = next()) {
      if (!targets.store || !targets.store->isFinished(targets, *area)) {
        pass.renderTile(waves, *area);
        if (targets.store) targets.store->finish(targets, *area);
      }
      if (!targets.listener) continue;
      targets.listener->tileIsDone(*area, pass.raysOfPixel * double(area->pixelCount()));
    }
    const std::lock_guard<std::mutex> lock(mutex);
    if (counts) counts->add(own);
  });
}

}  // namespace

void render(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
            int threads, const RenderTargets& targets, RayCounts* counts) {
  const RayTracer tracer(scene, geometry, options);
  const PictureView view = viewOf(scene, options.places, targets);
  // Rays around a tile are traced again: to count the same, tiles must have the same size.
  const int tileThreads = counts ? kCountedThreads : threads;
  const std::vector<Pass> passes = passesOf(view, targets, options.sampling, tileThreads);
  double eyeRays = 0;
  for (const Pass& pass : passes) {
    eyeRays += double(pass.tiling.width) * pass.tiling.height * pass.raysOfPixel;
  }
  if (targets.listener) targets.listener->begins(eyeRays);
  for (const Pass& pass : passes) renderTiles(pass, tracer, threads, counts);
}
