// The filters' formulas.
#include "render/filter.h"

#include <algorithm>
#include <cmath>

#include "math/functions.h"

namespace {

/// A pixel d to the side has samples from d - 0.5 to d + 0.5 away.
int pixelsWithin(double radius) { return int(std::ceil(std::max(0.0, radius - 0.5))); }

}  // namespace

double BoxFilter::getWeight(double x, double y) const {
  return std::fabs(x) <= radius_ && std::fabs(y) <= radius_ ? 1 : 0;
}

int BoxFilter::getSupportRadius() const { return pixelsWithin(radius_); }

double TentFilter::getWeight(double x, double y) const {
  return std::max(0.0, 1 - std::sqrt(x * x + y * y) / radius_);
}

int TentFilter::getSupportRadius() const { return pixelsWithin(radius_); }

double GaussianFilter::getWeight(double x, double y) const {
  const double ratio = (x * x + y * y) / (sigma_ * sigma_);
  return ratio <= 4 ? math::exp(-ratio / 2) : 0;
}

int GaussianFilter::getSupportRadius() const { return pixelsWithin(2 * sigma_); }

std::unique_ptr<const Filter> makeFilter(const SamplingOptions& options) {
  using Kind = SamplingOptions::FilterKind;
  switch (options.filter) {
    case Kind::tent:
      return std::make_unique<TentFilter>(options.filterSize);
    case Kind::gaussian:
      return std::make_unique<GaussianFilter>(options.filterSize);
    case Kind::box:
      break;
  }
  return std::make_unique<BoxFilter>(options.filterSize);
}
