// The renderer.
//
// A picture is rendered tile by tile. Where a pixel is the colour of the ray through its centre,
// the central rays of a tile, in squares that are a table each, give colour, depth, normals and
// materials all at once. Where a pixel is made of samples, its colour comes of them, and its
// central ray follows where other pictures are wanted.
//
// A tile of samples is computed from its own pixels and those around it that the filter reaches;
// these are traced again for each tile, so that memory does not grow with the picture. Samples are
// added in an order of the whole plane (that of pixelsInOrder, those of a pixel by number), so no
// byte depends on where tiles begin or end.
#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "render/false_colors.h"
#include "render/film.h"
#include "render/sample_tracing.h"
#include "render/tiles.h"
#include "render/watched_tracer.h"

namespace {

/// The side of a square of central rays, which are one table.
constexpr int kCentralSide = 2 * kTileSide;
static_assert(kCentralSide * kCentralSide <= RayTable::kMost);
/// Where rays are counted, tiles are small enough for so many threads, however many there are: rays
/// around a tile are traced again, so to count the same, tiles must have the same size.
constexpr int kCountedThreads = 16;

/// Squares of central rays, or more for samples: 32 times as long as the margin of pixels around
/// them that are traced too, up to 128 pixels, so that the margins are few; less where so many
/// first samples could not be kept, or where there would be too few tiles to keep all threads busy.
Tiling tilingOf(Vec2<int> size, const Sampler& sampler, int reach, int threads) {
  constexpr int kMostSquares = 8, kTilesPerThread = 4;
  constexpr std::size_t kMostBytes = 32 << 20;
  const int margin = reach + int(sampler.isAdaptive());
  const auto isTooLarge = [&](const Tiling& tiling) {
    const std::size_t side = std::size_t(tiling.side) + 2 * std::size_t(margin);
    const std::size_t samples = side * side * std::size_t(sampler.getNumFirst());
    const bool tooMany = sampler.isAdaptive() && samples * kBytesPerSample > kMostBytes;
    return tooMany || tiling.count() / kTilesPerThread < threads;
  };
  Tiling tiling = {size.x(), size.y(), kTileSide * std::clamp(2 * margin, 2, kMostSquares)};
  while (tiling.side > kTileSide && isTooLarge(tiling)) tiling.side -= kTileSide;
  return tiling;
}

void set(Image* image, FloatImage* exact, Pixel at, const Vec3f& color) {
  image->setPixel(at.i, at.j, color);  // clamps
  if (exact) exact->setPixel(at.i, at.j, color);
}

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

/// What the camera sees: the whole picture, which the targets may be a window of.
PictureView viewOf(const RayTracer& tracer, const RenderTargets& targets) {
  const PictureWindow& window = targets.window;
  const Vec2<int> whole(window.width, window.height);
  const Vec2<int> size = window.width > 0 ? whole : targets.size();
  return {*tracer.scene().getCamera(), tracer.options().places, size.x(), size.y()};
}

/// What all tiles of a picture have in common. Nothing is owned.
class Rendering {
 public:
  /// Tiles are small enough to be shared by `threads` threads.
  Rendering(const RayTracer& tracer, const RenderTargets& targets, int threads)
      : targets_(targets),
        view_(viewOf(tracer, targets)),
        sampler_(tracer.options().sampling, view_.height),
        filter_(sampler_.options()),
        isSampled_(targets.samples || (targets.color && !sampler_.options().isPlain())),
        reach_(isSampled_ && targets.color ? filter_.getSupportRadius() : 0),
        tiling_(tilingOf(targets.size(), sampler_, reach_, threads)) {}

  const Tiling& tiling() const { return tiling_; }
  /// As many as can be foretold: what an adaptive sampler adds is not known.
  double raysOfPixel() const {
    return (isSampled_ ? sampler_.options().samples : 0) + (hasCentral() ? 1 : 0);
  }

  void renderTile(WaveTracer& tracer, const PixelRectangle& area) const {
    if (isSampled_) takeSampled(tracer, area);
    if (!hasCentral()) return;
    const Tiling squares = {area.width(), area.height(), kCentralSide};
    for (int k = 0; k < squares.count(); ++k) {
      takeCentral(tracer, squares.areaOf(k).moved(area.left, area.bottom));
    }
  }

 private:
  bool hasSurfaces() const { return targets_.depth || targets_.normals || targets_.materials; }
  bool hasCentral() const { return !isSampled_ || hasSurfaces(); }
  PixelRectangle inPicture(const PixelRectangle& area) const {
    return area.moved(targets_.window.left, targets_.window.bottom);
  }
  /// A pixel of the whole picture where the targets hold it.
  Pixel inTargets(Pixel at) const {
    return {at.i - targets_.window.left, at.j - targets_.window.bottom};
  }

  /// Colours from samples, and the picture of the samples.
  void takeSampled(WaveTracer& tracer, const PixelRectangle& area) const {
    const PixelRectangle inside = inPicture(area), whole = {0, 0, view_.width, view_.height};
    Film film(inside, filter_, whole);
    if (targets_.samples) drawSamplesGround(*targets_.samples, targets_.samplesZoom, area);
    const auto take = [&](const Sample& sample, const Vec3f& color, double share) {
      film.addSample(sample, color, share);
      if (targets_.samples && area.contains(sample.at)) {
        drawSample(*targets_.samples, targets_.samplesZoom, sample, color);
      }
    };
    const PixelRectangle around = inside.grown(reach_);
    const bool isCut = !sampler_.options().hasBorderSamples;
    takeSamples({view_, tracer, sampler_}, isCut ? around.within(whole) : around, take);
    if (!targets_.color) return;
    for (const Pixel at : pixelsInOrder(inside)) {
      set(targets_.color, targets_.exactColor, inTargets(at), film.getColor(at));
    }
  }

  /// All else, from the rays through the pixels' centres. All memory is the arena's: that of
  /// vectors, given back and taken anew, cost a sixth of the time of a picture of three objects.
  void takeCentral(WaveTracer& tracer, const PixelRectangle& area) const {
    const Arena::Frame frame(tracer.arena());
    auto* samples = tracer.arena().take<Sample>(area.pixelCount());
    int count = 0;
    visitInOrder(inPicture(area), [&](Pixel at) { samples[count++] = {at, {0.5, 0.5}}; });
    const bool wantsColors = targets_.color && !isSampled_;
    const TracedSamples traced(view_, tracer, samples, count, wantsColors);
    if (wantsColors) setColors(samples, traced.colors, count, tracer.arena());
    for (int k = 0; hasSurfaces() && k < count; ++k) {
      setSurface(targets_, traced.hitOf(k), inTargets(samples[k].at));
    }
  }

  /// The bytes of all colours first, which compilers then compute several at a time: 0.95 of the
  /// instructions of a picture of mirror balls.
  void setColors(const Sample* samples, const Vec3f* colors, int count, Arena& arena) const {
    auto* bytes = arena.take<Rgb8>(std::size_t(count));
    std::transform(colors, colors + count, bytes, bytesFromColor);
    for (int k = 0; k < count; ++k) {
      const Pixel at = inTargets(samples[k].at);
      targets_.color->setPixel(at.i, at.j, bytes[k]);
      if (targets_.exactColor) targets_.exactColor->setPixel(at.i, at.j, colors[k]);
    }
  }

  const RenderTargets& targets_;
  const PictureView view_;
  const Sampler sampler_;
  const Filter filter_;
  const bool isSampled_;  // colours come of samples, or the samples themselves are wanted
  const int reach_;       // of samples that count
  const Tiling tiling_;
};

}  // namespace

/// Each thread counts its rays, if they are to be counted, with a tracer of its own.
void render(const RayTracer& tracer, int threads, const RenderTargets& targets, RayCounts* counts) {
  const Rendering rendering(tracer, targets, counts ? kCountedThreads : threads);
  const Tiling& tiling = rendering.tiling();
  const double rays = rendering.raysOfPixel();
  if (targets.listener) targets.listener->begins(rays * tiling.width * tiling.height);
  std::mutex mutex;  // guards *counts
  shareTiles(tiling, tracer, threads, [&](const NextTile& next) {
    RayCounts own;
    const WatchedTracer counting(tracer, own);
    WaveTracer waves(counts ? counting : tracer, counts ? &own : nullptr);
    while (const auto area = next()) {
      if (!targets.store || !targets.store->isFinished(*area)) {
        rendering.renderTile(waves, *area);
        if (targets.store) targets.store->finish(*area);
      }
      if (!targets.listener) continue;
      targets.listener->tileIsDone(*area, rays * double(area->pixelCount()));
    }
    const std::lock_guard<std::mutex> lock(mutex);
    if (counts) counts->add(own);
  });
}
