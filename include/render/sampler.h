// Sampler: where in a pixel its samples lie. A pure function of the pixel and the sample's number,
// so that the picture depends on no order and no number of threads.
#pragma once
#include <cstdint>
#include <memory>

#include "math/vec2.h"
#include "render/sampling_options.h"

class Sampler {
 public:
  virtual ~Sampler() = default;
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  /// How many samples each pixel has.
  int getNumSamples() const { return samples_; }
  /// How many of them come first; the others are for pixels that need more. Most patterns have no
  /// others.
  virtual int getNumFirst() const { return samples_; }
  /// Sample `n` (0 <= n < getNumSamples()) of pixel (i, j), counted from the pixel's lower left
  /// corner: each component is at least 0 and below 1. (i, j) may lie outside of the picture.
  virtual Vec2d getSamplePosition(int i, int j, int n) const = 0;

 protected:
  explicit Sampler(int samples) : samples_(samples) {}

 private:
  int samples_;
};

/// Anywhere in the pixel, evenly spread.
class RandomSampler : public Sampler {
 public:
  explicit RandomSampler(int samples) : Sampler(samples) {}
  Vec2d getSamplePosition(int i, int j, int n) const override;
};

/// The side of the smallest square grid with at least `samples` >= 1 cells.
int gridSide(int samples);

/// The centres of a grid of cells, row by row from the lowest. One sample is the pixel's centre.
class UniformSampler : public Sampler {
 public:
  /// `samples` is rounded up to a square.
  explicit UniformSampler(int samples);
  Vec2d getSamplePosition(int i, int j, int n) const override;

 private:
  int side_;
};

/// One sample in each cell of the same grid, anywhere in it.
class JitteredSampler : public Sampler {
 public:
  explicit JitteredSampler(int samples);
  Vec2d getSamplePosition(int i, int j, int n) const override;

 private:
  int side_;
};

/// Samples that can be taken by and by: the first s^2 4^k of them, for every k, are one in each
/// cell of a grid of side s 2^k. For k = 0 they are those of JitteredSampler.
/// Source: the idea of refining a pattern cell by cell is that of Painter and Sloan,
/// "Antialiased Ray Tracing by Adaptive Progressive Refinement", 1989.
class NestedSampler : public Sampler {
 public:
  /// s^2 is `first` rounded up to a square; `most` is rounded up to s^2 4^k.
  NestedSampler(int first, int most);

  int getNumFirst() const override { return side_ * side_; }
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
