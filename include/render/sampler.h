// Sampler: where in a pixel its samples lie. A pure function of the pixel and the sample's number,
// so that the picture depends on no order and no number of threads.
#pragma once
#include <cstdint>
#include <memory>

#include "math/vec2.h"
#include "render/render_options.h"

class Sampler {
 public:
  virtual ~Sampler() = default;
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  /// How many samples a pixel has at most.
  int getNumSamples() const { return most_; }
  /// How many of them come first; the others are for pixels that need more. Most patterns have no
  /// others.
  int getNumFirst() const { return first_; }
  /// True where some pixels may get more samples than others.
  bool isAdaptive() const { return first_ < most_; }
  /// Sample `n` (0 <= n < getNumSamples()) of pixel (i, j), counted from the pixel's lower left
  /// corner: each component is at least 0 and below 1. (i, j) may lie outside of the picture.
  virtual Vec2d getSamplePosition(int i, int j, int n) const = 0;

 protected:
  Sampler(int first, int most) : first_(first), most_(most) {}

 private:
  int first_, most_;
};

/// Anywhere in the pixel, evenly spread.
class RandomSampler : public Sampler {
 public:
  explicit RandomSampler(int samples) : Sampler(samples, samples) {}
  Vec2d getSamplePosition(int i, int j, int n) const override;
};

/// The centres of a square grid of cells, row by row from the lowest. One sample is the pixel's
/// centre.
class UniformSampler : public Sampler {
 public:
  /// `samples` >= 1 is rounded up to a square.
  explicit UniformSampler(int samples);
  Vec2d getSamplePosition(int i, int j, int n) const override;

 private:
  int side_;
};

/// One sample anywhere in each cell of a square grid; for pixels that need more, samples that can
/// be taken by and by: the first s^2 4^k of them, for every k, are one in each cell of a grid of
/// side s 2^k.
/// Source: the idea of refining a pattern cell by cell is that of Painter and Sloan,
/// "Antialiased Ray Tracing by Adaptive Progressive Refinement", 1989.
class JitteredSampler : public Sampler {
 public:
  /// s^2 is `first` >= 1 rounded up to a square; `most` is rounded up to s^2 4^k.
  JitteredSampler(int first, int most);
  explicit JitteredSampler(int samples) : JitteredSampler(samples, 1) {}
  Vec2d getSamplePosition(int i, int j, int n) const override;

 private:
  /// A cell of the grid of side s 2^level.
  struct Cell {
    int level, x, y;
  };
  Vec2d sampleIn(std::uint64_t pixel, const Cell& cell) const;
  int quarterOf(const Vec2d& sample, const Cell& cell) const;
  Vec2d newSampleIn(std::uint64_t pixel, const Cell& cell) const;

  int side_;  // s
};

/// The sampler that `options` describe; their counts are within their limits.
std::unique_ptr<const Sampler> makeSampler(const SamplingOptions& options);
