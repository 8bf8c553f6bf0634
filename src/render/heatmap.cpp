// The heat map.
//
// Rays are counted by an observer of the recursion that traces one ray after the other: batches mix
// those of many pixels. So every sample is traced on its own, and where it is the colours that say
// how many samples a pixel gets, those are found first, as for the picture.
#include "render/heatmap.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>

#include "render/ray_counts.h"
#include "render/report_words.h"
#include "render/sample_tracing.h"
#include "render/tiles.h"
#include "render/watched_tracer.h"

namespace {

/// What one thread counts with.
class SampleCounter {
 public:
  SampleCounter(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
                const PictureView& view)
      : view_(view), tracer_(scene, geometry, options, rays_) {}

  /// The rays that begin with the sample's eye ray.
  std::uint64_t raysOf(const Sample& sample) {
    const std::uint64_t before = rays_.total();
    traceAlone(view_, tracer_, sample);
    return rays_.total() - before;
  }

 private:
  const PictureView view_;
  RayCounts rays_;
  const WatchedTracer tracer_;  // tells rays_
};

/// Adds up, without going round.
void add(std::uint64_t rays, std::uint32_t& count) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  count = std::uint32_t(std::min(kMost, count + rays));
}

/// Calls count(sample) for each sample of the pixels in `area`.
template <class Count>
void forEachSample(const SampleSource& source, const PixelRectangle& area, const Count& count) {
  if (source.sampler.isAdaptive()) {
    return takeSamples(source, area,
                       [&](const Sample& sample, const Vec3f&, double) { count(sample); });
  }
  for (const Pixel at : pixelsInOrder(area)) {
    for (int n = 0; n < source.sampler.getNumSamples(); ++n) {
      count(Sample{at, source.sampler.getSamplePosition(at.i, at.j, n)});
    }
  }
}

/// The scale, its stops evenly spaced from no rays to the most of any pixel.
struct Stop {
  const char* name;
  Vec3f color;
};
constexpr Stop kScale[] = {{"black", {0, 0, 0}},
                           {"blue", {0, 0, 1}},
                           {"green", {0, 1, 0}},
                           {"yellow", {1, 1, 0}},
                           {"red", {1, 0, 0}}};
constexpr int kSteps = int(std::size(kScale)) - 1;

/// The colour at 0 <= height <= 1 of the scale, by linear interpolation between its stops.
Vec3f colorAt(double height) {
  const double place = height * kSteps;
  const int step = std::min(int(place), kSteps - 1);
  const double beyond = place - step;
  return Vec3f(Vec3d(kScale[step].color) * (1 - beyond) + Vec3d(kScale[step + 1].color) * beyond);
}

}  // namespace

std::vector<std::uint32_t> countRays(const SceneParser& scene, const Object3D& geometry,
                                     const RenderOptions& options, int threads, int width,
                                     int height, TileListener* listener) {
  std::vector<std::uint32_t> counts(std::size_t(width) * std::size_t(height));
  const PixelRectangle picture = {0, 0, width, height};
  const RayTracer tracer(scene, geometry, options);
  const WaveTracer waves(tracer);
  const PictureView view = {*scene.getCamera(), width, height};
  const auto sampler = makeSampler(options.sampling);
  const SampleSource source = {view, waves, *sampler, options.sampling.tolerance};
  const double samples = options.sampling.samples;  // of a pixel, as far as they can be foretold
  const auto countSome = [&](int, TileQueue& queue) {
    SampleCounter counter(scene, geometry, options, view);
    while (const auto area = queue.take()) {
      forEachSample(source, *area, [&](const Sample& sample) {
        add(counter.raysOf(sample), counts[picture.index(sample.at)]);
      });
      if (listener) listener->tileIsDone(*area, samples * double(area->pixelCount()));
    }
  };
  if (listener) listener->begins(samples * width * height);
  shareTiles({width, height, kTileSide}, options, threads, countSome);
  return counts;
}

std::string drawHeatmap(const std::vector<std::uint32_t>& counts, Image& picture) {
  // Relative to the largest count; where all are 0 the picture is black.
  const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const int x = int(k % std::size_t(picture.Width())), y = int(k / std::size_t(picture.Width()));
    picture.setPixel(x, y, colorAt(double(counts[k]) / double(std::max(*most, 1u))));
  }
  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  std::string text = "heatmap: " + std::to_string(*least) + " to " + std::to_string(*most) +
                     " rays in a pixel, " + textOf(total / double(counts.size())) +
                     " on average\nheatmap:";
  for (int step = 0; step <= kSteps; ++step) {
    text += std::string(step == 0 ? " " : ", ") + kScale[step].name + " " +
            textOf(double(*most) * step / kSteps);
  }
  return text + "\n";
}
