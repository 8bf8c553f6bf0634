// TGA reader.
#include "image/byte_reader.h"
#include "image/tga.h"

namespace {

constexpr std::size_t kLongestPacket = 128;  // pixels

enum class Content { indices, colors, greys };

struct Header {
  Content content = Content::colors;
  bool runLength = false;
  unsigned width = 0, height = 0;
  unsigned depth = 0;  // bits of a pixel, as stored
  bool rightToLeft = false, topToBottom = false;
  bool hasMap = false;
  unsigned mapFirst = 0, mapLength = 0, mapDepth = 0;  // the last one in bits
  unsigned idLength = 0;

  std::size_t pixels() const { return std::size_t{width} * height; }
};

std::size_t bytesOf(unsigned bits) { return (bits + 7) / 8; }

bool isColorDepth(unsigned bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

void readType(unsigned type, Header& header, const ByteReader& reader) {
  const unsigned plain = type & 7;
  if ((type & ~8u) != plain || plain < 1 || plain > 3) {
    reader.fail("expected a TGA image type of 1, 2, 3, 9, 10 or 11, found " + std::to_string(type));
  }
  header.content = plain == 1 ? Content::indices : plain == 2 ? Content::colors : Content::greys;
  header.runLength = (type & 8) != 0;
}

void checkDepth(const Header& header, unsigned alphaBits, const ByteReader& reader) {
  const unsigned depth = header.depth;
  const std::string found = ", found " + std::to_string(depth);
  if (header.content == Content::colors && !isColorDepth(depth)) {
    reader.fail("expected 15, 16, 24 or 32 bits per pixel" + found);
  }
  if (header.content == Content::indices && depth != 8 && depth != 16) {
    reader.fail("expected 8 or 16 bits per colour index" + found);
  }
  if (header.content == Content::greys && depth != 8 && !(depth == 16 && alphaBits == 8)) {
    reader.fail("expected 8 bits per grey pixel, or 16 with 8 of alpha" + found);
  }
}

Header readHeader(ByteReader& reader) {
  const std::uint8_t* const bytes = reader.take(18, "TGA header");
  Header header;
  readType(bytes[2], header, reader);
  header.idLength = bytes[0];
  if (bytes[1] > 1) {
    reader.fail("expected a TGA colour map type of 0 or 1, found " + std::to_string(bytes[1]));
  }
  header.hasMap = bytes[1] == 1;
  header.mapFirst = littleEndian16(bytes + 3);
  header.mapLength = littleEndian16(bytes + 5);
  header.mapDepth = bytes[7];
  header.width = littleEndian16(bytes + 12);
  header.height = littleEndian16(bytes + 14);
  header.depth = bytes[16];
  header.rightToLeft = (bytes[17] & 0x10) != 0;
  header.topToBottom = (bytes[17] & 0x20) != 0;
  if (header.pixels() == 0) reader.fail("expected a width and height of at least 1, found 0");
  if ((bytes[17] & 0xC0) != 0) reader.fail("interleaved TGA images are not supported");
  checkDepth(header, bytes[17] & 15u, reader);
  return header;
}

std::uint8_t byteFrom5Bits(unsigned value) {
  return static_cast<std::uint8_t>(((value & 31) * 255 + 15) / 31);  // rounded: 31 / 2 is 15.5
}

/// A colour of 15 or 16 bits (5-5-5, blue lowest), or BGR, or BGRA.
Rgb8 colorFrom(const std::uint8_t* bytes, unsigned depth) {
  if (depth >= 24) return {bytes[2], bytes[1], bytes[0]};
  const unsigned bits = littleEndian16(bytes);
  return {byteFrom5Bits(bits >> 10), byteFrom5Bits(bits >> 5), byteFrom5Bits(bits)};
}

/// Skips the map where the pixels do not use it.
std::vector<Rgb8> readMap(const Header& header, ByteReader& reader) {
  const bool used = header.content == Content::indices;
  if (used && !header.hasMap) reader.fail("expected a colour map, found none");
  std::vector<Rgb8> map;
  if (!header.hasMap) return map;
  if (used && !isColorDepth(header.mapDepth)) {
    reader.fail("expected 15, 16, 24 or 32 bits per colour map entry, found " +
                std::to_string(header.mapDepth));
  }
  const std::size_t step = bytesOf(header.mapDepth);
  const std::uint8_t* entry = reader.take(step * header.mapLength, "colour map");
  for (unsigned i = 0; used && i < header.mapLength; ++i, entry += step) {
    map.push_back(colorFrom(entry, header.mapDepth));
  }
  return map;
}

/// The pixels of one file, in its own order, one after the other.
class PixelReader {
 public:
  PixelReader(const Header& header, ByteReader& reader)
      : header_(header), reader_(reader), map_(readMap(header, reader)) {
    checkLength();
  }

  Image read() {
    Image image(static_cast<int>(header_.width), static_cast<int>(header_.height));
    std::size_t done = 0;
    while (done < header_.pixels()) done += readPacket(image, done);
    return image;
  }

 private:
  /// Before the image is made: can the rest of the file hold so many pixels at all?
  void checkLength() const {
    const std::size_t pixelBytes = bytesOf(header_.depth);
    const std::size_t packets = (reader_.remaining() + pixelBytes) / (1 + pixelBytes);
    const std::size_t most =
        header_.runLength ? packets * kLongestPacket : reader_.remaining() / pixelBytes;
    if (most >= header_.pixels()) return reader_.checkSize(header_.width, header_.height);
    reader_.fail("expected the data of " + std::to_string(header_.width) + " x " +
                 std::to_string(header_.height) + " pixels, found " +
                 std::to_string(reader_.remaining()) + " bytes");
  }

  /// Without run-length encoding, a packet is one pixel. Gives the number of pixels.
  std::size_t readPacket(Image& image, std::size_t first) {
    const unsigned packet = header_.runLength ? reader_.takeByte("packet header") : 0;
    const std::size_t count = (packet & 127) + 1;
    const bool repeats = (packet & 128) != 0;
    if (count > header_.pixels() - first) {
      reader_.fail("expected a packet of at most " + std::to_string(header_.pixels() - first) +
                   " pixels at byte " + std::to_string(reader_.position() - 1) + ", found " +
                   std::to_string(count));
    }
    Rgb8 pixel;
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0 || !repeats) pixel = readPixel();
      place(image, first + i, pixel);
    }
    return count;
  }

  Rgb8 readPixel() {
    const std::uint8_t* const bytes = reader_.take(bytesOf(header_.depth), "pixel");
    if (header_.content == Content::colors) return colorFrom(bytes, header_.depth);
    if (header_.content == Content::greys) return {bytes[0], bytes[0], bytes[0]};
    const unsigned index = header_.depth == 8 ? bytes[0] : littleEndian16(bytes);
    if (index - header_.mapFirst >= map_.size()) {  // below the first it wraps to a huge number
      reader_.fail("expected a colour index of " + std::to_string(header_.mapFirst) + " to below " +
                   std::to_string(header_.mapFirst + header_.mapLength) + ", found " +
                   std::to_string(index));
    }
    return map_[index - header_.mapFirst];
  }

  void place(Image& image, std::size_t number, Rgb8 pixel) const {
    const int column = static_cast<int>(number % header_.width);
    const int row = static_cast<int>(number / header_.width);
    image.setPixel(header_.rightToLeft ? image.Width() - 1 - column : column,
                   header_.topToBottom ? image.Height() - 1 - row : row, pixel);
  }

  const Header& header_;
  ByteReader& reader_;
  const std::vector<Rgb8> map_;
};

}  // namespace

Image decodeTga(const Bytes& bytes, const std::string& name) {
  ByteReader reader(bytes, name);
  const Header header = readHeader(reader);
  reader.take(header.idLength, "image ID");
  return PixelReader(header, reader).read();
}

Image readTga(const std::string& path) { return decodeTga(readBytes(path), path); }
