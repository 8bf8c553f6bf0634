// TGA: the bytes that are written, and every variant that is read.
#include <filesystem>
#include <fstream>

#include "check.h"
#include "encoded.h"
#include "image/output_file.h"
#include "image/picture_file.h"

namespace {

/// What a hand-made file differs in; the rest of the header is 0.
struct Variant {
  unsigned type = 2, width = 1, height = 1, depth = 24, descriptor = 0x20;
  Bytes rest = {};  // after the 18 header bytes
  Bytes id = {};
  unsigned mapType = 0, mapFirst = 0, mapLength = 0, mapDepth = 0;

  Bytes bytes() const {
    const auto low = [](unsigned value) { return std::uint8_t(value & 255); };
    const auto high = [](unsigned value) { return std::uint8_t(value >> 8); };
    Bytes file = {low(unsigned(id.size())),
                  low(mapType),
                  low(type),
                  low(mapFirst),
                  high(mapFirst),
                  low(mapLength),
                  high(mapLength),
                  low(mapDepth),
                  7,
                  1,
                  5,
                  2,  // origin: ignored
                  low(width),
                  high(width),
                  low(height),
                  high(height),
                  low(depth),
                  low(descriptor)};
    file.insert(file.end(), id.begin(), id.end());
    file.insert(file.end(), rest.begin(), rest.end());
    return file;
  }
};

Image decode(const Variant& variant) { return decodeTga(variant.bytes(), "a.tga"); }

std::string shown(Rgb8 p) {
  return std::to_string(p.r) + " " + std::to_string(p.g) + " " + std::to_string(p.b);
}

/// The pixels row by row, the top row first: "r g b, r g b / r g b, r g b".
std::string shown(const Image& image) {
  std::string text;
  for (int y = image.Height() - 1; y >= 0; --y) {
    for (int x = 0; x < image.Width(); ++x) {
      text += shown(image.getPixel(x, y)) + (x + 1 < image.Width() ? ", " : y > 0 ? " / " : "");
    }
  }
  return text;
}

std::string messageOf(const Variant& variant) {
  try {
    decode(variant);
  } catch (const ImageError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Every prefix that is shorter than the whole must be an ImageError.
void checkPrefixes(const Variant& variant) {
  const Bytes whole = variant.bytes();
  decodeTga(whole, "a.tga");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes prefix(whole.begin(), whole.begin() + std::ptrdiff_t(size));
    CHECK_THROWS(decodeTga(prefix, "prefix"), ImageError);
  }
}

}  // namespace

TEST("a 2 x 2 image is written as 18 header bytes and BGR, top row first") {
  Image image(2, 2);
  image.setPixel(0, 1, Rgb8{1, 2, 3});  // top left
  image.setPixel(1, 1, Rgb8{4, 5, 6});
  image.setPixel(0, 0, Rgb8{7, 8, 9});
  image.setPixel(1, 0, Rgb8{10, 11, 12});
  const Bytes expected = {0, 0,  2,    0, 0, 0, 0, 0, 0, 0, 0, 0, 2,  0,  2,
                          0, 24, 0x20, 3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10};
  CHECK(encoded::tga(image) == expected);
}

TEST("width and height are stored with the low byte first") {
  const Bytes bytes = encoded::tga(Image(258, 515));  // 2 + 1 * 256, 3 + 2 * 256
  CHECK(Bytes(bytes.begin() + 12, bytes.begin() + 16) == (Bytes{2, 1, 3, 2}));
  CHECK_EQUAL(bytes.size(), 18u + 3 * 258 * 515);
}

TEST("an image that is written and read again is the same") {
  Image image(65, 7);
  for (int i = 0; i < 65 * 7; ++i) {
    image.setPixel(i % 65, i / 65, Rgb8{std::uint8_t(i), std::uint8_t(i / 3), std::uint8_t(7 * i)});
  }
  const std::string path = check::temporaryFolder() + "/round_trip.tga";
  writePicture(image, path);
  CHECK_EQUAL(shown(readImage(path)), shown(image));
  CHECK_EQUAL(shown(readImage(path)), shown(image));
  CHECK_EQUAL(std::filesystem::file_size(path), 18u + 3 * 65 * 7);
}

TEST("an image too wide for 16 bits is an error, and writes nothing") {
  const std::string path = check::temporaryFolder() + "/too_wide.tga";
  std::filesystem::remove(path);
  CHECK_THROWS(writePicture(Image(65536, 1), path), OutputError);
  CHECK(!std::filesystem::exists(path));
  writePicture(Image(65535, 1), path);
  CHECK_EQUAL(readImage(path).Width(), 65535);
}

TEST("the descriptor says in which corner the pixels begin") {
  Variant v;
  v.width = v.height = 2;
  v.type = 3;
  v.depth = 8;
  v.rest = {1, 2, 3, 4};
  v.descriptor = 0x20;  // top left
  CHECK_EQUAL(shown(decode(v)), "1 1 1, 2 2 2 / 3 3 3, 4 4 4");
  v.descriptor = 0x00;  // bottom left
  CHECK_EQUAL(shown(decode(v)), "3 3 3, 4 4 4 / 1 1 1, 2 2 2");
  v.descriptor = 0x30;  // top right
  CHECK_EQUAL(shown(decode(v)), "2 2 2, 1 1 1 / 4 4 4, 3 3 3");
  v.descriptor = 0x10;  // bottom right
  CHECK_EQUAL(shown(decode(v)), "4 4 4, 3 3 3 / 2 2 2, 1 1 1");
}

TEST("true colour of 24 and 32 bits is BGR, alpha ignored") {
  Variant v;
  v.width = 2;
  v.rest = {10, 20, 30, 40, 50, 60};
  CHECK_EQUAL(shown(decode(v)), "30 20 10, 60 50 40");
  v.depth = 32;
  v.descriptor = 0x28;  // 8 bits of alpha
  v.rest = {10, 20, 30, 0, 40, 50, 60, 255};
  CHECK_EQUAL(shown(decode(v)), "30 20 10, 60 50 40");
}

TEST("true colour of 15 and 16 bits is five bits a channel, scaled by 255/31 and rounded") {
  Variant v;
  v.width = 3;
  // Red 1, green 2, blue 3: 1 << 10 | 2 << 5 | 3 = 0x0443. 255/31 = 8.23, 16.45, 24.68.
  // Red 31 alone, with the alpha bit: 0xFC00.  Green 15, blue 31: 0x01FF; 15 * 255/31 = 123.39.
  v.rest = {0x43, 0x04, 0x00, 0xFC, 0xFF, 0x01};
  for (const unsigned depth : {15u, 16u}) {
    v.depth = depth;
    CHECK_EQUAL(shown(decode(v)), "8 16 25, 255 0 0, 0 123 255");
  }
}

TEST("grey of 8 bits, and of 16 with alpha") {
  Variant v;
  v.type = 3;
  v.width = 2;
  v.depth = 8;
  v.rest = {0, 200};
  CHECK_EQUAL(shown(decode(v)), "0 0 0, 200 200 200");
  v.depth = 16;
  v.descriptor = 0x28;
  v.rest = {5, 255, 200, 0};
  CHECK_EQUAL(shown(decode(v)), "5 5 5, 200 200 200");
  v.descriptor = 0x20;
  CHECK(contains(messageOf(v), "found 16"));
}

TEST("a colour map has entries of 15, 16, 24 or 32 bits, and begins at its first-entry number") {
  Variant v;
  v.type = 1;
  v.width = 3;
  v.depth = 8;
  v.mapType = 1;
  v.mapLength = 2;
  v.mapFirst = 5;
  v.mapDepth = 24;
  v.rest = {1, 2, 3, 4, 5, 6, 6, 5, 6};  // two entries, three indices
  CHECK_EQUAL(shown(decode(v)), "6 5 4, 3 2 1, 6 5 4");
  v.mapDepth = 32;
  v.rest = {1, 2, 3, 99, 4, 5, 6, 99, 6, 5, 6};
  CHECK_EQUAL(shown(decode(v)), "6 5 4, 3 2 1, 6 5 4");
  v.rest = {0x00, 0x7C, 0x1F, 0x00, 6, 5, 6};  // red 31; blue 31
  for (const unsigned depth : {15u, 16u}) {
    v.mapDepth = depth;
    CHECK_EQUAL(shown(decode(v)), "0 0 255, 255 0 0, 0 0 255");
  }
}

TEST("colour indices may have 16 bits, but no more") {
  Variant v;
  v.type = 1;
  v.depth = 16;
  v.mapType = 1;
  v.mapLength = 1;
  v.mapFirst = 0x0201;
  v.mapDepth = 24;
  v.rest = {1, 2, 3, 0x01, 0x02};
  CHECK_EQUAL(shown(decode(v)), "3 2 1");
  v.depth = 24;
  CHECK(contains(messageOf(v), "expected 8 or 16 bits per colour index, found 24"));
}

TEST("a colour index outside the map is an error") {
  Variant v;
  v.type = 1;
  v.depth = 8;
  v.mapType = 1;
  v.mapLength = 2;
  v.mapFirst = 5;
  v.mapDepth = 24;
  for (const int index : {0, 4, 7, 255}) {
    v.rest = {1, 2, 3, 4, 5, 6, std::uint8_t(index)};
    CHECK(contains(messageOf(v),
                   "expected a colour index of 5 to below 7, found " + std::to_string(index)));
  }
}

TEST("the image ID and an unused colour map are skipped, a footer is ignored") {
  Variant v;
  v.id = {'h', 'e', 'l', 'l', 'o'};
  v.mapType = 1;
  v.mapLength = 2;
  v.mapDepth = 16;
  v.rest = {9, 9, 9, 9, 1, 2, 3};
  CHECK_EQUAL(shown(decode(v)), "3 2 1");
  for (int i = 0; i < 26; ++i) v.rest.push_back('F');
  CHECK_EQUAL(shown(decode(v)), "3 2 1");
}

TEST("run-length packets repeat or list pixels, and go on in the next row") {
  Variant v;
  v.type = 10;
  v.width = 3;
  v.height = 2;
  // 4 times (3 2 1): all of the first row and one pixel of the second; then 2 as they are.
  v.rest = {0x83, 1, 2, 3, 0x01, 4, 5, 6, 7, 8, 9};
  CHECK_EQUAL(shown(decode(v)), "3 2 1, 3 2 1, 3 2 1 / 3 2 1, 6 5 4, 9 8 7");
  v.type = 11;
  v.depth = 8;
  v.rest = {0x02, 1, 2, 3, 0x80, 4, 0x81, 5};
  CHECK_EQUAL(shown(decode(v)), "1 1 1, 2 2 2, 3 3 3 / 4 4 4, 5 5 5, 5 5 5");
  v.type = 9;
  v.mapType = 1;
  v.mapLength = 2;
  v.mapDepth = 24;
  v.rest = {1, 2, 3, 4, 5, 6, 0x84, 1, 0x00, 0};
  CHECK_EQUAL(shown(decode(v)), "6 5 4, 6 5 4, 6 5 4 / 6 5 4, 6 5 4, 3 2 1");
}

TEST("a packet holds up to 128 pixels, and no more than the image has left") {
  Variant v;
  v.type = 11;
  v.depth = 8;
  v.width = 128;
  v.rest = {0xFF, 77};
  CHECK_EQUAL(shown(decode(v).getPixel(127, 0)), "77 77 77");
  v.width = 127;
  CHECK(contains(messageOf(v), "expected a packet of at most 127 pixels at byte 18, found 128"));
}

TEST("a file cut off anywhere is an error") {
  Variant v;
  v.width = v.height = 2;
  v.id = {1, 2};
  v.rest = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  checkPrefixes(v);
  v.type = 10;
  v.rest = {0x81, 1, 2, 3, 0x01, 4, 5, 6, 7, 8, 9};
  checkPrefixes(v);
  v.type = 9;
  v.depth = 8;
  v.mapType = 1;
  v.mapLength = 2;
  v.mapDepth = 24;
  v.rest = {1, 2, 3, 4, 5, 6, 0x82, 1, 0x00, 0};
  checkPrefixes(v);
}

TEST("what is no TGA, or a kind that is not read, says what was expected and found") {
  Variant v;
  v.rest = Bytes(4, 0);
  const Variant good = v;
  for (const unsigned type : {0u, 4u, 8u, 12u, 32u, 33u, 128u}) {
    v.type = type;
    CHECK_EQUAL(messageOf(v), "a.tga: expected a TGA image type of 1, 2, 3, 9, 10 or 11, found " +
                                  std::to_string(type));
  }
  v = good;
  v.width = 0;
  CHECK(contains(messageOf(v), "at least 1"));
  v = good;
  v.height = 0;
  CHECK(contains(messageOf(v), "at least 1"));
  v = good;
  v.depth = 8;
  CHECK(contains(messageOf(v), "expected 15, 16, 24 or 32 bits per pixel, found 8"));
  v = good;
  v.descriptor = 0x40;
  CHECK(contains(messageOf(v), "interleaved"));
  v = good;
  v.type = 1;
  v.depth = 8;
  CHECK(contains(messageOf(v), "expected a colour map, found none"));
  v.mapType = 2;
  CHECK(contains(messageOf(v), "colour map type of 0 or 1, found 2"));
  v.mapType = 1;
  v.mapDepth = 8;
  CHECK(contains(messageOf(v), "bits per colour map entry, found 8"));
}

TEST("a huge size that the file cannot hold is an error before memory is asked for") {
  Variant v;
  v.width = v.height = 65535;  // 12.9 GB of pixels
  v.rest = Bytes(1000, 0xFF);
  CHECK(contains(messageOf(v), "expected the data of 65535 x 65535 pixels, found 1000 bytes"));
  v.type = 10;
  CHECK(contains(messageOf(v), "expected the data of 65535 x 65535 pixels, found 1000 bytes"));
}

TEST("a missing file and a folder are errors that name them") {
  const std::string missing = check::temporaryFolder() + "/no_such_picture.tga";
  CHECK_THROWS(readImage(missing), ImageError);
  CHECK_THROWS(readImage(check::temporaryFolder()), ImageError);
  try {
    readImage(missing);
  } catch (const ImageError& error) {
    CHECK_EQUAL(std::string(error.what()), missing + ": No such file or directory");
  }
}
