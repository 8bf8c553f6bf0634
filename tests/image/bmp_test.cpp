// BMP: what is written is what the format says, and what others write is read.
#include <cstdint>

#include "check.h"
#include "image/picture_file.h"
#include "random.h"

namespace {

void add(Bytes& bytes, std::uint32_t value, int count) {
  for (int k = 0; k < count; ++k, value >>= 8) bytes.push_back(std::uint8_t(value));
}

/// Heads of a file whose pixels follow `extra` (masks, a palette).
Bytes heads(std::uint32_t width, std::uint32_t height, std::uint32_t bits, const Bytes& extra = {},
            std::uint32_t compression = 0, std::uint32_t colors = 0) {
  Bytes bytes = {'B', 'M'};
  add(bytes, 0, 8);
  add(bytes, std::uint32_t(54 + extra.size()), 4);
  add(bytes, 40, 4);
  add(bytes, width, 4);
  add(bytes, height, 4);
  add(bytes, 1, 2);
  add(bytes, bits, 2);
  add(bytes, compression, 4);
  add(bytes, 0, 12);
  add(bytes, colors, 4);
  add(bytes, 0, 4);
  bytes.insert(bytes.end(), extra.begin(), extra.end());
  return bytes;
}

Bytes with(Bytes head, const Bytes& pixels) {
  head.insert(head.end(), pixels.begin(), pixels.end());
  return head;
}

std::string shown(const Image& image) {
  std::string text;
  for (int y = image.Height() - 1; y >= 0; --y) {
    for (int x = 0; x < image.Width(); ++x) {
      const Rgb8 p = image.getPixel(x, y);
      text += std::to_string(p.r) + "," + std::to_string(p.g) + "," + std::to_string(p.b) + " ";
    }
  }
  return text;
}

std::string decode(const Bytes& bytes) { return shown(decodeBmp(bytes, "a.bmp")); }

std::string faultOf(const Bytes& bytes) {
  try {
    decodeBmp(bytes, "a.bmp");
  } catch (const ImageError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST("rows are stored from the bottom, blue first, filled up to four bytes") {
  Image image(1, 2);
  image.setPixel(0, 0, Rgb8{1, 2, 3});  // the lowest
  image.setPixel(0, 1, Rgb8{4, 5, 6});
  const Bytes expected = with(heads(1, 2, 24), {3, 2, 1, 0, 6, 5, 4, 0});
  Bytes found = encodePicture(image, PictureFormat::bmp);
  CHECK_EQUAL(found.size(), expected.size());
  CHECK_EQUAL(int(found[2]), 62);  // the file's length
  CHECK_EQUAL(int(found[34]), 8);  // that of the pixels
  found[2] = found[34] = 0;
  CHECK(found == expected);
}

TEST("what is written is read again, at every width") {
  Random random(7);
  for (int width = 1; width < 9; ++width) {
    Image image(width, 3);
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto byte = [&] { return std::uint8_t(random.index(256)); };
        image.setPixel(x, y, Rgb8{byte(), byte(), byte()});
      }
    }
    const Bytes bytes = encodePicture(image, PictureFormat::bmp);
    CHECK(isBmp(bytes));
    CHECK_EQUAL(decode(bytes), shown(image));
  }
}

TEST("8, 24 and 32 bits, from the bottom or the top") {
  CHECK_EQUAL(decode(with(heads(1, 2, 24), {3, 2, 1, 0, 6, 5, 4, 0})), "4,5,6 1,2,3 ");
  CHECK_EQUAL(decode(with(heads(1, 0u - 2, 24), {3, 2, 1, 0, 6, 5, 4, 0})), "1,2,3 4,5,6 ");
  CHECK_EQUAL(decode(with(heads(2, 1, 32), {3, 2, 1, 99, 6, 5, 4, 0})), "1,2,3 4,5,6 ");
  const Bytes masks = {0, 0, 0xff, 0, 0, 0xff, 0, 0, 0xff, 0, 0, 0};
  CHECK_EQUAL(decode(with(heads(1, 1, 32, masks, 3), {3, 2, 1, 99})), "1,2,3 ");
  const Bytes palette = {3, 2, 1, 0, 6, 5, 4, 0};
  CHECK_EQUAL(decode(with(heads(3, 1, 8, palette, 0, 2), {0, 1, 0, 77})), "1,2,3 4,5,6 1,2,3 ");
}

TEST("what is wrong or not supported is told") {
  CHECK(contains(faultOf(with(heads(2, 1, 8, {1, 2, 3, 0}, 0, 1), {0, 1, 0, 0})), "palette index"));
  CHECK(contains(faultOf(with(heads(2, 2, 24), {0, 0, 0})), "expected the data of 2 x 2 pixels"));
  CHECK(contains(faultOf(heads(0x7fffffff, 0x7fffffff, 24)), "expected the data of"));
  CHECK(contains(faultOf(heads(0, 1, 24)), "expected a width"));
  CHECK(contains(faultOf(heads(1, 0, 24)), "expected a width"));
  CHECK(contains(faultOf(heads(1, 1, 16)), "16 bits a pixel are not supported"));
  CHECK(contains(faultOf(heads(1, 1, 8, {}, 1)), "compressed BMP images are not supported"));
  const Bytes whole = with(heads(1, 1, 24), {1, 2, 3, 0});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CHECK(!faultOf(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size))).empty());
  }
}

TEST("files with changed bytes are read or refused, and never ask for more than they hold") {
  Random random(11);
  const Bytes palette = {3, 2, 1, 0, 6, 5, 4, 0};
  const Bytes files[] = {with(heads(2, 2, 24), Bytes(16)), with(heads(3, 2, 32), Bytes(24)),
                         with(heads(3, 1, 8, palette, 0, 2), Bytes(4))};
  int read = 0;
  for (int i = 0; i < 30000; ++i) {
    Bytes bytes = files[random.index(3)];
    for (int change = random.index(4); change >= 0; --change) {
      bytes[std::size_t(random.index(int(bytes.size())))] = std::uint8_t(random.index(256));
    }
    bytes.resize(std::size_t(random.index(int(bytes.size()) + 1)) |
                 (bytes.size() & ~std::size_t(3)));
    if (!isBmp(bytes)) continue;
    try {
      const Image image = decodeBmp(bytes, "a.bmp");
      ++read;
      CHECK(std::size_t(image.Width()) * std::size_t(image.Height()) <= bytes.size());
    } catch (const ImageError&) {
    }
  }
  CHECK(read > 1000);
}
