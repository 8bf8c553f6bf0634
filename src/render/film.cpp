// Filters, the film, and the pictures of filters and samples.
//
// A filter is a function of the place and of one size: a box, 1 in a square around the centre, its
// border included; a tent, really a cone, 1 - d / size at the distance d; or a gaussian,
// exp(-d^2 / (2 size^2)) up to d = 2 size, and 0 beyond, unless it is not to be cut.
//
// That of cells is what becomes of a sample for each cell of a third of a pixel when every row of
// cells, then every column, is convolved with five weights and the cells of a pixel are averaged:
// along each axis the pixel takes 1/3 of the five weights around each of its three cells, in all
// seven, by the distance from the middle cell. Beyond the edges of the picture the outermost cells
// are repeated: the sample of such a cell is added at their places too.
//
// A sample is splatted: added to every pixel within the filter's reach with the weight that it has
// as seen from there, so a film needs each sample once and keeps none. Colours and places of the
// two pictures are those of the course's own: MIT 6.837, "Supersampling and Antialiasing", 2004.
#include "render/film.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "math/functions.h"

namespace {

using FilterKind = SamplingOptions::FilterKind;

/// A pixel d to the side has samples from d - 0.5 to d + 0.5 away.
int pixelsWithin(double radius) { return int(std::ceil(std::max(0.0, radius - 0.5))); }

constexpr Vec3f kBeyond(0, 0, 0.5f), kLine(0, 0, 1);

constexpr int kCells = SamplingOptions::kCells;
/// Three times what a cell counts for a pixel, by its distance from the pixel's middle cell. The
/// five weights are .1201 .2339 .2931 .2339 .1201; their sum, 1.0011, is divided by as all are.
constexpr double kCellWeights[] = {0.2339 + 0.2931 + 0.2339, 0.1201 + 0.2339 + 0.2931,
                                   0.1201 + 0.2339, 0.1201};

/// `place` is the distance from the pixel's centre, in pixels.
double cellWeight(double place) {
  const auto cell = std::size_t(std::fabs(std::floor(place * kCells + 0.5)));
  return cell < std::size(kCellWeights) ? kCellWeights[cell] : 0;
}

/// A coordinate of a sample: the pixel, and from 0 to 1 in it.
struct Coordinate {
  int pixel;
  double offset;
};

/// One of a sample in the picture, along a side of which the pixels from <= pixel < to are; and,
/// where its cell is the first or last one there, the middles of the cells of the pixel beyond.
std::vector<Coordinate> repeated(const Coordinate& own, int from, int to) {
  std::vector<Coordinate> all = {own};
  for (int cell = 0; cell < kCells; ++cell) {
    const double middle = (cell + 0.5) / kCells;
    if (own.pixel == from && own.offset * kCells < 1) all.push_back({from - 1, middle});
    if (own.pixel == to - 1 && own.offset * kCells >= kCells - 1) all.push_back({to, middle});
  }
  return all;
}

/// The whole number below a coordinate within a pixel, counted in enlarged pixels.
int placeOf(double offset, int zoom) { return std::min(int(offset * zoom), zoom - 1); }

}  // namespace

Filter::Filter(const SamplingOptions& options)
    : options_(options),
      supportRadius_(repeatsEdges() ? 1
                                    : pixelsWithin(options.filter == FilterKind::gaussian
                                                       ? 2 * options.filterSize
                                                       : options.filterSize)) {}

double Filter::getWeight(double x, double y) const {
  const double squared = x * x + y * y, size = options_.filterSize;
  switch (options_.filter) {
    case FilterKind::box: {
      const double distance = std::max(std::fabs(x), std::fabs(y));
      const bool isSingle = options_.isFilterSingle;
      return (isSingle ? float(distance) <= float(size) : distance <= size) ? 1 : 0;
    }
    case FilterKind::tent:
      return std::max(0.0, 1 - std::sqrt(squared) / size);
    case FilterKind::blurredCells:
      return cellWeight(x) * cellWeight(y);
    case FilterKind::gaussian:
      break;
  }
  const double ratio = squared / (size * size);  // 0 / 0, where sigma^2 underflows, is beyond
  return ratio <= options_.gaussianCut * options_.gaussianCut ? math::exp(-ratio / 2) : 0;
}

Film::Film(const PixelRectangle& area, const Filter& filter, const PixelRectangle& picture)
    : area_(area),
      picture_(picture),
      filter_(filter),
      filtered_(area.pixelCount()),
      own_(area.pixelCount()) {}

void Film::addSample(const Sample& sample, const Vec3f& color, double share) {
  if (!filter_.repeatsEdges()) return addAt(sample, color, share);
  const auto [at, offset] = sample;
  for (const Coordinate& y : repeated({at.j, offset.y()}, picture_.bottom, picture_.top)) {
    for (const Coordinate& x : repeated({at.i, offset.x()}, picture_.left, picture_.right)) {
      addAt({{x.pixel, y.pixel}, {x.offset, y.offset}}, color, share);
    }
  }
}

void Film::addAt(const Sample& sample, const Vec3f& color, double share) {
  const auto [at, offset] = sample;
  const int reach = filter_.getSupportRadius();
  const PixelRectangle near =
      PixelRectangle{at.i, at.j, at.i + 1, at.j + 1}.grown(reach).within(area_);
  for (int j = near.bottom; j < near.top; ++j) {
    for (int i = near.left; i < near.right; ++i) {
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
