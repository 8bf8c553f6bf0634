// Picture files: which format, and that each comes back; files that claim to be enormous.
#include "image/picture_file.h"

#include <chrono>

#include "check.h"
#include "encoded.h"
#include "image/bytes.h"
#include "image/png_format.h"
#include "random.h"
#include "run_program.h"

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string stringOf(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

std::string bigEndian(std::uint32_t value) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) text += char(value >> shift & 255);
  return text;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string typed = type + data;
  return bigEndian(std::uint32_t(data.size())) + typed +
         bigEndian(png::crc32(reinterpret_cast<const std::uint8_t*>(typed.data()), typed.size()));
}

std::string pngOf(unsigned width, unsigned height, const Bytes& packed) {
  using namespace std::string_literals;
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", bigEndian(width) + bigEndian(height) + "\x08\x00\0\0\0"s) +
         chunk("IDAT", stringOf(packed)) + chunk("IEND", "");
}

/// The fault of a file, "" without one; no more than a tenth of a second may pass (ten times that
/// for a machine that is busy with something else).
std::string quickFault(const std::string& content) {
  const check::ScratchFolder scratch;
  const std::string file = scratch.write("bomb", content);
  const auto start = std::chrono::steady_clock::now();
  std::string fault;
  try {
    readImage(file);
  } catch (const ImageError& error) {
    fault = error.what();
  }
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
  return fault;
}

}  // namespace

TEST("the ending picks the format, TGA where it is missing, none where it is unknown") {
  using F = PictureFormat;
  CHECK(formatOf("a.png") == F::png && formatOf("b/A.PNG") == F::png);
  CHECK(formatOf("a.ppm") == F::ppm && formatOf("a.PfM") == F::pfm);
  CHECK(formatOf("a.tga") == F::tga && formatOf("a") == F::tga && !formatOf("a.jpg"));
  CHECK(formatOf("a.png/b") == F::tga && formatOf("a.png.tga") == F::tga);
  CHECK(formatOf("png") == F::tga && formatOf("a.") == F::tga && formatOf("") == F::tga);
  CHECK(formatOf(".png") == F::png);
}

TEST("a name without an ending has the format that is said, and no other name has") {
  using F = PictureFormat;
  for (const char* unnamed : {"a", "a.", "", "b.png/a", "-"}) {
    CHECK(formatOf(unnamed, F::png) == F::png && formatOf(unnamed, F::bmp) == F::bmp);
  }
  CHECK(formatOf("a.tga", F::png) == F::tga && !formatOf("a.jpg", F::png));
  const check::ScratchFolder scratch;
  writePicture(Image(2, 2), scratch.file("a"), 1, {}, F::bmp);
  CHECK_EQUAL(check::contentOf(scratch.file("a")).substr(0, 2), "BM");
}

TEST("a picture of all bytes comes back from every format") {
  Image image(64, 12);
  for (int i = 0; i < 768; ++i) {
    image.setPixel(i % 64, i / 64,
                   Rgb8{std::uint8_t(i & 255), std::uint8_t(i / 3), std::uint8_t(255 - (i & 255))});
  }
  const check::ScratchFolder scratch;
  for (const char* name : {"a.tga", "a.png", "a.ppm", "a.pfm", "a"}) {
    writePicture(image, scratch.file(name));
    const Image back = readImage(scratch.file(name));
    int different = back.Width() == 64 && back.Height() == 12 ? 0 : 1;
    for (int i = 0; i < 768 && different == 0; ++i) {
      different += image.getPixel(i % 64, i / 64) != back.getPixel(i % 64, i / 64);
    }
    check::report(different == 0, __FILE__, __LINE__, std::string(name) + " comes back");
  }
}

TEST("files that claim to hold enormous pictures are refused at once") {
  using namespace std::string_literals;
  // The 18 bytes of a TGA head, of 65535 x 65535 pixels of 24 bits.
  const std::string tga = "\0\0\2\0\0\0\0\0\0\0\0\0\xff\xff\xff\xff\x18\x20"s;
  CHECK(contains(quickFault(tga), "expected the data of 65535 x 65535"));
  std::string packed = tga;
  packed[2] = 10;
  CHECK(contains(quickFault(packed + "\xff\1\2\3"), "expected the data of"));
  CHECK(contains(quickFault(pngOf(0x7FFFFFFF, 0x7FFFFFFF, encoded::zlib(Bytes(10)))),
                 "expected the data of"));
  CHECK(contains(quickFault("P6 65535 65535 255\n"), "expected the data of"));
  CHECK(contains(quickFault("PF 65535 65535 -1\n"), "expected the data of"));
}

TEST("a device that never ends is no picture, and is read no further than 64 MB") {
  std::string message;
  try {
    readImage("/dev/zero");
  } catch (const ImageError& error) {
    message = error.what();
  }
  CHECK_EQUAL(message, "/dev/zero: expected at most 64 MB from a device, found more");
}

TEST("a PNG that is enormous when it is unpacked is refused at once") {
  // Zeros shrink to a thousandth: the data could be those of 40000 x 40000 grey pixels.
  CHECK(contains(quickFault(pngOf(40000, 40000, Bytes(1600000))), "is refused"));
  // 4 bytes a pixel, one of the file's row and three of the picture's: 133 MB, and 125.
  CHECK(contains(quickFault(pngOf(5900, 5900, Bytes(70000))), "is refused"));
  CHECK(contains(quickFault(pngOf(5900, 5900, Bytes(600000))), "zlib"));
  CHECK(contains(quickFault(pngOf(5700, 5700, Bytes(70000))), "zlib"));
  // More data than the picture needs: refused where the picture is full.
  CHECK(contains(quickFault(pngOf(1, 1, encoded::zlib(Bytes(1 << 22)))), "more than the expected"));
}

TEST("random damage of pictures ends in an error or a picture") {
  Random random(41);
  Image image(9, 7);
  for (int i = 0; i < 63; ++i) image.setPixel(i % 9, i / 9, Rgb8{std::uint8_t(i), 7, 9});
  const Bytes files[] = {encoded::tga(image), encoded::png(image)};
  int refused = 0;
  const check::ScratchFolder scratch;
  for (int round = 0; round < 4000; ++round) {
    Bytes bytes = files[round % 2];
    for (int i = random.index(3); i >= 0; --i) {
      bytes[std::size_t(random.index(std::min(int(bytes.size()), 40)))] =
          std::uint8_t(random.index(256));
    }
    try {
      readImage(scratch.write("a", stringOf(bytes)));
    } catch (const ImageError&) {
      ++refused;
    }
  }
  CHECK(refused > 1000);
}
