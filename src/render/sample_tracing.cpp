// Tracing samples.
//
// The rule of adaptive sampling. Every pixel gets the sampler's first samples. Where those of a
// pixel and of its eight neighbours, all together, differ by more than the tolerance, the pixel
// gets four times as many. From then on it gets four times as many again as long as its own samples
// differ by more, up to the sampler's count. Colours differ by the largest difference of a
// component, each clamped to 0..1, as the picture shows it. In the filter a pixel's samples
// together have the same weight however many there are. All this depends on nothing but the pixel
// and its neighbours, so no byte depends on where tiles begin or end.
//
// Rays go through the scene in batches: those of many samples, in the order in which the samples
// are handed over. Pixels are refined a group at a time, step by step for the whole group: enough
// of them to fill batches, and few enough that their samples need little memory.
#include "render/sample_tracing.h"

#include <algorithm>
#include <vector>

namespace {

/// Pixels that are refined together have room for so many samples.
constexpr int kGroupSamples = 1 << 16;
constexpr int kMostInGroup = 1024;

using ColorReceiver = std::function<void(const Sample& sample, const Vec3f& color)>;

/// Sends the rays of count <= kBatchSize samples through the scene together.
void traceBatch(const SampleSource& source, const Sample* samples, int count,
                const ColorReceiver& receiver) {
  RayBatch rays(static_cast<std::size_t>(count));
  Hit hits[kBatchSize];
  Vec3f colors[kBatchSize];
  for (int k = 0; k < count; ++k) source.view.setEyeRay(samples[k], rays[std::size_t(k)]);
  source.tracer.trace(rays, 0, hits, colors);
  for (int k = 0; k < count; ++k) receiver(samples[k], colors[k]);
}

/// Traces the samples from <= n < to of each pixel and hands them over in that order.
void traceSamples(const SampleSource& source, const std::vector<Pixel>& pixels, int from, int to,
                  const ColorReceiver& receiver) {
  Sample batch[kBatchSize];
  int count = 0;
  for (const Pixel at : pixels) {
    for (int n = from; n < to; ++n) {
      batch[count++] = {at, source.sampler.getSamplePosition(at.i, at.j, n)};
      if (count < kBatchSize) continue;
      traceBatch(source, batch, count, receiver);
      count = 0;
    }
  }
  if (count > 0) traceBatch(source, batch, count, receiver);
}

/// The rule above, for a rectangle of pixels.
class AdaptiveSampling {
 public:
  AdaptiveSampling(const SampleSource& source, const PixelRectangle& area);

  void takeAll(const SampleReceiver& receiver);

 private:
  struct TakenSample {
    Vec2d offset;
    Vec3f color;
  };
  static_assert(sizeof(TakenSample) <= kBytesPerSample);
  struct SampledPixel {
    std::vector<TakenSample> samples;
    ColorRange range;  // of their colours
  };

  SampledPixel& operator[](Pixel at) { return pixels_[seen_.index(at)]; }
  void take(const std::vector<Pixel>& pixels, int from, int to);
  bool differsAround(Pixel at);
  void refine(std::vector<Pixel> pixels);
  void handOver(Pixel at, const SampleReceiver& receiver);

  const SampleSource& source_;
  const PixelRectangle area_, seen_;
  std::vector<SampledPixel> pixels_;  // those in seen_, row by row
};

AdaptiveSampling::AdaptiveSampling(const SampleSource& source, const PixelRectangle& area)
    : source_(source), area_(area), seen_(area.grown(1)), pixels_(seen_.pixelCount()) {
  const auto first = std::size_t(source.sampler.getNumFirst());
  for (SampledPixel& pixel : pixels_) pixel.samples.reserve(first);
}

void AdaptiveSampling::takeAll(const SampleReceiver& receiver) {
  // 1. The first samples of all pixels and of those next to them.
  take(pixelsInOrder(seen_), 0, source_.sampler.getNumFirst());
  // 2. Which pixels need more, before any range grows.
  const std::vector<Pixel> pixels = pixelsInOrder(area_);
  std::vector<bool> needsMore;
  for (const Pixel at : pixels) needsMore.push_back(differsAround(at));
  // 3. Group by group: more samples, and all of them are handed over.
  const auto groupSize =
      std::size_t(std::clamp(kGroupSamples / source_.sampler.getNumSamples(), 1, kMostInGroup));
  for (std::size_t start = 0; start < pixels.size(); start += groupSize) {
    const std::size_t end = std::min(pixels.size(), start + groupSize);
    std::vector<Pixel> group;
    for (std::size_t k = start; k < end; ++k) {
      if (needsMore[k]) group.push_back(pixels[k]);
    }
    refine(std::move(group));
    for (std::size_t k = start; k < end; ++k) handOver(pixels[k], receiver);
  }
}

/// Traces samples from <= n < to of each pixel.
void AdaptiveSampling::take(const std::vector<Pixel>& pixels, int from, int to) {
  traceSamples(source_, pixels, from, to, [&](const Sample& sample, const Vec3f& color) {
    SampledPixel& pixel = (*this)[sample.at];
    pixel.samples.push_back({sample.offset, color});
    pixel.range.add(color);
  });
}

bool AdaptiveSampling::differsAround(Pixel at) {
  ColorRange range;
  for (int j = at.j - 1; j <= at.j + 1; ++j) {
    for (int i = at.i - 1; i <= at.i + 1; ++i) range.add((*this)[{i, j}].range);
  }
  return range.width() > source_.tolerance;
}

/// Gives pixels that need more samples four times as many, again and again, until they do not.
void AdaptiveSampling::refine(std::vector<Pixel> pixels) {
  for (int count = source_.sampler.getNumFirst(); count < source_.sampler.getNumSamples();
       count *= 4) {
    take(pixels, count, 4 * count);
    const auto agree = [&](Pixel at) { return !((*this)[at].range.width() > source_.tolerance); };
    pixels.erase(std::remove_if(pixels.begin(), pixels.end(), agree), pixels.end());
  }
}

/// Hands over the samples of a pixel and forgets them.
void AdaptiveSampling::handOver(Pixel at, const SampleReceiver& receiver) {
  const std::vector<TakenSample> samples = std::move((*this)[at].samples);
  const double share = source_.sampler.getNumSamples() / double(samples.size());
  for (const TakenSample& sample : samples) receiver({at, sample.offset}, sample.color, share);
}

float clamped(float component) {
  return component > 0 ? std::min(component, 1.0f) : 0.0f;  // a NaN is shown as 0
}

}  // namespace

void ColorRange::add(const Vec3f& color) {
  for (int c = 0; c < 3; ++c) {
    low_[c] = std::min(low_[c], clamped(color[c]));
    high_[c] = std::max(high_[c], clamped(color[c]));
  }
}

void ColorRange::add(const ColorRange& other) {
  for (int c = 0; c < 3; ++c) {
    low_[c] = std::min(low_[c], other.low_[c]);
    high_[c] = std::max(high_[c], other.high_[c]);
  }
}

double ColorRange::width() const {
  const Vec3d widths = Vec3d(high_) - Vec3d(low_);
  return std::max({widths.r(), widths.g(), widths.b()});
}

Vec3f traceAlone(const PictureView& view, const RayTracer& tracer, const Sample& sample) {
  TracedRay eye;
  view.setEyeRay(sample, eye);
  Hit hit;
  return tracer.traceRay(eye.ray, float(eye.tmin), 0, eye.weight, eye.indexOfRefraction, hit);
}

void takeSamples(const SampleSource& source, const PixelRectangle& area,
                 const SampleReceiver& receiver) {
  if (source.sampler.isAdaptive()) return AdaptiveSampling(source, area).takeAll(receiver);
  traceSamples(source, pixelsInOrder(area), 0, source.sampler.getNumSamples(),
               [&](const Sample& sample, const Vec3f& color) { receiver(sample, color, 1); });
}
