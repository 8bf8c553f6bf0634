// More samples where colours differ.
#include "render/adaptive_sampling.h"

#include <algorithm>

namespace {

/// Pixels that are refined together have room for so many samples.
constexpr int kGroupSamples = 1 << 16;
constexpr int kMostInGroup = 1024;

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

AdaptiveSampling::AdaptiveSampling(const SampledScene& scene, const Sampler& sampler,
                                   double tolerance, const PixelRectangle& sources)
    : scene_(scene),
      sampler_(sampler),
      tolerance_(tolerance),
      sources_(sources),
      seen_(sources.grown(1)),
      first_(seen_.pixelCount() * std::size_t(sampler.getNumFirst())),
      ranges_(seen_.pixelCount()) {
  takeFirst();
}

void AdaptiveSampling::takeFirst() {
  const int count = sampler_.getNumFirst();
  std::size_t received = 0;
  const std::vector<Pixel> pixels = pixelsInOrder(seen_);
  SampleBatch batch(scene_, [&](const Sample& sample, const Vec3f& color) {
    const std::size_t place = seen_.index(sample.at), n = received++ % std::size_t(count);
    first_[place * std::size_t(count) + n] = {sample.offset, color};
    ranges_[place].add(color);
  });
  for (const Pixel at : pixels) {
    for (int n = 0; n < count; ++n) batch.add({at, sampler_.getSamplePosition(at.i, at.j, n)});
  }
  batch.flush();
}

void AdaptiveSampling::finish(const Receiver& receiver) const {
  const int most = sampler_.getNumSamples();
  const auto groupSize = std::size_t(std::clamp(kGroupSamples / most, 1, kMostInGroup));
  const std::vector<Pixel> pixels = pixelsInOrder(sources_);
  std::vector<RefinedPixel> group;
  for (std::size_t start = 0; start < pixels.size(); start += groupSize) {
    group.clear();
    const std::size_t end = std::min(pixels.size(), start + groupSize);
    for (std::size_t k = start; k < end; ++k) group.push_back(firstOf(pixels[k]));
    refine(group);
    for (const RefinedPixel& pixel : group) {
      const double share = most / double(pixel.samples.size());
      for (const Taken& sample : pixel.samples) {
        receiver({pixel.at, sample.offset}, sample.color, share);
      }
    }
  }
}

AdaptiveSampling::RefinedPixel AdaptiveSampling::firstOf(Pixel at) const {
  const std::size_t place = seen_.index(at);
  const auto start = first_.begin() + std::ptrdiff_t(place) * sampler_.getNumFirst();
  return {at, {start, start + sampler_.getNumFirst()}, ranges_[place], differsAround(at)};
}

bool AdaptiveSampling::differsAround(Pixel at) const {
  ColorRange range;
  for (int j = at.j - 1; j <= at.j + 1; ++j) {
    for (int i = at.i - 1; i <= at.i + 1; ++i) range.add(ranges_[seen_.index({i, j})]);
  }
  return range.width() > tolerance_;
}

/// Step by step for the whole group, so that batches are full.
void AdaptiveSampling::refine(std::vector<RefinedPixel>& group) const {
  for (int count = sampler_.getNumFirst(); count < sampler_.getNumSamples(); count *= 4) {
    std::vector<RefinedPixel*> pixels;
    for (RefinedPixel& pixel : group) {
      if (pixel.needsMore) pixels.push_back(&pixel);
    }
    takeMore(pixels, count, 4 * count);
    for (RefinedPixel* pixel : pixels) pixel->needsMore = pixel->range.width() > tolerance_;
  }
}

/// Traces samples from <= n < to of each pixel.
void AdaptiveSampling::takeMore(const std::vector<RefinedPixel*>& pixels, int from, int to) const {
  std::size_t received = 0;
  SampleBatch batch(scene_, [&](const Sample& sample, const Vec3f& color) {
    RefinedPixel& pixel = *pixels[received++ / std::size_t(to - from)];
    pixel.samples.push_back({sample.offset, color});
    pixel.range.add(color);
  });
  for (const RefinedPixel* pixel : pixels) {
    const Pixel at = pixel->at;
    for (int n = from; n < to; ++n) batch.add({at, sampler_.getSamplePosition(at.i, at.j, n)});
  }
  batch.flush();
}
