// Comparison: figures worked out by hand.
#include "image/comparison.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "check.h"

namespace {

/// 4 x 3 black pixels; (x, y) from the top left.
Image blackBut(int x, int y, Rgb8 pixel) {
  Image image(4, 3);
  image.setPixel(x, 2 - y, pixel);
  return image;
}

}  // namespace

TEST("figures of two pictures that differ in one sample") {
  const Comparison c = compare(Image(4, 3), blackBut(2, 1, {0, 30, 0}), 1);
  CHECK_EQUAL(c.maximum, 30);
  CHECK_NEAR(c.mean, 30 / 36.0, 1e-15);
  CHECK_NEAR(c.rms, std::sqrt(900 / 36.0), 1e-14);   // 5
  CHECK_NEAR(c.psnr, 20 * std::log10(51.0), 1e-12);  // 255 / 5
  CHECK_EQUAL(c.pixels, 12u);
  CHECK_EQUAL(c.pixelsOver, 1u);
  CHECK_NEAR(c.percentOver(), 100 / 12.0, 1e-13);
  CHECK_EQUAL(c.worstX, 2);
  CHECK_EQUAL(c.worstY, 1);
  CHECK_EQUAL(c.boxX, 2);
  CHECK_EQUAL(c.boxY, 1);
  CHECK_EQUAL(c.boxWidth, 1);
  CHECK_EQUAL(c.boxHeight, 1);
}

TEST("a difference is over the tolerance when it is greater, and the box is around those") {
  Image actual = blackBut(0, 0, {5, 0, 0});
  actual.setPixel(3, 2 - 1, Rgb8{0, 0, 9});
  actual.setPixel(1, 2 - 2, Rgb8{0, 9, 6});
  const Comparison all = compare(Image(4, 3), actual, 4);
  CHECK_EQUAL(all.pixelsOver, 3u);
  CHECK_EQUAL(all.boxX + all.boxY, 0);
  CHECK_EQUAL(all.boxWidth, 4);
  CHECK_EQUAL(all.boxHeight, 3);
  const Comparison c = compare(actual, Image(4, 3), 5);
  CHECK_EQUAL(c.pixelsOver, 2u);
  CHECK_EQUAL(c.worstX, 3);  // the first of two with 9
  CHECK_EQUAL(c.worstY, 1);
  CHECK_EQUAL(c.boxX, 1);
  CHECK_EQUAL(c.boxY, 1);
  CHECK_EQUAL(c.boxWidth, 3);
  CHECK_EQUAL(c.boxHeight, 2);
  CHECK_EQUAL(compare(Image(4, 3), actual, 9).pixelsOver, 0u);
  CHECK_EQUAL(compare(Image(4, 3), actual, 9).boxWidth, 0);
  CHECK_EQUAL(compare(Image(4, 3), actual, 255).maximum, 9);
}

TEST("equal pictures have an infinite PSNR, and black and white one of 0") {
  const Comparison equal = compare(Image(4, 3), Image(4, 3), 0);
  CHECK_EQUAL(equal.psnr, std::numeric_limits<double>::infinity());
  CHECK_EQUAL(equal.mean + equal.rms + equal.maximum, 0.0);
  CHECK_EQUAL(equal.worstX + equal.worstY, 0);
  Image white(4, 3);
  white.setAllPixels(Vec3f(1, 1, 1));
  const Comparison opposite = compare(Image(4, 3), white, 0);
  CHECK_NEAR(opposite.psnr, 0, 1e-12);
  CHECK_EQUAL(opposite.mean, 255.0);
  CHECK_EQUAL(opposite.percentOver(), 100.0);
  CHECK_THROWS(compare(Image(4, 3), Image(3, 4), 0), std::invalid_argument);
  CHECK_THROWS(compare(Image(4, 3), Image(4, 4), 0), std::invalid_argument);
}

TEST("the picture of differences is 16 times as large, and magenta where one picture ends") {
  const Image d = differencePicture(blackBut(1, 0, {15, 16, 3}), blackBut(1, 0, {0, 0, 4}));
  CHECK(d.getPixel(1, 2) == (Rgb8{240, 255, 16}));
  CHECK(d.getPixel(0, 0) == (Rgb8{0, 0, 0}));
  const Image e = differencePicture(Image(2, 1), Image(1, 3));
  CHECK_EQUAL(e.Width(), 2);
  CHECK_EQUAL(e.Height(), 3);
  CHECK(e.getPixel(0, 2) == (Rgb8{0, 0, 0}));      // both, at the top left
  CHECK(e.getPixel(1, 2) == (Rgb8{255, 0, 255}));  // the first alone
  CHECK(e.getPixel(0, 0) == (Rgb8{255, 0, 255}));  // the second alone
  CHECK(e.getPixel(1, 0) == (Rgb8{0, 0, 0}));      // neither
}
