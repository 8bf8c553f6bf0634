// Filters: weights against their formulas, how far they reach, and the picture of them.
#include <cmath>
#include <limits>

#include "check.h"
#include "render/film.h"

using Kind = SamplingOptions::FilterKind;

/// A filter of that kind and size as in 2003.
static Filter filterOf(Kind kind, double size) {
  SamplingOptions options;
  options.filter = kind;
  options.filterSize = size;
  return Filter(options);
}

static std::ostream& operator<<(std::ostream& out, Rgb8 value) {
  return out << int(value.r) << ' ' << int(value.g) << ' ' << int(value.b);
}

TEST("a box weighs 1 up to its radius in x and in y") {
  const Filter box = filterOf(Kind::box, 0.75);
  CHECK_EQUAL(box.getWeight(0, 0), 1.0);
  CHECK_EQUAL(box.getWeight(0.75, -0.75), 1.0);  // a square, and its border belongs to it
  CHECK_EQUAL(box.getWeight(0.76, 0), 0.0);
  CHECK_EQUAL(box.getWeight(0, -0.76), 0.0);
}

TEST("a tent falls evenly with the distance to 0 at its radius") {
  const Filter tent = filterOf(Kind::tent, 2);
  CHECK_EQUAL(tent.getWeight(0, 0), 1.0);
  CHECK_NEAR(tent.getWeight(0.6, -0.8), 0.5, 1e-15);  // distance 1 of 2
  CHECK_NEAR(tent.getWeight(-1.5, 0), 0.25, 1e-15);
  CHECK_EQUAL(tent.getWeight(0, 2), 0.0);
  CHECK_EQUAL(tent.getWeight(1.5, 1.5), 0.0);  // 2.12: round, not square
}

TEST("a gaussian is exp(-d^2 / (2 sigma^2)) up to 2 sigma") {
  const Filter gaussian = filterOf(Kind::gaussian, 0.5);
  CHECK_EQUAL(gaussian.getWeight(0, 0), 1.0);
  CHECK_NEAR(gaussian.getWeight(0.3, 0.4), std::exp(-0.5), 1e-15);  // d = sigma
  CHECK_NEAR(gaussian.getWeight(-0.6, 0.7), std::exp(-1.7), 1e-15);
  CHECK_NEAR(gaussian.getWeight(1, 0), std::exp(-2.0), 1e-15);
  CHECK_EQUAL(gaussian.getWeight(1.001, 0), 0.0);
  CHECK_EQUAL(gaussian.getWeight(0.75, 0.75), 0.0);
}

TEST("a gaussian that is not cut counts at any distance, but from the same pixels") {
  SamplingOptions options;
  options.filter = Kind::gaussian;
  options.filterSize = 0.5;
  options.gaussianCut = std::numeric_limits<double>::infinity();
  const Filter gaussian(options);
  CHECK_NEAR(gaussian.getWeight(1, 1), std::exp(-4.0), 1e-15);  // d = 2.83 sigma
  CHECK_NEAR(gaussian.getWeight(1.5, 0), std::exp(-4.5), 1e-15);
  CHECK_EQUAL(gaussian.getSupportRadius(), 1);  // ceil(2 sigma - 1/2)
}

TEST("in single precision a box holds what a double is too large for") {
  SamplingOptions options;
  options.filterSize = 0.1;
  const double beyond = 0.1 + 1e-12;  // the same float as 0.1
  CHECK_EQUAL(Filter(options).getWeight(beyond, 0), 0.0);
  options.isFilterSingle = true;
  CHECK_EQUAL(Filter(options).getWeight(beyond, -beyond), 1.0);
  CHECK_EQUAL(Filter(options).getWeight(0.1001, 0), 0.0);
}

TEST("a filter reaches the pixels whose samples may be within its radius") {
  // Samples of a pixel d to the side begin d - 0.5 away.
  const struct {
    double radius;
    int reach;
  } cases[] = {{0.1, 0}, {0.5, 0}, {0.51, 1}, {1, 1}, {1.5, 1}, {1.51, 2}, {32, 32}};
  for (const auto& [radius, reach] : cases) {
    CHECK_EQUAL(filterOf(Kind::box, radius).getSupportRadius(), reach);
    CHECK_EQUAL(filterOf(Kind::tent, radius).getSupportRadius(), reach);
    CHECK_EQUAL(filterOf(Kind::gaussian, radius / 2).getSupportRadius(), reach);
  }
}

TEST("a filter too narrow for numbers weighs nothing rather than NaN") {
  for (const double size : {1e-300, 1e-200, 1e-160}) {
    CHECK_EQUAL(filterOf(Kind::gaussian, size).getWeight(0.25, 0.25), 0.0);
    CHECK_EQUAL(filterOf(Kind::tent, size).getWeight(0.25, 0.25), 0.0);
    CHECK_EQUAL(filterOf(Kind::box, size).getWeight(0.25, 0.25), 0.0);
    CHECK(filterOf(Kind::gaussian, size).getWeight(0, 0) >= 0);
  }
}

TEST("the picture of a filter has its weights around the middle pixel, and a grid") {
  // 5 x 3 pixels, 8 times: the middle one begins at (16, 8), its centre is at (20, 12).
  const Image picture = drawFilter(filterOf(Kind::tent, 1), 5, 3, 8);
  CHECK_EQUAL(picture.Width(), 41);
  CHECK_EQUAL(picture.Height(), 25);
  CHECK_EQUAL(picture.getPixel(20, 12), (Rgb8{255, 255, 255}));
  CHECK_EQUAL(picture.getPixel(22, 12), (Rgb8{191, 191, 191}));  // 2/8 away: 0.75 x 255 = 191.25
  CHECK_EQUAL(picture.getPixel(20, 18), (Rgb8{63, 63, 63}));     // 6/8 away: 63.75
  CHECK_EQUAL(picture.getPixel(9, 1), Rgb8());                   // within reach, but weight 0
  CHECK_EQUAL(picture.getPixel(2, 12), (Rgb8{0, 0, 127}));       // two pixels off: beyond
  for (int line = 0; line <= 40; line += 8) {
    CHECK_EQUAL(picture.getPixel(line, 3), (Rgb8{0, 0, 255}));
    if (line <= 24) CHECK_EQUAL(picture.getPixel(3, line), (Rgb8{0, 0, 255}));
  }
}
