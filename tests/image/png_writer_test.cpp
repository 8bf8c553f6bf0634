// PNG: what is written is read back, and what the filters do.
#include <algorithm>
#include <filesystem>

#include "check.h"
#include "encoded.h"
#include "image/png_format.h"
#include "random.h"

namespace {

bool isEqual(const Image& a, const Image& b) {
  if (a.Width() != b.Width() || a.Height() != b.Height()) return false;
  for (int y = 0; y < a.Height(); ++y) {
    for (int x = 0; x < a.Width(); ++x) {
      if (a.getPixel(x, y) != b.getPixel(x, y)) return false;
    }
  }
  return true;
}

/// kind 0: flat; 1: noise; 2: slopes; 3: noise in few colours.
Image picture(int width, int height, int kind, Random& random) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto any = [&] { return std::uint8_t(random.index(256)); };
      const auto few = [&] { return std::uint8_t(random.index(3) * 100); };
      const Rgb8 pixel = kind == 0   ? Rgb8{9, 200, 77}
                         : kind == 1 ? Rgb8{any(), any(), any()}
                         : kind == 2
                             ? Rgb8{std::uint8_t(x), std::uint8_t(y / 2), std::uint8_t(x + y)}
                             : Rgb8{few(), few(), few()};
      image.setPixel(x, y, pixel);
    }
  }
  return image;
}

bool comesBack(const Image& image) {
  return isEqual(decodePng(encoded::png(image), "a.png"), image);
}

}  // namespace

TEST("pictures of every kind and shape come back from a PNG") {
  Random random(21);
  const int sizes[][2] = {{1, 1}, {1, 300}, {300, 1}, {2, 3}, {67, 41}, {400, 300}};
  for (const auto& size : sizes) {
    for (int kind = 0; kind < 4; ++kind) {
      const bool back = comesBack(picture(size[0], size[1], kind, random));
      check::report(back, __FILE__, __LINE__,
                    std::to_string(size[0]) + " x " + std::to_string(size[1]) + ", kind " +
                        std::to_string(kind));
    }
  }
}

TEST("up to 256 colours make a palette, where it is shorter than what it saves") {
  const auto colored = [](int width, int height, int colors) {
    Image image(width, height);
    for (int i = 0; i < width * height; ++i) {
      const int color = i % colors;
      image.setPixel(i % width, i / width,
                     Rgb8{std::uint8_t(color), std::uint8_t(color / 256 * 9), 77});
    }
    return image;
  };
  const auto colorType = [](const Image& image) { return int(encoded::png(image)[25]); };
  for (const int colors : {1, 2, 3, 16, 17, 256, 257}) {
    const Image image = colored(40, 30, colors);
    CHECK(comesBack(image));
    CHECK_EQUAL(colorType(image), colors <= 256 ? 3 : 2);
  }
  CHECK_EQUAL(colorType(colored(1, 1, 1)), 2);
  // 7 pixels are 14 bytes shorter, a palette of one colour is 15 bytes; 8 are 16 bytes shorter.
  CHECK_EQUAL(colorType(colored(7, 1, 1)), 2);
  CHECK_EQUAL(colorType(colored(8, 1, 1)), 3);
  Image grey(300, 2);
  for (int x = 0; x < 300; ++x) {
    const auto level = std::uint8_t(x * 7);
    grey.setPixel(x, x % 2, Rgb8{level, level, level});
  }
  CHECK_EQUAL(colorType(grey), 3);  // never type 0: see paletteOf
  CHECK(comesBack(grey));
}

TEST("pictures as wide or as high as can be come back from a PNG") {
  Random random(22);
  CHECK(comesBack(picture(65535, 2, 2, random)));
  CHECK(comesBack(picture(1, 65535, 2, random)));
}

TEST("a picture of several stretches comes back from a PNG") {
  Random random(23);
  CHECK(comesBack(picture(1700, 1700, 2, random)));  // 8.7 MB: a stretch is 32 pieces of 256 KB
  CHECK(comesBack(picture(700, 500, 2, random)));    // one stretch of 5 pieces
}

TEST("a filtered row is each byte less the guess of RFC 2083, 6") {
  // Behind the pixel of zeros that stands before each row.
  const Bytes row = {0, 0, 0, 10, 20, 30, 15, 5, 40}, above = {0, 0, 0, 4, 8, 6, 12, 2, 50};
  const std::uint8_t expected[5][6] = {
      {10, 20, 30, 15, 5, 40},
      {10, 20, 30, 5, 241, 10},  // 15 - 10, 5 - 20, 40 - 30
      {6, 12, 24, 3, 3, 246},
      // 10 - 4/2, 20 - 8/2, 30 - 6/2; 15 - (10+12)/2, 5 - (20+2)/2, 40 - (30+50)/2
      {8, 16, 27, 4, 250, 0},
      // First pixel: left and corner are 0, so above. Then 10 + 12 - 4 = 18, nearest 12: 3;
      // 20 + 2 - 8 = 14, nearest 20 (6 off; above 12, corner 6, left wins ties): 241;
      // 30 + 50 - 6 = 74, nearest 50: 246.
      {6, 12, 24, 3, 241, 246}};
  // Sums of |differences|: 120; 10+20+30+5+15+10 = 90; 6+12+24+3+3+10 = 58; 8+16+27+4+6+0 = 61;
  // 6+12+24+3+15+10 = 70.
  const std::uint64_t sums[5] = {120, 90, 58, 61, 70};
  for (unsigned filter = 0; filter < png::kFilters; ++filter) {
    std::uint8_t found[6];
    const std::uint64_t sum = png::filterRow(filter, 3, &row[3], &above[3], 6, found);
    CHECK(std::equal(found, found + 6, expected[filter]));
    CHECK_EQUAL(sum, sums[filter]);
  }
}

TEST("the filter of a row is the one of the least sum of differences") {
  // A row of its own left neighbours, one of those above, and one of neither.
  Image image(300, 3);
  Random random(27);
  for (int x = 0; x < 300; ++x) {
    const auto slope = std::uint8_t(x / 2);
    const auto any = [&] { return std::uint8_t(random.index(256)); };
    image.setPixel(x, 2, Rgb8{slope, slope, slope});
    image.setPixel(x, 1, Rgb8{any(), any(), any()});
    image.setPixel(x, 0, image.getPixel(x, 1));
  }
  const Bytes file = encoded::png(image);
  // Behind the signature (8), the head (25), and the length and type of IDAT (8), a zlib stream.
  const std::size_t size = bigEndian32(&file[33]);
  const Bytes stream(file.begin() + 41, file.begin() + 41 + std::ptrdiff_t(size));
  const Bytes rows = inflateZlib(stream, 3 * 901);
  CHECK_EQUAL(int(rows[0]), 1);
  CHECK_EQUAL(int(rows[1802]), 2);
  CHECK(std::all_of(rows.begin() + 1803, rows.end(), [](std::uint8_t byte) { return byte == 0; }));
}

TEST("the pictures of the scenes, 100 x 75, take at most 11.9 % of their TGA files") {
  // libpng's take 11.7 %. The larger a picture is, the less.
  double png = 0, tga = 0;
  const std::filesystem::path folder = std::filesystem::path(check::testsFolder()) / "expected";
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".png") continue;
    const Image image = readImage(file.path().string());
    png += double(encoded::png(image).size());
    tga += 18 + 3.0 * image.Width() * image.Height();
  }
  CHECK(tga > 0);
  check::report(png <= 0.119 * tga, __FILE__, __LINE__, std::to_string(png / tga));
}

TEST("slopes cost little, for the filters guess them") {
  Random random(24);
  const Image slopes = picture(256, 256, 2, random);
  // 196608 bytes; a filter leaves each row but the first ones nearly constant.
  CHECK(encoded::png(slopes).size() < 2000);
}

TEST("copies of a PNG reach back into the piece before") {
  // 30 rows of noise, again and again: 9 KB once, and copies, in two pieces of 256 KB. A piece that
  // could not look back would have to say the noise again: 18 KB.
  Random random(28);
  const Image noise = picture(100, 30, 1, random);
  Image image(100, 1700);
  for (int i = 0; i < 100 * 1700; ++i) {
    image.setPixel(i % 100, i / 100, noise.getPixel(i % 100, i / 100 % 30));
  }
  CHECK(comesBack(image));
  CHECK(encoded::png(image).size() < 15000);
}

TEST("the same picture gives the same bytes") {
  Random random(25), again(25);
  CHECK(encoded::png(picture(90, 80, 3, random)) == encoded::png(picture(90, 80, 3, again)));
}

TEST("a PNG file does not depend on how many threads compress it") {
  Random random(26);
  // Of two pieces of 256 KB, of several, and of more than one stretch.
  const int sizes[][2] = {{330, 300}, {600, 600}, {1700, 1720}};
  for (const auto& size : sizes) {
    const Image image = picture(size[0], size[1], 2, random);
    const Bytes alone = encoded::png(image);
    CHECK(isEqual(decodePng(alone, "alone.png"), image));
    for (const int threads : {2, 5}) {
      CHECK(encoded::png(image, threads) == alone);
    }
  }
}
