// PNG: every colour type and filter from hand-made bytes, and every way to be at fault.
#include <filesystem>
#include <random>

#include "check.h"
#include "image/deflate.h"
#include "image/picture_file.h"
#include "image/png_format.h"

namespace {

void append(Bytes& bytes, const Bytes& more) {
  for (const std::uint8_t byte : more) bytes.push_back(byte);
}

Bytes bigEndian(std::uint32_t value) {
  return {std::uint8_t(value >> 24), std::uint8_t(value >> 16), std::uint8_t(value >> 8),
          std::uint8_t(value)};
}

Bytes chunk(const std::string& type, const Bytes& data) {
  Bytes typed(type.begin(), type.end());
  append(typed, data);
  Bytes whole = bigEndian(std::uint32_t(data.size()));
  append(whole, typed);
  append(whole, bigEndian(png::crc32(typed.data(), typed.size())));
  return whole;
}

Bytes header(unsigned width, unsigned height, unsigned depth, unsigned colorType,
             unsigned interlace = 0) {
  Bytes data = bigEndian(width);
  append(data, bigEndian(height));
  append(data, {std::uint8_t(depth), std::uint8_t(colorType), 0, 0, std::uint8_t(interlace)});
  return chunk("IHDR", data);
}

/// zlib data of one stored block.
Bytes pack(const Bytes& rows) {
  const auto size = unsigned(rows.size());
  Bytes packed = {0x78,
                  0x01,
                  0x01,
                  std::uint8_t(size & 255),
                  std::uint8_t(size >> 8),
                  std::uint8_t(~size & 255),
                  std::uint8_t(~size >> 8 & 255)};
  append(packed, rows);
  append(packed, bigEndian(adler32(rows.data(), rows.size())));
  return packed;
}

Bytes pngFile(std::initializer_list<Bytes> chunks) {
  Bytes file = {0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A};
  for (const Bytes& each : chunks) append(file, each);
  return file;
}

Bytes imageData(const Bytes& rows) { return chunk("IDAT", pack(rows)); }
Bytes end() { return chunk("IEND", {}); }

std::string shown(const Image& image) {
  std::string text;
  for (int y = image.Height() - 1; y >= 0; --y) {
    for (int x = 0; x < image.Width(); ++x) {
      const Rgb8 p = image.getPixel(x, y);
      text += std::to_string(p.r) + " " + std::to_string(p.g) + " " + std::to_string(p.b) +
              (x + 1 < image.Width() ? ", "
               : y > 0               ? " / "
                                     : "");
    }
  }
  return text;
}

std::string decode(const Bytes& bytes) { return shown(decodePng(bytes, "a.png")); }

/// The message; empty where the file is read.
std::string faultOf(const Bytes& bytes) {
  try {
    decodePng(bytes, "a.png");
  } catch (const ImageError& error) {
    return error.what();
  }
  return "";
}

void checkFault(const Bytes& bytes, const std::string& part) {
  const std::string fault = faultOf(bytes);
  check::report(fault.find("a.png: ") == 0 && fault.find(part) != std::string::npos, __FILE__,
                __LINE__, "found \"" + fault + "\", expected \"" + part + "\"");
}

// Made with python3: zlib.compress of two rows of three RGB pixels. The first is red, green, blue
// with filter 0, the second adds (1, 0, 0), (0, 1, 0), (0, 0, 1) with filter 2 (above).
const Bytes kSmall = {0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49,
                      0x48, 0x44, 0x52, 0x00, 0x00, 0x00, 0x03, 0x00, 0x00, 0x00, 0x02, 0x08, 0x02,
                      0x00, 0x00, 0x00, 0x12, 0x16, 0xF1, 0x4D, 0x00, 0x00, 0x00, 0x13, 0x49, 0x44,
                      0x41, 0x54, 0x78, 0x9C, 0x63, 0xF8, 0xCF, 0xC0, 0xC0, 0x00, 0xC6, 0x4C, 0x8C,
                      0x40, 0x12, 0x8C, 0x01, 0x2D, 0x0A, 0x03, 0x03, 0x95, 0x09, 0xEC, 0xAB, 0x00,
                      0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};
// 255 + 1 wraps to 0.
const char* const kSmallShown = "255 0 0, 0 255 0, 0 0 255 / 0 0 0, 0 0 0, 0 0 0";

}  // namespace

TEST("a small RGB file of another encoder is read, top row first") {
  CHECK_EQUAL(decode(kSmall), kSmallShown);
}

TEST("every colour type of 8 bits is read, alpha dropped") {
  CHECK_EQUAL(decode(pngFile({header(2, 1, 8, 0), imageData({0, 5, 200}), end()})),
              "5 5 5, 200 200 200");
  CHECK_EQUAL(decode(pngFile({header(1, 2, 8, 2), imageData({0, 1, 2, 3, 0, 4, 5, 6}), end()})),
              "1 2 3 / 4 5 6");
  CHECK_EQUAL(decode(pngFile({header(3, 1, 8, 3), chunk("PLTE", {1, 2, 3, 4, 5, 6}),
                              imageData({0, 1, 0, 1}), end()})),
              "4 5 6, 1 2 3, 4 5 6");
  CHECK_EQUAL(decode(pngFile({header(2, 1, 8, 4), imageData({0, 5, 0, 200, 255}), end()})),
              "5 5 5, 200 200 200");
  CHECK_EQUAL(decode(pngFile({header(2, 1, 8, 6), imageData({0, 1, 2, 3, 0, 4, 5, 6, 9}), end()})),
              "1 2 3, 4 5 6");
}

TEST("each filter is undone") {
  // Grey rows 10 20 30 25 and 15 40 35 50, the first one with filter 0 or as said.
  // Second row, left / above / corner of each pixel: 0 10 0, 15 20 10, 40 30 20, 35 25 30.
  const std::string expected =
      "10 10 10, 20 20 20, 30 30 30, 25 25 25 / 15 15 15, 40 40 40, 35 35 35, 50 50 50";
  const auto rows = [](const Bytes& first, const Bytes& second) {
    Bytes both = first;
    append(both, second);
    return decode(pngFile({header(4, 2, 8, 0), imageData(both), end()}));
  };
  const Bytes plain = {0, 10, 20, 30, 25};
  CHECK_EQUAL(rows(plain, {0, 15, 40, 35, 50}), expected);
  CHECK_EQUAL(rows(plain, {1, 15, 25, 251, 15}), expected);  // 35 - 40 = -5 = 251
  CHECK_EQUAL(rows(plain, {2, 5, 20, 5, 25}), expected);
  // Averages, rounded down: 5, 17 (of 15 and 20), 35, 30.
  CHECK_EQUAL(rows(plain, {3, 10, 23, 0, 20}), expected);
  // Paeth's left + above - corner: 10, 25, 50, 30; nearest: above 10, above 20 (5 off; left 10,
  // corner 15), left 40 (10 off; above 20), corner 30 (0 off).
  CHECK_EQUAL(rows(plain, {4, 5, 20, 251, 20}), expected);
  // In the first row above and corner are 0: averages 0, 5, 10, 15; Paeth takes left.
  CHECK_EQUAL(rows({1, 10, 10, 10, 251}, {0, 15, 40, 35, 50}), expected);
  CHECK_EQUAL(rows({2, 10, 20, 30, 25}, {0, 15, 40, 35, 50}), expected);
  CHECK_EQUAL(rows({3, 10, 15, 20, 10}, {0, 15, 40, 35, 50}), expected);
  CHECK_EQUAL(rows({4, 10, 10, 10, 251}, {0, 15, 40, 35, 50}), expected);
}

TEST("Paeth's ties go to left or above, not to the corner") {
  // The corner is 4. Left 2 and above 5 estimate 3: left and corner are 1 off, above 2.
  // The first pixel of the second row has no left: 4 + 254 = 2, modulo 256.
  CHECK_EQUAL(decode(pngFile({header(2, 2, 8, 0), imageData({0, 4, 5, 4, 254, 0}), end()})),
              "4 4 4, 5 5 5 / 2 2 2, 2 2 2");
  // Left 5 and above 2 estimate 3: above and corner are 1 off, left 2.
  CHECK_EQUAL(decode(pngFile({header(2, 2, 8, 0), imageData({0, 4, 2, 4, 1, 0}), end()})),
              "4 4 4, 2 2 2 / 5 5 5, 2 2 2");
}

TEST("filters reach back one whole pixel") {
  // Filter 1 on RGB and RGBA: the second pixel is the first plus (1, 2, 3).
  CHECK_EQUAL(decode(pngFile({header(2, 1, 8, 2), imageData({1, 10, 20, 30, 1, 2, 3}), end()})),
              "10 20 30, 11 22 33");
  CHECK_EQUAL(
      decode(pngFile({header(2, 1, 8, 6), imageData({1, 10, 20, 30, 40, 1, 2, 3, 4}), end()})),
      "10 20 30, 11 22 33");
  CHECK_EQUAL(decode(pngFile({header(2, 1, 8, 4), imageData({1, 10, 40, 1, 4}), end()})),
              "10 10 10, 11 11 11");
}

TEST("image data may be split into chunks anywhere, and ancillary chunks are skipped") {
  const Bytes packed = pack({0, 5, 200});
  const Bytes head(packed.begin(), packed.begin() + 3), tail(packed.begin() + 3, packed.end());
  const Bytes file = pngFile({header(2, 1, 8, 0),
                              chunk("gAMA", {0, 0, 0, 1}),
                              chunk("tEXt", {'a'}),
                              chunk("IDAT", head),
                              chunk("IDAT", {}),
                              chunk("IDAT", tail),
                              chunk("tIME", {1, 2, 3}),
                              end(),
                              {1, 2, 3}});
  CHECK_EQUAL(decode(file), "5 5 5, 200 200 200");
}

TEST("tRNS is accepted where it belongs and dropped") {
  const Bytes palette = chunk("PLTE", {1, 2, 3, 4, 5, 6});
  CHECK_EQUAL(
      decode(pngFile({header(1, 1, 8, 0), chunk("tRNS", {0, 5}), imageData({0, 5}), end()})),
      "5 5 5");
  CHECK_EQUAL(faultOf(pngFile({header(1, 1, 8, 2), chunk("tRNS", {0, 5, 0, 5, 0, 5}),
                               imageData({0, 5, 5, 5}), end()})),
              "");
  CHECK_EQUAL(
      faultOf(pngFile({header(1, 1, 8, 3), palette, chunk("tRNS", {9}), imageData({0, 1}), end()})),
      "");
  const char* const kMisfit = "does not fit";
  checkFault(pngFile({header(1, 1, 8, 0), chunk("tRNS", {5}), imageData({0, 5}), end()}), kMisfit);
  checkFault(
      pngFile({header(1, 1, 8, 3), palette, chunk("tRNS", {9, 9, 9}), imageData({0, 1}), end()}),
      kMisfit);
  checkFault(pngFile({header(1, 1, 8, 4), chunk("tRNS", {0, 5}), imageData({0, 5, 5}), end()}),
             kMisfit);
  checkFault(pngFile({header(1, 1, 8, 3), chunk("tRNS", {9}), palette, imageData({0, 1}), end()}),
             kMisfit);
  checkFault(pngFile({header(1, 1, 8, 0), imageData({0, 5}), chunk("tRNS", {0, 5}), end()}),
             "one tRNS");
}

TEST("chunk order and lengths are checked") {
  const Bytes grey = header(1, 1, 8, 0), row = imageData({0, 5}),
              palette = chunk("PLTE", {1, 2, 3});
  const Bytes indexed = header(1, 1, 8, 3), index = imageData({0, 0});
  CHECK_EQUAL(faultOf(pngFile({grey, row, end()})), "");
  CHECK_EQUAL(faultOf(pngFile({indexed, palette, index, end()})), "");
  checkFault(pngFile({row, grey, end()}), "expected an IHDR chunk of 13 bytes first, found IDAT");
  checkFault(pngFile({chunk("IHDR", Bytes(12)), row, end()}), "found IHDR of 12");
  checkFault(pngFile({grey, grey, row, end()}), "critical chunk IHDR is unknown or out of place");
  checkFault(pngFile({grey, chunk("ABCD", {}), row, end()}), "critical chunk ABCD");
  checkFault(pngFile({grey, row, chunk("teXt", {}), row, end()}), "without a gap");
  checkFault(pngFile({grey, end()}), "expected image data before IEND");
  checkFault(pngFile({grey, row, chunk("IEND", {1})}), "empty IEND");
  checkFault(pngFile({grey, row}), "chunk length");
  checkFault(pngFile({grey, palette, row, end()}), "no PLTE chunk in a grey image");
  const Bytes greyAlpha = header(1, 1, 8, 4), transparency = chunk("tRNS", {0, 5});
  checkFault(pngFile({greyAlpha, palette, imageData({0, 5, 5}), end()}), "no PLTE chunk in a grey");
  checkFault(pngFile({grey, transparency, transparency, row, end()}), "one tRNS");
  checkFault(pngFile({indexed, index, end()}), "expected PLTE before IDAT");
  checkFault(pngFile({indexed, palette, palette, index, end()}), "one PLTE");
  checkFault(pngFile({indexed, palette, index, palette, end()}), "one PLTE");
  checkFault(pngFile({indexed, chunk("PLTE", {1, 2}), index, end()}), "found 2 bytes");
  checkFault(pngFile({indexed, chunk("PLTE", {}), index, end()}), "found 0 bytes");
  checkFault(pngFile({indexed, chunk("PLTE", Bytes(771)), index, end()}), "found 771 bytes");
  checkFault(pngFile({grey, chunk("a1cd", {}), row, end()}), "four letters");
  checkFault(pngFile({grey, {0x80, 0, 0, 0, 'I', 'D', 'A', 'T'}}), "below 2^31");
  Bytes wrongSum = pngFile({grey, row, end()});
  wrongSum.back() ^= 1;
  checkFault(wrongSum, "CRC-32 checksum of chunk IEND is wrong");
}

TEST("a palette index out of range is an error") {
  checkFault(
      pngFile({header(2, 1, 8, 3), chunk("PLTE", {1, 2, 3, 4, 5, 6}), imageData({0, 1, 2}), end()}),
      "expected a palette index below 2, found 2");
}

TEST("more or less data than the picture needs is an error") {
  checkFault(pngFile({header(2, 1, 8, 0), imageData({0, 5}), end()}),
             "expected 3 bytes of image data, found 2");
  checkFault(pngFile({header(2, 1, 8, 0), imageData({0, 5, 5, 5}), end()}),
             "more than the expected 3 bytes");
  checkFault(pngFile({header(1, 1, 8, 0), imageData({5, 5}), end()}),
             "expected a filter of 0 to 4, found 5");
  checkFault(pngFile({header(1, 1, 8, 0), chunk("IDAT", {}), end()}), "ends too early");
  Bytes badSum = pack({0, 5});
  badSum.back() ^= 1;
  checkFault(pngFile({header(1, 1, 8, 0), chunk("IDAT", badSum), end()}), "Adler-32");
}

TEST("compression and filter methods other than 0 are an error") {
  // Width 1, height 1, 8 bits, grey; then compression, filter and interlace method.
  const auto picture = [](std::uint8_t compression, std::uint8_t filter) {
    const Bytes head = {0, 0, 0, 1, 0, 0, 0, 1, 8, 0, compression, filter, 0};
    return pngFile({chunk("IHDR", head), imageData({0, 5}), end()});
  };
  CHECK_EQUAL(faultOf(picture(0, 0)), "");
  checkFault(picture(1, 0), "expected compression and filter method 0, found 1 and 0");
  checkFault(picture(0, 2), "expected compression and filter method 0, found 0 and 2");
}

TEST("samples of a depth that the colour type does not have are a mistake") {
  for (const auto& [depth, colorType] :
       {std::pair(3u, 0u), {16u, 3u}, {4u, 2u}, {1u, 4u}, {2u, 6u}, {32u, 0u}, {0u, 0u}}) {
    checkFault(pngFile({header(1, 1, depth, colorType), imageData({0, 0}), end()}),
               "do not fit colour type " + std::to_string(colorType));
  }
  checkFault(pngFile({header(1, 1, 8, 0, 2), imageData({0, 0}), end()}), "interlace method");
  for (const unsigned colorType : {1u, 5u, 7u}) {
    checkFault(pngFile({header(1, 1, 8, colorType), imageData({0, 0}), end()}),
               "expected a colour type of 0, 2, 3, 4 or 6, found " + std::to_string(colorType));
  }
  checkFault({'G', 'I', 'F', '8', '9', 'a', 0, 0, 0}, "expected the signature of a PNG file");
  checkFault({}, "signature");
}

TEST("a size of 0, or one that the file cannot hold, is an error before memory is asked for") {
  checkFault(pngFile({header(0, 1, 8, 0), imageData({0}), end()}), "width and height of 1");
  checkFault(pngFile({header(1, 0, 8, 0), imageData({0}), end()}), "width and height of 1");
  checkFault(pngFile({header(0x80000000u, 1, 8, 0), imageData({0}), end()}), "2^31 - 1");
  checkFault(pngFile({header(0x7FFFFFFF, 0x7FFFFFFF, 8, 6), imageData({0}), end()}),
             "expected the data of");
  checkFault(pngFile({header(30000, 30000, 8, 2), imageData(Bytes(1000)), end()}),
             "expected the data of");
}

TEST("every prefix of a file is an error") {
  for (std::size_t size = 0; size < kSmall.size(); ++size) {
    CHECK(!faultOf(Bytes(kSmall.begin(), kSmall.begin() + std::ptrdiff_t(size))).empty());
  }
}

TEST("every byte of a file, changed to every other value, is noticed") {
  // Each byte is covered by a checksum, or is one, or is the signature or a chunk length.
  for (std::size_t i = 0; i < kSmall.size(); ++i) {
    for (unsigned change = 1; change < 256; ++change) {
      Bytes changed = kSmall;
      changed[i] = std::uint8_t(changed[i] ^ change);
      if (faultOf(changed).empty()) CHECK_EQUAL("byte " + std::to_string(i), "is noticed");
    }
  }
  CHECK(true);
}

TEST("damage behind right checksums ends in an error or a picture") {
  std::mt19937 random(5);
  const auto side = [&random] { return unsigned(1 + random() % 6); };
  int read = 0, refused = 0;
  for (int round = 0; round < 20000; ++round) {
    Bytes packed(kSmall.begin() + 41, kSmall.begin() + 60);
    packed[2 + random() % 13] = std::uint8_t(random());
    const unsigned types[] = {0, 2, 3, 4, 6};
    const unsigned type = types[random() % 5];
    const Bytes palette = type == 3 ? chunk("PLTE", Bytes(3 * (1 + random() % 256))) : Bytes{};
    const unsigned width = side(), height = side();
    const Bytes file =
        pngFile({header(width, height, 8, type), palette, chunk("IDAT", packed), end()});
    (faultOf(file).empty() ? read : refused)++;
  }
  CHECK(read + refused == 20000);
  CHECK(refused > 1000);
}

TEST("the reference pictures are read") {
  const std::string folder = check::referenceFolder() + "/pictures";
  if (!std::filesystem::is_directory(folder)) SKIP("no folder " + folder);
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".png") continue;
    const Image image = readImage(entry.path().string());
    const bool small = entry.path().filename().string().rfind("a1_", 0) == 0;
    CHECK_EQUAL(image.Width(), small ? 200 : 400);
    CHECK_EQUAL(image.Height(), small ? 200 : 400);
    ++count;
  }
  CHECK(count >= 16);
}

TEST("samples of 1, 2, 4 and 16 bits become the nearest bytes") {
  // 1 0 1 1 0 0 0 0, then one more bit: 1.
  CHECK_EQUAL(decode(pngFile({header(9, 1, 1, 0), imageData({0, 0xB0, 0x80}), end()})),
              "255 255 255, 0 0 0, 255 255 255, 255 255 255, 0 0 0, 0 0 0, 0 0 0, 0 0 0, "
              "255 255 255");
  CHECK_EQUAL(decode(pngFile({header(3, 1, 2, 0), imageData({0, 0x1B}), end()})),
              "0 0 0, 85 85 85, 170 170 170");
  CHECK_EQUAL(decode(pngFile({header(3, 1, 4, 0), imageData({0, 0x2F, 0x10}), end()})),
              "34 34 34, 255 255 255, 17 17 17");
  CHECK_EQUAL(decode(pngFile({header(2, 1, 4, 3), chunk("PLTE", {1, 2, 3, 4, 5, 6}),
                              imageData({0, 0x10}), end()})),
              "4 5 6, 1 2 3");
  // 0x8080 / 257 = 128; 0x0080 / 257 = 0.498; 0x0081 / 257 = 0.502.
  CHECK_EQUAL(
      decode(pngFile({header(1, 1, 16, 2), imageData({0, 0x80, 0x80, 0, 0x80, 0, 0x81}), end()})),
      "128 0 1");
  CHECK_EQUAL(decode(pngFile({header(1, 1, 16, 4), imageData({0, 0xFF, 0xFF, 1, 2}), end()})),
              "255 255 255");
  FloatImage exact;
  decodePng(pngFile({header(1, 1, 16, 0), imageData({0, 0x40, 0x00}), end()}), "a.png", &exact);
  CHECK_EQUAL(exact.getPixel(0, 0).r(), 16384.0f / 65535);
}

TEST("filters of samples of 16 bits go back by whole pixels, of small ones by a byte") {
  // Filter 1 adds the pixel to the left: two bytes before, or one.
  CHECK_EQUAL(decode(pngFile({header(2, 1, 16, 0), imageData({1, 0x10, 0, 0x20, 0}), end()})),
              "16 16 16, 48 48 48");
  CHECK_EQUAL(decode(pngFile({header(4, 1, 4, 0), imageData({1, 0x12, 0x12}), end()})),
              "17 17 17, 34 34 34, 34 34 34, 68 68 68");
}

TEST("an interlaced picture comes in seven passes") {
  // 3 x 3 grey pixels, numbered in reading order. Pass 1: (0, 0); 2 and 3: none, as they begin at
  // 4; 4: (2, 0); 5: (0, 2), (2, 2); 6: (1, 0), (1, 2); 7: row 1.
  CHECK_EQUAL(decode(pngFile({header(3, 3, 8, 0, 1),
                              imageData({0, 1, 0, 3, 0, 7, 9, 0, 2, 0, 8, 0, 4, 5, 6}), end()})),
              "1 1 1, 2 2 2, 3 3 3 / 4 4 4, 5 5 5, 6 6 6 / 7 7 7, 8 8 8, 9 9 9");
  CHECK_EQUAL(decode(pngFile({header(1, 1, 1, 0, 1), imageData({0, 0x80}), end()})), "255 255 255");
  checkFault(pngFile({header(3, 3, 8, 0, 1), imageData({0, 1, 0, 3}), end()}),
             "expected 15 bytes of image data, found 4");
}
