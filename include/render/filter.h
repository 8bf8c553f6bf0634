// Filter: how much a sample counts in the colour of a pixel. The colour is the sum of weight times
// colour over the samples within reach, divided by the sum of the weights.
// Lengths are in pixels.
#pragma once
#include <memory>

#include "render/sampling_options.h"

class Filter {
 public:
  virtual ~Filter() = default;
  Filter() = default;
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  /// The weight, from 0 to 1, of a sample at (x, y) from the pixel's centre.
  virtual double getWeight(double x, double y) const = 0;
  /// How many pixels to each side have samples that may count; 0: only the pixel's own do.
  virtual int getSupportRadius() const = 0;
};

/// 1 where |x| and |y| are at most the radius, else 0.
class BoxFilter : public Filter {
 public:
  /// `radius` > 0.
  explicit BoxFilter(double radius) : radius_(radius) {}
  double getWeight(double x, double y) const override;
  int getSupportRadius() const override;

 private:
  double radius_;
};

/// A cone: max(0, 1 - d / radius), d the distance from the centre.
class TentFilter : public Filter {
 public:
  /// `radius` > 0.
  explicit TentFilter(double radius) : radius_(radius) {}
  double getWeight(double x, double y) const override;
  int getSupportRadius() const override;

 private:
  double radius_;
};

/// exp(-d^2 / (2 sigma^2)) up to the distance d = 2 sigma, 0 beyond.
class GaussianFilter : public Filter {
 public:
  /// `sigma` > 0.
  explicit GaussianFilter(double sigma) : sigma_(sigma) {}
  double getWeight(double x, double y) const override;
  int getSupportRadius() const override;

 private:
  double sigma_;
};

/// The filter that `options` describe.
std::unique_ptr<const Filter> makeFilter(const SamplingOptions& options);
