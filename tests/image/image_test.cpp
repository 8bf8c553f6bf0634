// Image: the byte rule, pixels, differences.
#include "image/image.h"

#include <limits>
#include <stdexcept>

#include "check.h"
#include "image_difference.h"

namespace {

int byteOf(float component) { return byteFromComponent(component); }

}  // namespace

TEST("a byte is the component times 255, truncated") {
  CHECK_EQUAL(byteOf(0), 0);
  CHECK_EQUAL(byteOf(1), 255);
  CHECK_EQUAL(byteOf(0.1f), 25);          // 25.5: rounding would give 26 (or 25, to even)
  CHECK_EQUAL(byteOf(0.5f), 127);         // 127.5: rounding gives 128
  CHECK_EQUAL(byteOf(0.999f), 254);       // 254.7: rounding gives 255
  CHECK_EQUAL(byteOf(1 / 255.0f), 1);     // 1/255 rounds up in float: 0x1.010102p-8
  CHECK_EQUAL(byteOf(0.003f), 0);         // 0.765
  CHECK_EQUAL(byteOf(0.99999994f), 254);  // the float before 1: 255 - 255/2^24 is below 255
}

TEST("a byte is clamped, and NaN is 0") {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  CHECK_EQUAL(byteOf(-0.5f), 0);
  CHECK_EQUAL(byteOf(-kInfinity), 0);
  CHECK_EQUAL(byteOf(-0.0f), 0);
  CHECK_EQUAL(byteOf(1.00001f), 255);
  CHECK_EQUAL(byteOf(1.01f), 255);  // 257.55 would wrap to 1
  CHECK_EQUAL(byteOf(3e38f), 255);  // overflows to infinity
  CHECK_EQUAL(byteOf(kInfinity), 255);
  CHECK_EQUAL(byteOf(std::numeric_limits<float>::quiet_NaN()), 0);
  CHECK_EQUAL(byteOf(std::numeric_limits<float>::denorm_min()), 0);
}

TEST("a colour becomes bytes channel by channel") {
  CHECK(bytesFromColor(Vec3f(1, 0.5f, 0)) == (Rgb8{255, 127, 0}));
}

TEST("a sample becomes the nearest byte, whatever its largest value") {
  // 255 s / m: 127 255 / 255; 1 255 / 2 = 127.5, upwards; 16 255 / 31 = 131.6; 257 255 / 65535 = 1.
  CHECK_EQUAL(int(byteFromSample(127, 255)), 127);
  CHECK_EQUAL(int(byteFromSample(1, 2)), 128);
  CHECK_EQUAL(int(byteFromSample(16, 31)), 132);
  CHECK_EQUAL(int(byteFromSample(257, 65535)), 1);
  CHECK_EQUAL(int(byteFromSample(65535, 65535)), 255);
}

TEST("an image begins black, and each pixel is a place of its own") {
  Image image(3, 2);
  CHECK_EQUAL(image.Width(), 3);
  CHECK_EQUAL(image.Height(), 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) CHECK(image.getPixel(x, y) == (Rgb8{0, 0, 0}));
  }
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) image.setPixel(x, y, Rgb8{std::uint8_t(x), std::uint8_t(y), 9});
  }
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      CHECK(image.getPixel(x, y) == (Rgb8{std::uint8_t(x), std::uint8_t(y), 9}));
    }
  }
}

TEST("setAllPixels fills the image by the byte rule") {
  Image image(2, 2);
  image.setAllPixels(Vec3f(0.5f, 2, -1));
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 2; ++x) CHECK(image.getPixel(x, y) == (Rgb8{127, 255, 0}));
  }
}

TEST("the difference of a pixel is the largest of its channel differences") {
  Image a(2, 2), b(2, 2);
  b.setPixel(0, 0, Rgb8{3, 1, 2});    // 3
  a.setPixel(1, 0, Rgb8{0, 9, 0});    // 9, the other way round
  b.setPixel(0, 1, Rgb8{0, 0, 255});  // 255
  b.setPixel(1, 1, Rgb8{0, 4, 0});    // 4
  const ImageDifference difference = compareImages(a, b);
  CHECK_EQUAL(difference.maximum(), 255);
  CHECK_NEAR(difference.mean(), (3 + 9 + 255 + 4) / 4.0, 0);
  CHECK_EQUAL(difference.pixels(), 4u);
  CHECK_EQUAL(difference.pixelsOver(0), 4u);
  CHECK_EQUAL(difference.pixelsOver(3), 3u);  // over, not at
  CHECK_EQUAL(difference.pixelsOver(8), 2u);
  CHECK_EQUAL(difference.pixelsOver(9), 1u);
  CHECK_EQUAL(difference.pixelsOver(254), 1u);
  CHECK_EQUAL(difference.pixelsOver(255), 0u);
  CHECK_EQUAL(difference.pixelsOver(1000), 0u);
}

TEST("equal images have no difference, and sizes must agree") {
  const Image a(3, 2);
  CHECK_EQUAL(compareImages(a, a).maximum(), 0);
  CHECK_EQUAL(compareImages(a, a).mean(), 0.0);
  CHECK_EQUAL(compareImages(a, a).pixelsOver(0), 0u);
  CHECK_EQUAL(ImageDifference().mean(), 0.0);
  CHECK_THROWS(compareImages(a, Image(2, 3)), std::invalid_argument);
  CHECK_THROWS(compareImages(a, Image(3, 3)), std::invalid_argument);
}
