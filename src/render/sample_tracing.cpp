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
// Rays go through the scene by tables: those of many samples, in the order in which the samples
// are handed over. Pixels are refined a group at a time, step by step for the whole group: enough
// of them to fill tables, and few enough that their samples need little memory.
#include "render/sample_tracing.h"

#include <algorithm>
#include <vector>

#include "render/wave_kernels.h"

namespace {

/// Pixels that are refined together have room for so many samples.
constexpr int kGroupSamples = 1 << 16;
constexpr int kMostInGroup = 1024;

/// Traces the samples from <= n < to of each pixel, as many together as a table takes, and hands
/// them over in that order.
void traceSamples(const SampleSource& source, const std::vector<Pixel>& pixels, int from, int to,
                  const SampleReceiver& receiver) {
  std::vector<Sample> samples;
  const auto traceTogether = [&] {
    const Arena::Frame frame(source.tracer.arena());
    const TracedSamples traced(source.view, source.tracer, samples.data(), int(samples.size()),
                               true);
    for (std::size_t k = 0; k < samples.size(); ++k) receiver(samples[k], traced.colors[k], 1);
    samples.clear();
  };
  samples.reserve(std::size_t(RayTable::kMost));
  for (const Pixel at : pixels) {
    for (int n = from; n < to; ++n) {
      samples.push_back({at, source.sampler.getSamplePosition(at.i, at.j, n)});
      if (samples.size() == std::size_t(RayTable::kMost)) traceTogether();
    }
  }
  traceTogether();
}

/// The rule above, for a rectangle of pixels.
class AdaptiveSampling {
 public:
  AdaptiveSampling(const SampleSource& source, const PixelRectangle& area)
      : source_(source), area_(area), seen_(area.grown(1)), pixels_(seen_.pixelCount()) {
    const auto first = std::size_t(source.sampler.getNumFirst());
    for (SampledPixel& pixel : pixels_) pixel.samples.reserve(first);
  }

  void takeAll(const SampleReceiver& receiver) {
    // 1. The first samples of all pixels and of those next to them.
    take(pixelsInOrder(seen_), 0, source_.sampler.getNumFirst());
    // 2. Which pixels need more, before any range grows.
    const std::vector<Pixel> pixels = pixelsInOrder(area_);
    std::vector<bool> needsMore;
    needsMore.reserve(pixels.size());
    for (const Pixel at : pixels) needsMore.push_back(differs(rangeAround(at)));
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
  bool differs(const ColorRange& range) const {
    return range.width() > source_.sampler.options().tolerance;
  }

  /// Traces samples from <= n < to of each pixel.
  void take(const std::vector<Pixel>& pixels, int from, int to) {
    traceSamples(source_, pixels, from, to, [&](const Sample& sample, const Vec3f& color, double) {
      SampledPixel& pixel = (*this)[sample.at];
      pixel.samples.push_back({sample.offset, color});
      pixel.range.add(color);
    });
  }

  ColorRange rangeAround(Pixel at) {
    ColorRange range;
    for (int j = at.j - 1; j <= at.j + 1; ++j) {
      for (int i = at.i - 1; i <= at.i + 1; ++i) range.add((*this)[{i, j}].range);
    }
    return range;
  }

  /// Gives pixels that need more samples four times as many, again and again, until they do not.
  void refine(std::vector<Pixel> pixels) {
    const auto agree = [&](Pixel at) { return !differs((*this)[at].range); };
    for (int count = source_.sampler.getNumFirst(); count < source_.sampler.getNumSamples();
         count *= 4) {
      take(pixels, count, 4 * count);
      pixels.erase(std::remove_if(pixels.begin(), pixels.end(), agree), pixels.end());
    }
  }

  /// Hands over the samples of a pixel and forgets them.
  void handOver(Pixel at, const SampleReceiver& receiver) {
    const std::vector<TakenSample> samples = std::move((*this)[at].samples);
    const double share = source_.sampler.getNumSamples() / double(samples.size());
    for (const TakenSample& sample : samples) receiver({at, sample.offset}, sample.color, share);
  }

  const SampleSource& source_;
  const PixelRectangle area_, seen_;
  std::vector<SampledPixel> pixels_;  // those in seen_, row by row
};

}  // namespace

PictureView::PictureView(const Camera& ofCamera, const PixelPlaces& places, int pictureWidth,
                         int pictureHeight)
    : camera(ofCamera),
      width(pictureWidth),
      height(pictureHeight),
      middle_(width / 2.0 + places.shift, height / 2.0 + places.shift) {
  using Unit = PixelPlaces::Unit;
  const auto unitOf = [&](int side) {
    const int pixels = places.unit == Unit::bothSides ? side
                       : places.unit == Unit::height  ? height
                                                      : std::max(width, height);
    return pixels > places.inset ? pixels - places.inset : 1;
  };
  unit_ = {unitOf(width), unitOf(height)};
}

/// Places in the picture first, as the kernel wants them; a camera that it does not know makes its
/// rays one by one.
TracedSamples::TracedSamples(const PictureView& view, WaveTracer& tracer, const Sample* samples,
                             int count, bool wantsColors)
    : rays(tracer.arena(), count, false),
      hits(tracer.arena(), count),
      colors(tracer.arena().take<Vec3f>(std::size_t(count))) {
  const Arena::Frame frame(tracer.arena());
  auto* x = tracer.arena().take<double>(std::size_t(count));
  auto* y = tracer.arena().take<double>(std::size_t(count));
  for (int k = 0; k < count; ++k) {
    const Vec2d place = samples[k].place();
    x[k] = place.x();
    y[k] = place.y();
  }
  const double tmin = view.camera.getTMin(), tmax = Hit().getT();
  rays.count = count;
  std::fill(rays.tmin, rays.tmin + count, tmin);
  std::fill(rays.tmax, rays.tmax + count, tmax);
  std::fill(rays.weight, rays.weight + count, 1.0f);
  EyeFrame eye;
  if (toNumbers(view, eye)) {
    tracer.kernels().eyeRays(eye, x, y, count, rays);
  } else {
    for (int k = 0; k < count; ++k) {
      rays.setRow(k, view.camera.generateRay(view.pointOf(samples[k])), tmin, tmax);
    }
  }
  wantsColors ? tracer.trace(rays, 0, hits, colors) : tracer.intersect(rays, hits);
}

Vec3f traceAlone(const PictureView& view, const RayTracer& tracer, const Sample& sample) {
  Ray ray = view.camera.generateRay(view.pointOf(sample));
  Hit hit;
  return tracer.traceRay(ray, float(view.camera.getTMin()), 0, 1, 1, hit);
}

void takeSamples(const SampleSource& source, const PixelRectangle& area,
                 const SampleReceiver& receiver) {
  if (source.sampler.isAdaptive()) return AdaptiveSampling(source, area).takeAll(receiver);
  traceSamples(source, pixelsInOrder(area), 0, source.sampler.getNumSamples(), receiver);
}
