// Rays are counted one by one, as batches mix those of many pixels.
#include "render/heatmap.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>

#include "render/number_text.h"
#include "render/sampled_renderer.h"
#include "render/tracing_stack.h"
#include "render/watched_tracer.h"
#include "system/worker_threads.h"

namespace {

constexpr int kTileSize = 16;

class RayCounter : public RayObserver {
 public:
  void rayBegins(const RayBegin&) override { ++rays; }
  void lightAnswers(const LightVerdict& verdict) override { rays += verdict.castShadowRay; }
  std::uint64_t rays = 0;
};

/// What one thread counts with.
class PixelCounter {
 public:
  PixelCounter(const SampledScene& scene, const SceneParser& parsed, const Object3D& geometry,
               const RenderOptions& options, std::vector<std::uint32_t>& counts)
      : scene_(scene),
        watched_(parsed, geometry, options, counter_),
        sampling_(options.sampling),
        sampler_(makeSampler(options.sampling)),
        counts_(counts) {}
  PixelCounter(const PixelCounter&) = delete;
  PixelCounter& operator=(const PixelCounter&) = delete;

  void countTile(const PixelRectangle& area) {
    if (isRefined(*sampler_)) {
      const auto count = [&](const Sample& sample, const Vec3f&, double) { countSample(sample); };
      return takeSamples(scene_, *sampler_, sampling_.tolerance, area, count);
    }
    for (const Pixel at : pixelsInOrder(area)) {
      for (int n = 0; n < sampler_->getNumSamples(); ++n) {
        countSample({at, sampler_->getSamplePosition(at.i, at.j, n)});
      }
    }
  }

 private:
  void countSample(const Sample& sample) {
    const Vec2d point = imagePoint(sample.at.i + sample.offset.x(), sample.at.j + sample.offset.y(),
                                   scene_.width, scene_.height);
    Ray ray = scene_.camera.generateRay(point);
    Hit hit;
    counter_.rays = 0;
    watched_.traceRay(ray, float(scene_.camera.getTMin()), 0, 1, 1, hit);
    std::uint32_t& count =
        counts_[std::size_t(sample.at.j) * std::size_t(scene_.width) + std::size_t(sample.at.i)];
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    count = std::uint32_t(std::min(kMost, count + counter_.rays));
  }

  const SampledScene& scene_;
  RayCounter counter_;
  const WatchedTracer watched_;
  const SamplingOptions& sampling_;
  const std::unique_ptr<const Sampler> sampler_;
  std::vector<std::uint32_t>& counts_;
};

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

/// 0 <= part <= 1 of the scale.
Vec3f colorAt(double part) {
  const double place = part * kSteps;
  const int step = std::min(int(place), kSteps - 1);
  const double beyond = place - step;
  return Vec3f(Vec3d(kScale[step].color) * (1 - beyond) + Vec3d(kScale[step + 1].color) * beyond);
}

}  // namespace

std::vector<std::uint32_t> countRays(const SceneParser& scene, const Object3D& geometry,
                                     const RenderOptions& options, int threads, int width,
                                     int height, TileListener* listener) {
  std::vector<std::uint32_t> counts(std::size_t(width) * std::size_t(height));
  const RayTracer tracer(scene, geometry, options);
  const WaveTracer waves(tracer);
  const SampledScene sampled = {*scene.getCamera(), waves, width, height};
  const int columns = (width + kTileSize - 1) / kTileSize;
  const int tiles = columns * ((height + kTileSize - 1) / kTileSize);
  const double samples = options.sampling.samples;  // as far as they can be foretold
  if (listener) listener->begins(samples * width * height);
  std::atomic<int> next{0};
  runOnThreads(std::min(threads, tiles), tracingStack(options), [&](int) {
    PixelCounter counter(sampled, scene, geometry, options, counts);
    for (int tile; (tile = next++) < tiles;) {
      const int left = tile % columns * kTileSize, bottom = tile / columns * kTileSize;
      const PixelRectangle area = {left, bottom, std::min(left + kTileSize, width),
                                   std::min(bottom + kTileSize, height)};
      counter.countTile(area);
      if (listener) listener->tileIsDone(area, samples * double(area.pixelCount()));
    }
  });
  return counts;
}

std::string drawHeatmap(const std::vector<std::uint32_t>& counts, Image& picture) {
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
