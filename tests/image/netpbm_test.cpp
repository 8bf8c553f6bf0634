// PPM and PFM: the bytes that are written, every kind that is read, and every way to be at fault.
#include <limits>

#include "check.h"
#include "encoded.h"
#include "random.h"

namespace {

Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }
std::string textOf(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

std::string shown(const Image& image) {
  std::string text;
  for (int y = image.Height() - 1; y >= 0; --y) {
    for (int x = 0; x < image.Width(); ++x) {
      const Rgb8 p = image.getPixel(x, y);
      text += std::to_string(p.r) + " " + std::to_string(p.g) + " " + std::to_string(p.b) + ";";
    }
    text += "/";
  }
  return text;
}

std::string decode(const std::string& text) { return shown(decodeNetpbm(bytesOf(text), "a.ppm")); }

std::string faultOf(const std::string& text) {
  try {
    decode(text);
  } catch (const ImageError& error) {
    return error.what();
  }
  return "";
}

void checkFault(const std::string& text, const std::string& part) {
  const std::string fault = faultOf(text);
  check::report(fault.find(part) != std::string::npos, __FILE__, __LINE__,
                "'" + fault + "' contains '" + part + "'");
}

using namespace std::string_literals;

/// Two columns, two rows: in the order of reading 1, 2, 3, 4 in red.
Image fourPixels() {
  Image image(2, 2);
  image.setPixel(0, 1, Rgb8{1, 10, 255});
  image.setPixel(1, 1, Rgb8{2, 0, 0});
  image.setPixel(0, 0, Rgb8{3, 0, 0});
  image.setPixel(1, 0, Rgb8{4, 0, 0});
  return image;
}

}  // namespace

TEST("a PPM is a head and RGB bytes, top row first") {
  CHECK(textOf(encoded::ppm(fourPixels())) ==
        "P6\n2 2\n255\n"
        "\x01\n\xff"
        "\x02\0\0\x03\0\0\x04\0\0"s);
}

TEST("a PFM is a head and unclamped floats, low byte and bottom row first") {
  FloatImage image(1, 2);
  image.setPixel(0, 0, Vec3f(1, -2, 0.5f));
  image.setPixel(0, 1, Vec3f(100, 0, std::numeric_limits<float>::infinity()));
  // IEEE 754: 1 is 3F800000, -2 C0000000, 0.5 3F000000, 100 = 1.5625 x 2^6 42C80000.
  CHECK(textOf(encoded::all([&](const Sink& sink) {
          encodePfm(
              1, 2, [&](int x, int y) { return image.getPixel(x, y); }, sink);
        })) ==
        "PF\n1 2\n-1\n"
        "\0\0\x80\x3f\0\0\0\xc0\0\0\0\x3f"
        "\0\0\xc8\x42\0\0\0\0\0\0\x80\x7f"s);
}

TEST("every kind of PPM, PGM and PFM is read") {
  CHECK_EQUAL(shown(decodeNetpbm(encoded::ppm(fourPixels()), "a")), shown(fourPixels()));
  CHECK_EQUAL(decode("P3 1 2 255 1 2 3\n4 5 6"), "1 2 3;/4 5 6;/");
  CHECK_EQUAL(decode("P2\n# a comment\n2 1 # another\n255\n7 8\n"), "7 7 7;8 8 8;/");
  CHECK_EQUAL(decode("P5 2 1 255\n\x07\x08"), "7 7 7;8 8 8;/");
  CHECK_EQUAL(decode("P6\r1\t1\v255\f\x01\x02\x03more"), "1 2 3;/");
  // The maximum is 255: 3 of 5 are 153; 5 of 15 are 85; 1 of 2 is 127.5, rounded to 128.
  CHECK_EQUAL(decode("P2 1 1 5 3"), "153 153 153;/");
  CHECK_EQUAL(decode("P5 1 1 15\n\x05"), "85 85 85;/");
  CHECK_EQUAL(decode("P2 1 1 2 1"), "128 128 128;/");
  // Two bytes, the high one first: 0x8000 of 65535 is 127.502.
  CHECK_EQUAL(decode("P5 1 1 65535\n\x80\x00"s), "128 128 128;/");
  // 1 and 0.5 (127.5, truncated) in both byte orders, bottom row first.
  CHECK_EQUAL(decode("Pf\n1 2\n-1.0\n\0\0\x80\x3f\0\0\0\x3f"s), "127 127 127;/255 255 255;/");
  CHECK_EQUAL(decode("Pf 1 2 1\n\x3f\x80\0\0\x3f\0\0\0"s), "127 127 127;/255 255 255;/");
  CHECK_EQUAL(decode("PF 1 1 -1\n\0\0\xc0\x7f\0\0\x80\x7f\0\0\0\xc0"s), "0 255 0;/");  // NaN is 0
}

TEST("a head that is at fault says what was expected") {
  checkFault("P6 0 1 255\n", "expected a width of 1 to");
  checkFault("P6 1 x", "expected a height of 1 to 2147483647, found none");
  checkFault("P6 1 99999999999999999999 255\n", "expected a height");
  checkFault("P6 1 1 0\n", "expected a maximum of 1 to 65535, found 0");
  checkFault("P6 1 1 65536\n", "maximum");
  checkFault("P6 1 1 255", "end of the head");
  checkFault("P6 1 1 255#\n\1\2\3", "line break behind the head");
  checkFault("PF 1 1 one\n", "scale");
  checkFault("P1 1 1 0", "P1 pictures are not supported");
  checkFault("P4 1 1 0", "not supported");
  checkFault("P7\n", "not supported");
  checkFault("P9\n", "expected a PPM or PFM file");
  checkFault("P6", "expected a PPM or PFM file");
  checkFault("P5 1 1 15\n\x10", "expected a sample of at most 15, found 16");
  checkFault("P2 1 1 15 16", "expected a sample of 0 to 15");
}

TEST("a picture that the file cannot hold is an error before memory is asked for") {
  checkFault("P6 2147483647 2147483647 255\n\1\2\3", "expected the data of");
  checkFault("P3 30000 30000 255 1 2 3", "expected the data of");
  checkFault("PF 65535 65535 -1\n", "expected the data of");
  checkFault("P6 1 1 255\n\1\2", "expected the data of 1 x 1 pixels, found 2 bytes");
  checkFault("P3 1 1 255\n1 2 ", "expected");
}

TEST("random damage of a file ends in an error or a picture") {
  Random random(31);
  const std::string files[] = {textOf(encoded::ppm(fourPixels())), "P3 2 1 99\n1 2 3 4 5 6\n",
                               "Pf 2 1 -1\n\0\0\x80\x3f\0\0\0\x3f"s};
  int refused = 0;
  for (int round = 0; round < 30000; ++round) {
    std::string file = files[round % 3];
    for (int i = random.index(4); i >= 0; --i) {
      file[std::size_t(random.index(int(file.size())))] = char(random.index(256));
    }
    if (random.index(4) == 0) file.resize(std::size_t(random.index(int(file.size()))));
    refused += !faultOf(file).empty();
  }
  CHECK(refused > 3000 && refused < 29000);
}
