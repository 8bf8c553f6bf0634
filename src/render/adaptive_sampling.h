// AdaptiveSampling: few samples where colours agree, more where they differ.
//
// The rule. Every pixel gets the sampler's first samples. Where those of a pixel and of its eight
// neighbours, all together, differ by more than the tolerance, the pixel gets four times as many.
// From then on it gets four times as many again as long as its own samples differ by more, up to
// the sampler's count. Colours differ by the largest difference of a component, each clamped to
// 0..1, as the picture shows it. In the filter a pixel's samples together have the same weight
// however many there are. All this depends on nothing but the pixel and its neighbours.
#pragma once
#include <functional>
#include <vector>

#include "render/sample_batch.h"
#include "render/sampler.h"

/// The least and the greatest of some colours, each component on its own, clamped to 0..1.
class ColorRange {
 public:
  void add(const Vec3f& color);
  void add(const ColorRange& other);
  /// The largest difference in a component; below 0 before anything was added.
  double width() const;

 private:
  Vec3f low_{1, 1, 1}, high_{-1, -1, -1};
};

class AdaptiveSampling {
 public:
  /// Takes a sample, its colour, and the factor that makes up for its pixel's having fewer samples
  /// than another.
  using Receiver = std::function<void(const Sample& sample, const Vec3f& color, double share)>;

  /// Traces the first samples of the pixels in `sources` and next to it. `scene` and `sampler` are
  /// not owned.
  AdaptiveSampling(const SampledScene& scene, const Sampler& sampler, double tolerance,
                   const PixelRectangle& sources);

  /// Traces what else is needed and hands over all samples of the pixels in `sources`: pixels as in
  /// pixelsInOrder, the samples of each by number.
  void finish(const Receiver& receiver) const;

  /// About how many samples are kept for each of the first ones of `sources`, in bytes.
  static constexpr std::size_t kBytesPerSample = 32;

 private:
  struct Taken {
    Vec2d offset;
    Vec3f color;
  };
  static_assert(sizeof(Taken) <= kBytesPerSample);
  struct RefinedPixel {
    Pixel at;
    std::vector<Taken> samples;
    ColorRange range;
    bool needsMore;
  };

  void takeFirst();
  RefinedPixel firstOf(Pixel at) const;
  bool differsAround(Pixel at) const;
  void refine(std::vector<RefinedPixel>& group) const;
  void takeMore(const std::vector<RefinedPixel*>& pixels, int from, int to) const;

  const SampledScene& scene_;
  const Sampler& sampler_;
  const double tolerance_;
  const PixelRectangle sources_, seen_;
  std::vector<Taken> first_;        // of the pixels in seen_, row by row
  std::vector<ColorRange> ranges_;  // likewise
};
