// The weighted sums of samples.
#include "render/film.h"

#include <algorithm>

Film::Film(const PixelRectangle& area, const Filter& filter)
    : area_(area),
      filter_(filter),
      reach_(filter.getSupportRadius()),
      filtered_(area.pixelCount()),
      own_(area.pixelCount()) {}

void Film::addSample(Pixel at, const Vec2d& offset, const Vec3f& color, double share) {
  const int left = std::max(at.i - reach_, area_.left),
            right = std::min(at.i + reach_ + 1, area_.right);
  const int bottom = std::max(at.j - reach_, area_.bottom),
            top = std::min(at.j + reach_ + 1, area_.top);
  for (int j = bottom; j < top; ++j) {
    for (int i = left; i < right; ++i) {
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
