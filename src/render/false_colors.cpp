// False colours.
//
// Materials. The colours are to be far apart for small numbers: the bits of the number are dealt
// out to red, green and blue in turn, and each component takes 0, 255, 127, 191, 63 ..., always the
// middle of a gap: 255 less the bits of the level before, lowest first.
//
// The heat map. Rays are counted by an observer of the recursion that traces one ray after the
// other: tables mix those of many pixels. So every sample is traced on its own, and where it is
// the colours that say how many samples a pixel gets, those are found first, as for the picture.
#include "render/false_colors.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "render/ray_report.h"
#include "render/sample_tracing.h"
#include "render/tiles.h"

namespace {

constexpr int kColors = (1 << 24) - 1;

/// A colour as one number.
std::uint32_t packed(Rgb8 color) {
  return std::uint32_t(color.r) << 16 | std::uint32_t(color.g) << 8 | color.b;
}

/// Component 0, 1 or 2 of a material's colour: every third of the bits makes the level.
/// Level 0 is 0; the other 255 are all different and above 0.
std::uint8_t componentOf(int bits, int component) {
  unsigned level = 0;
  for (int bit = 0; bit < 8; ++bit) level |= unsigned(bits >> (component + 3 * bit) & 1) << bit;
  if (level == 0) return 0;
  unsigned reversed = 0;
  for (int bit = 0; bit < 8; ++bit) reversed = reversed << 1 | ((level - 1) >> bit & 1);
  return std::uint8_t(255 - reversed);
}

/// The scale of the heat map, its stops evenly spaced from no rays to the most of any pixel.
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

}  // namespace

Rgb8 materialColor(int number) {
  if (number < 0) return {128, 128, 128};
  const int bits = number % kColors + 1;
  return {componentOf(bits, 0), componentOf(bits, 1), componentOf(bits, 2)};
}

std::string materialLegend(const SceneParser& scene, const Image& picture) {
  // How many pixels there are of each colour; then a line for each that is a material's.
  std::unordered_map<std::uint32_t, std::size_t> pixels;
  for (int y = 0; y < picture.Height(); ++y) {
    for (int x = 0; x < picture.Width(); ++x) ++pixels[packed(picture.getPixel(x, y))];
  }
  std::string lines;
  for (int i = 0; i < scene.getNumMaterials(); ++i) {
    const Rgb8 color = materialColor(i);
    const auto found = pixels.find(packed(color));
    if (found == pixels.end()) continue;
    lines += "material " + std::to_string(i) + ": " + std::to_string(color.r) + " " +
             std::to_string(color.g) + " " + std::to_string(color.b) + ", " +
             scene.getMaterial(i)->getKind() + ", " + std::to_string(found->second) +
             (found->second == 1 ? " pixel\n" : " pixels\n");
  }
  return lines;
}

std::vector<std::uint32_t> countRays(const RayTracer& tracer, int threads, int width, int height,
                                     TileListener* listener) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> counts(std::size_t(width) * std::size_t(height));
  const PixelRectangle picture = {0, 0, width, height};
  const PictureView view(*tracer.scene().getCamera(), tracer.options().places, width, height);
  const Sampler sampler(tracer.options().sampling, height);
  const double samples = sampler.options().samples;  // of a pixel, as far as they can be foretold
  if (listener) listener->begins(samples * width * height);
  shareTiles({width, height, kTileSide}, tracer, threads, [&](const NextTile& next) {
    WaveTracer waves(tracer);
    const SampleSource source = {view, waves, sampler};
    RayCounts rays;  // of this thread, all together
    const WatchedTracer counting(tracer, rays);
    const auto count = [&](const Sample& sample) {
      const std::uint64_t before = rays.total();
      traceAlone(view, counting, sample);
      std::uint32_t& ofPixel = counts[picture.index(sample.at)];
      ofPixel = std::uint32_t(std::min(kMost, ofPixel + rays.total() - before));
    };
    while (const auto area = next()) {
      forEachSample(source, *area, count);
      if (listener) listener->tileIsDone(*area, samples * double(area->pixelCount()));
    }
  });
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
