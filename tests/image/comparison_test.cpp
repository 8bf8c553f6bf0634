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

/// Of pictures in bytes.
Comparison compareImages(const Image& expected, const Image& actual, int tolerance) {
  return compare({expected}, {actual}, tolerance);
}

}  // namespace

TEST("figures of two pictures that differ in one sample") {
  const Comparison c = compareImages(Image(4, 3), blackBut(2, 1, {0, 30, 0}), 1);
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
  const Comparison all = compareImages(Image(4, 3), actual, 4);
  CHECK_EQUAL(all.pixelsOver, 3u);
  CHECK_EQUAL(all.boxX + all.boxY, 0);
  CHECK_EQUAL(all.boxWidth, 4);
  CHECK_EQUAL(all.boxHeight, 3);
  const Comparison c = compareImages(actual, Image(4, 3), 5);
  CHECK_EQUAL(c.pixelsOver, 2u);
  CHECK_EQUAL(c.worstX, 3);  // the first of two with 9
  CHECK_EQUAL(c.worstY, 1);
  CHECK_EQUAL(c.boxX, 1);
  CHECK_EQUAL(c.boxY, 1);
  CHECK_EQUAL(c.boxWidth, 3);
  CHECK_EQUAL(c.boxHeight, 2);
  CHECK_EQUAL(compareImages(Image(4, 3), actual, 9).pixelsOver, 0u);
  CHECK_EQUAL(compareImages(Image(4, 3), actual, 9).boxWidth, 0);
  CHECK_EQUAL(compareImages(Image(4, 3), actual, 255).maximum, 9);
}

TEST("equal pictures have an infinite PSNR, and black and white one of 0") {
  const Comparison equal = compareImages(Image(4, 3), Image(4, 3), 0);
  CHECK_EQUAL(equal.psnr, std::numeric_limits<double>::infinity());
  CHECK_EQUAL(equal.mean + equal.rms + equal.maximum, 0.0);
  CHECK_EQUAL(equal.worstX + equal.worstY, 0);
  Image white(4, 3);
  white.setAllPixels(Vec3f(1, 1, 1));
  const Comparison opposite = compareImages(Image(4, 3), white, 0);
  CHECK_NEAR(opposite.psnr, 0, 1e-12);
  CHECK_EQUAL(opposite.mean, 255.0);
  CHECK_EQUAL(opposite.percentOver(), 100.0);
  CHECK_THROWS(compareImages(Image(4, 3), Image(3, 4), 0), std::invalid_argument);
  CHECK_THROWS(compareImages(Image(4, 3), Image(4, 4), 0), std::invalid_argument);
}

TEST("the picture of differences is 16 times as large, and magenta where one picture ends") {
  const Image d = differencePicture({blackBut(1, 0, {15, 16, 3})}, {blackBut(1, 0, {0, 0, 4})});
  CHECK(d.getPixel(1, 2) == (Rgb8{240, 255, 16}));
  CHECK(d.getPixel(0, 0) == (Rgb8{0, 0, 0}));
  const Image e = differencePicture({Image(2, 1)}, {Image(1, 3)});
  CHECK_EQUAL(e.Width(), 2);
  CHECK_EQUAL(e.Height(), 3);
  CHECK(e.getPixel(0, 2) == (Rgb8{0, 0, 0}));      // both, at the top left
  CHECK(e.getPixel(1, 2) == (Rgb8{255, 0, 255}));  // the first alone
  CHECK(e.getPixel(0, 0) == (Rgb8{255, 0, 255}));  // the second alone
  CHECK(e.getPixel(1, 0) == (Rgb8{0, 0, 0}));      // neither
}

TEST("floats are compared as floats where both pictures have them") {
  const auto pixel = [](float value) {
    ReadPicture picture{Image(1, 1), FloatImage(1, 1)};
    picture.image.setPixel(0, 0, Vec3f(value, value, value));
    picture.exact.setPixel(0, 0, Vec3f(value, value, value));
    return picture;
  };
  const auto maximum = [&](float e, float a) { return compare(pixel(e), pixel(a), 1).maximum; };
  constexpr float kInf = std::numeric_limits<float>::infinity(), kNaN = std::nanf("");
  CHECK_NEAR(maximum(0, 0.25f), 63.75, 1e-9);  // absolute up to 1
  CHECK_NEAR(maximum(-1, 0), 255, 1e-9);
  CHECK_NEAR(maximum(2, 3), 127.5, 1e-9);  // relative above
  CHECK_NEAR(maximum(100, 101), 2.55, 1e-9);
  CHECK_EQUAL(maximum(kNaN, kNaN) + maximum(kInf, kInf) + maximum(-kInf, -kInf), 0.0);
  CHECK(std::isinf(maximum(kNaN, 0)) && std::isinf(maximum(0, kNaN)) &&
        std::isinf(maximum(kInf, 0)));
  CHECK(std::isinf(maximum(kInf, -kInf)) && std::isinf(maximum(1, kInf)));
  CHECK_EQUAL(compare(pixel(kNaN), pixel(0), 255).pixelsOver, 1u);
  // Beside a picture of bytes they count as bytes.
  ReadPicture bytes = pixel(1);
  bytes.exact = FloatImage();
  CHECK_EQUAL(compare(pixel(3), bytes, 0).maximum, 0.0);
  CHECK(differencePicture(pixel(2), pixel(3)).getPixel(0, 0) == (Rgb8{255, 255, 255}));
  CHECK(differencePicture(pixel(kNaN), pixel(kNaN)).getPixel(0, 0) == Rgb8());
}
