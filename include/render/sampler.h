// Sampler: where in a pixel its samples lie. A pure function of the pixel and the sample's number,
// so that the picture depends on no order and no number of threads.
#pragma once
#include <cstdint>

#include "math/vec3.h"
#include "render/render_options.h"

/// The patterns, by SamplingOptions::Pattern:
///   center     one sample, at the pixel's centre;
///   random     anywhere in the pixel, evenly spread;
///   uniform    the centres of a square grid of cells, row by row from the lowest;
///   jittered   one anywhere in each cell of such a grid, of side s;
///   adaptive   likewise; for pixels that need more, samples that can be taken by and by: the first
///              s^2 4^k of them, for every k, are one in each cell of a grid of side s 2^k.
/// Random numbers are hashed from the pixel and the sample, or, for `random` and `jittered`, come
/// from one sequence that is drawn from in the order of a scan: columns from the left, the pixels
/// of each from the lowest, the samples of each by number, two draws for each sample.
/// Source: the idea of refining a pattern cell by cell is that of Painter and Sloan,
/// "Antialiased Ray Tracing by Adaptive Progressive Refinement", 1989.
class Sampler {
 public:
  /// The counts of `options` are within their limits; all but those of `random` are rounded up to
  /// a square, and maxSamples to s^2 4^k.
  /// Where numbers come from a sequence, `height` is the picture's, in pixels.
  explicit Sampler(const SamplingOptions& options, int height = 1);

  const SamplingOptions& options() const { return options_; }
  /// How many samples a pixel has at most.
  int getNumSamples() const { return most_; }
  /// How many of them come first; the others are for pixels that need more. Only the adaptive
  /// pattern has others.
  int getNumFirst() const { return first_; }
  /// True where some pixels may get more samples than others.
  bool isAdaptive() const { return first_ < most_; }
  /// Sample `n` (0 <= n < getNumSamples()) of pixel (i, j), counted from the pixel's lower left
  /// corner: each component is at least 0 and below 1. (i, j) may lie outside of the picture.
  Vec2d getSamplePosition(int i, int j, int n) const;

 private:
  /// A cell of the grid of side s 2^level.
  struct Cell {
    int level, x, y;
  };
  Vec2d jitteredPosition(std::uint64_t pixel, int n) const;
  Vec2d sampleIn(std::uint64_t pixel, const Cell& cell) const;
  int quarterOf(const Vec2d& sample, const Cell& cell) const;
  Vec2d newSampleIn(std::uint64_t pixel, const Cell& cell) const;
  Vec2d sequencePosition(int i, int j, int n) const;

  SamplingOptions options_;
  int height_;
  int side_;  // s
  int first_, most_;
};
