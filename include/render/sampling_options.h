// SamplingOptions: where in a pixel rays are sent, and how their colours become the pixel's.
#pragma once

struct SamplingOptions {
  enum class Pattern {
    center,    ///< one sample, at the pixel's centre
    random,    ///< anywhere in the pixel
    uniform,   ///< the centres of a square grid of cells
    jittered,  ///< one anywhere in each cell of a square grid
    adaptive   ///< jittered, with more samples where colours differ
  };
  enum class FilterKind { box, tent, gaussian };

  /// Limits of the numbers below. A filter reaches at most kMaxReach pixels.
  static constexpr int kMaxSamples = 65536, kMaxFirstSamples = 256, kMaxReach = 32;

  Pattern pattern = Pattern::center;
  /// Samples wanted in each pixel, 1..kMaxSamples; all but `random` round it up to a square.
  /// `adaptive` begins with as many (1..kMaxFirstSamples) and goes up to maxSamples.
  int samples = 1;
  int maxSamples = 1;  ///< samples..kMaxSamples, rounded up to the squared grid times a power of 4
  /// Colours, as shown, that differ by more in some component call for more samples: `adaptive`
  /// alone; 0..1. Below 0 every pixel gets maxSamples.
  double tolerance = 0;

  FilterKind filter = FilterKind::box;
  /// In pixels, above 0: the radius of box or tent, at most kMaxReach, or the gaussian's sigma, at
  /// most half of that.
  double filterSize = 0.5;

  /// True where each pixel is the colour of the ray through its centre.
  bool isPlain() const {
    return pattern == Pattern::center && filter == FilterKind::box && filterSize == 0.5;
  }
};
