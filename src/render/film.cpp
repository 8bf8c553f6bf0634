// Filters, the film, and the pictures of filters and samples.
//
// A filter is a function of the place and of one size: a box, 1 in a square around the centre, its
// border included; a tent, really a cone, 1 - d / size at the distance d; or a gaussian,
// exp(-d^2 / (2 size^2)) up to d = 2 size, and 0 beyond, unless it is not to be cut. A sample is
// splatted: added to every pixel within the filter's reach with the weight that it has as seen from
// there, so a film needs each sample once and keeps none. Colours and places of the two pictures
// are those of the course's own: MIT 6.837, "Supersampling and Antialiasing", 2004.
#include "render/film.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "math/functions.h"

namespace {

using FilterKind = SamplingOptions::FilterKind;

/// A pixel d to the side has samples from d - 0.5 to d + 0.5 away.
int pixelsWithin(double radius) { return int(std::ceil(std::max(0.0, radius - 0.5))); }

constexpr Vec3f kBeyond(0, 0, 0.5f), kLine(0, 0, 1);

/// The whole number below a coordinate within a pixel, counted in enlarged pixels.
int placeOf(double offset, int zoom) { return std::min(int(offset * zoom), zoom - 1); }

}  // namespace

Filter::Filter(const SamplingOptions& options)
    : kind_(options.filter),
      size_(options.filterSize),
      cut_(options.gaussianCut),
      isSingle_(options.isFilterSingle),
      supportRadius_(pixelsWithin(kind_ == FilterKind::gaussian ? 2 * size_ : size_)) {}

double Filter::getWeight(double x, double y) const {
  const double squared = x * x + y * y;
  switch (kind_) {
    case FilterKind::box:
      if (isSingle_) return float(std::max(std::fabs(x), std::fabs(y))) <= float(size_) ? 1 : 0;
      return std::fabs(x) <= size_ && std::fabs(y) <= size_ ? 1 : 0;
    case FilterKind::tent:
      return std::max(0.0, 1 - std::sqrt(squared) / size_);
    case FilterKind::gaussian:
      break;
  }
  const double ratio = squared / (size_ * size_);
  return ratio <= cut_ * cut_ ? math::exp(-ratio / 2)
                              : 0;  // 0 / 0, where sigma^2 underflows, is beyond
}

Film::Film(const PixelRectangle& area, const Filter& filter)
    : area_(area), filter_(filter), filtered_(area.pixelCount()), own_(area.pixelCount()) {}

void Film::addSample(const Sample& sample, const Vec3f& color, double share) {
  const auto [at, offset] = sample;
  const int reach = filter_.getSupportRadius();
  const int left = std::max(at.i - reach, area_.left),
            right = std::min(at.i + reach + 1, area_.right);
  const int bottom = std::max(at.j - reach, area_.bottom),
            top = std::min(at.j + reach + 1, area_.top);
  for (int j = bottom; j < top; ++j) {
    for (int i = left; i < right; ++i) {
      // Whole numbers are subtracted first: the weight is the same wherever the pixels are.
      const double weight =
          filter_.getWeight(at.i - i + (offset.x() - 0.5), at.j - j + (offset.y() - 0.5));
      if (weight > 0) filtered_[area_.index({i, j})].add(color, weight * share);
    }
  }
  if (area_.contains(at)) own_[area_.index(at)].add(color, share);
}

Vec3f Film::getColor(Pixel at) const {
  const Sum& filtered = filtered_[area_.index(at)];
  const Sum& sum = filtered.weight > 0 ? filtered : own_[area_.index(at)];
  return Vec3f(sum.color / sum.weight);
}

Image drawFilter(const Filter& filter, int width, int height, int zoom) {
  const int reach = filter.getSupportRadius();
  Image image(width * zoom + 1, height * zoom + 1);
  for (int y = 0; y < image.Height(); ++y) {
    const int j = y / zoom - height / 2;  // the pixel's place, counted from the middle one
    for (int x = 0; x < image.Width(); ++x) {
      const int i = x / zoom - width / 2;
      if (x % zoom == 0 || y % zoom == 0) {
        image.setPixel(x, y, kLine);
      } else if (std::abs(i) > reach || std::abs(j) > reach) {
        image.setPixel(x, y, kBeyond);
      } else {
        const auto weight = float(
            filter.getWeight(i + double(x % zoom) / zoom - 0.5, j + double(y % zoom) / zoom - 0.5));
        image.setPixel(x, y, Vec3f(weight, weight, weight));
      }
    }
  }
  return image;
}

void drawSamplesGround(Image& picture, int zoom, const PixelRectangle& area) {
  for (int y = area.bottom * zoom; y < area.top * zoom; ++y) {
    for (int x = area.left * zoom; x < area.right * zoom; ++x) {
      const float grey = (x / zoom + y / zoom) % 2 == 0 ? 0.2f : 0.0f;
      picture.setPixel(x, y, Vec3f(grey, grey, grey));
    }
  }
}

void drawSample(Image& picture, int zoom, const Sample& sample, const Vec3f& color) {
  picture.setPixel(sample.at.i * zoom + placeOf(sample.offset.x(), zoom),
                   sample.at.j * zoom + placeOf(sample.offset.y(), zoom), color);
}
