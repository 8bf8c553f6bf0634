// Filters: weights against their formulas, how far they reach, and the picture of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
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

namespace {

constexpr int kSide = 9;  // cells along the side of a picture of 3 x 3 pixels
using Cells = std::array<std::array<double, kSide>, kSide>;

/// Each row convolved with the five weights, the cells at its ends repeated.
Cells rowsBlurred(const Cells& cells) {
  constexpr double kWeights[] = {.1201, .2339, .2931, .2339, .1201};
  Cells blurred{};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (int k = -2; k <= 2; ++k)
        blurred[y][x] += kWeights[k + 2] * cells[y][std::clamp(x + k, 0, kSide - 1)];
  return blurred;
}

Cells transposed(const Cells& cells) {
  Cells turned{};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) turned[x][y] = cells[y][x];
  return turned;
}

SamplingOptions blurringCells() {
  SamplingOptions options;
  options.filter = Kind::blurredCells;
  return options;
}

/// The pixels of `area` of the 3 x 3 whose cells have one sample each, in their middles.
Film filmOf(const Cells& cells, const PixelRectangle& area) {
  Film film(area, Filter(blurringCells()), {0, 0, 3, 3});
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const auto grey = float(cells[y][x]);
      film.addSample({{x / 3, y / 3}, {(x % 3 + 0.5) / 3, (y % 3 + 0.5) / 3}}, {grey, grey, grey},
                     1);
    }
  }
  return film;
}

}  // namespace

TEST("blurred cells weigh by their distance in cells, as far as three") {
  const Filter filter{blurringCells()};
  CHECK_EQUAL(filter.getSupportRadius(), 1);
  const double weights[] = {0.2339 + 0.2931 + 0.2339, 0.1201 + 0.2339 + 0.2931, 0.1201 + 0.2339,
                            0.1201, 0};
  for (int cell = -4; cell <= 4; ++cell) {
    for (const double within : {-0.16, 0.0, 0.16}) {
      CHECK_NEAR(filter.getWeight(cell / 3.0 + within, 0), weights[std::abs(cell)] * weights[0],
                 1e-15);
      CHECK_NEAR(filter.getWeight(1 / 3.0, cell / 3.0 + within),
                 weights[1] * weights[std::abs(cell)], 1e-15);
    }
  }
}

TEST("an impulse in the middle, and one in a corner, whose edges are repeated") {
  Cells middle{}, corner{};
  middle[4][4] = corner[0][0] = 1;
  // Of each axis a third of what the three cells of the pixel get, over the sum of the weights.
  const double own = 0.7609 / 3 / 1.0011, beside = 0.1201 / 3 / 1.0011;
  const PixelRectangle all = {0, 0, 3, 3};
  const Film inner = filmOf(middle, all);
  CHECK_NEAR(inner.getColor({1, 1}).r(), own * own, 1e-7);
  CHECK_NEAR(inner.getColor({0, 1}).r(), own * beside, 1e-7);
  CHECK_NEAR(inner.getColor({2, 2}).r(), beside * beside, 1e-7);
  // The corner's cell stands for all below and to the left: distances 1, 2, 3 from the middle cell.
  const double edge = (0.6471 + 0.354 + 0.1201) / 3 / 1.0011;
  const Film outer = filmOf(corner, all);
  CHECK_NEAR(outer.getColor({0, 0}).r(), edge * edge, 1e-7);
  CHECK_EQUAL(outer.getColor({1, 0}).r(), 0.0f);  // its nearest cell is 4 from its middle one
}

TEST("blurred cells are rows and columns convolved, then blocks averaged, in parts as in a whole") {
  double sums[3][3] = {};
  for (int impulse = 0; impulse < kSide * kSide; ++impulse) {
    Cells cells{};
    cells[impulse / kSide][impulse % kSide] = 1;
    const Cells blurred = transposed(rowsBlurred(transposed(rowsBlurred(cells))));
    const Film whole = filmOf(cells, {0, 0, 3, 3});
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        double block = 0;
        for (int k = 0; k < 9; ++k) block += blurred[3 * j + k / 3][3 * i + k % 3] / 9;
        const Vec3f color = whole.getColor({i, j});
        CHECK_NEAR(color.r(), block / (1.0011 * 1.0011), 1e-7);
        CHECK(filmOf(cells, {i, j, i + 1, j + 1}).getColor({i, j}) == color);
        sums[j][i] += color.r();
      }
    }
  }
  for (const auto& row : sums)
    for (const double sum : row) CHECK_NEAR(sum, 1, 1e-6);
}
