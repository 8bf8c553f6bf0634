// TGA: 18 bytes of header, an ID, a colour map, then the pixels, plain or in packets that repeat
// one pixel or list several. Numbers have the low byte first, colours blue. The header, by byte: 0
// length of the ID; 1 whether there is a colour map; 2 image type; 3 to 7 the map: first index,
// length, bits of an entry; 8 to 11 origin; 12 to 15 width and height; 16 bits of a pixel; 17
// descriptor: 4 bits of alpha, then whether the first pixel is on the right (0x10) and at the top
// (0x20), then interleaving, which nobody uses. A packet's first byte says how many pixels less one
// (the lower 7 bits), and whether one pixel follows for all of them (the highest bit) or each of
// them.
#include <cassert>

#include "image/picture_file.h"

namespace {

constexpr std::size_t kHeaderSize = 18;
constexpr std::size_t kLongestPacket = 128;  // pixels

enum class PixelKind { indices = 1, colors, greys };  // the lowest 3 bits of the image type

std::size_t bytesOf(unsigned bits) { return (bits + 7) / 8; }

bool isColorDepth(unsigned bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

std::uint8_t byteFrom5Bits(unsigned value) { return byteFromSample(value & 31, 31); }

/// A colour of 15 or 16 bits (5-5-5, blue lowest), or BGR, or BGRA.
Rgb8 colorFrom(const std::uint8_t* bytes, unsigned depth) {
  if (depth >= 24) return {bytes[2], bytes[1], bytes[0]};
  const unsigned bits = littleEndian16(bytes);
  return {byteFrom5Bits(bits >> 10), byteFrom5Bits(bits >> 5), byteFrom5Bits(bits)};
}

/// Takes header and colour map, then packet after packet. Pixels are numbered as the file has them.
class TgaReader {
 public:
  TgaReader(const Bytes& bytes, const std::string& name) : reader_(bytes, name) {}

  Image read() {
    const std::uint8_t* const header = reader_.take(kHeaderSize, "TGA header");
    takeHeader(header);
    reader_.take(header[0], "image ID");
    if (header[1] == 1) takeMap(littleEndian16(header + 5), header[7]);
    checkLength();
    Image image(static_cast<int>(width_), static_cast<int>(height_));
    for (std::size_t done = 0; done < pixels();) done += takePacket(image, done);
    return image;
  }

 private:
  std::size_t pixels() const { return std::size_t{width_} * height_; }

  /// All but the lengths of the ID and of the map, which `read` sees to.
  void takeHeader(const std::uint8_t* header) {
    const unsigned type = header[2], plainType = type & 7, descriptor = header[17];
    reader_.check((type & ~8u) == plainType && plainType >= 1 && plainType <= 3,
                  "expected a TGA image type of 1, 2, 3, 9, 10 or 11, found ", type);
    kind_ = static_cast<PixelKind>(plainType);
    isPacked_ = (type & 8) != 0;
    reader_.check(header[1] <= 1, "expected a TGA colour map type of 0 or 1, found ",
                  unsigned{header[1]});
    mapFirst_ = littleEndian16(header + 3);
    width_ = littleEndian16(header + 12);
    height_ = littleEndian16(header + 14);
    depth_ = header[16];
    isRightToLeft_ = (descriptor & 0x10) != 0;
    isTopToBottom_ = (descriptor & 0x20) != 0;
    reader_.check(pixels() > 0, "expected a width and height of at least 1, found 0");
    reader_.check((descriptor & 0xC0) == 0, "interleaved TGA images are not supported");
    checkDepth(descriptor & 15);
    reader_.check(kind_ != PixelKind::indices || header[1] == 1,
                  "expected a colour map, found none");
  }

  void checkDepth(unsigned alphaBits) const {
    reader_.check(kind_ != PixelKind::colors || isColorDepth(depth_),
                  "expected 15, 16, 24 or 32 bits per pixel, found ", depth_);
    reader_.check(kind_ != PixelKind::indices || depth_ == 8 || depth_ == 16,
                  "expected 8 or 16 bits per colour index, found ", depth_);
    reader_.check(kind_ != PixelKind::greys || depth_ == 8 || (depth_ == 16 && alphaBits == 8),
                  "expected 8 bits per grey pixel, or 16 with 8 of alpha, found ", depth_);
  }

  /// Skips a map that the pixels do not use.
  void takeMap(unsigned length, unsigned depth) {
    const bool isUsed = kind_ == PixelKind::indices;
    reader_.check(!isUsed || isColorDepth(depth),
                  "expected 15, 16, 24 or 32 bits per colour map entry, found ", depth);
    const std::uint8_t* entry = reader_.take(bytesOf(depth) * length, "colour map");
    for (unsigned i = 0; isUsed && i < length; ++i, entry += bytesOf(depth)) {
      map_.push_back(colorFrom(entry, depth));
    }
  }

  /// Before the image is made: can the rest of the file hold so many pixels at all?
  void checkLength() const {
    const std::size_t found = reader_.remaining(), size = bytesOf(depth_);
    const std::size_t packets = (found + size) / (1 + size);
    reader_.checkSize(width_, height_, isPacked_ ? packets * kLongestPacket : found / size, found);
  }

  /// Without run-length encoding, a packet is one pixel. Gives the number of pixels.
  std::size_t takePacket(Image& image, std::size_t first) {
    const unsigned head = isPacked_ ? reader_.takeByte("packet header") : 0;
    const std::size_t count = (head & 127) + 1, most = pixels() - first;
    reader_.check(count <= most, "expected a packet of at most ", most, " pixels at byte ",
                  reader_.position() - 1, ", found ", count);
    Rgb8 pixel;
    for (std::size_t i = first; i < first + count; ++i) {
      if (i == first || (head & 128) == 0) pixel = takePixel();
      const int column = static_cast<int>(i % width_), row = static_cast<int>(i / width_);
      image.setPixel(isRightToLeft_ ? image.Width() - 1 - column : column,
                     isTopToBottom_ ? image.Height() - 1 - row : row, pixel);
    }
    return count;
  }

  /// An index counts from the map's first entry on; one below that wraps round to a huge number.
  Rgb8 takePixel() {
    const std::uint8_t* const bytes = reader_.take(bytesOf(depth_), "pixel");
    if (kind_ == PixelKind::colors) return colorFrom(bytes, depth_);
    if (kind_ == PixelKind::greys) return {bytes[0], bytes[0], bytes[0]};
    const unsigned index = depth_ == 8 ? bytes[0] : littleEndian16(bytes);
    reader_.check(index - mapFirst_ < map_.size(), "expected a colour index of ", mapFirst_,
                  " to below ", mapFirst_ + map_.size(), ", found ", index);
    return map_[index - mapFirst_];
  }

  ByteReader reader_;
  PixelKind kind_ = PixelKind::colors;
  bool isPacked_ = false, isRightToLeft_ = false, isTopToBottom_ = false;
  unsigned width_ = 0, height_ = 0, depth_ = 0;  // depth: bits of a pixel, as stored
  unsigned mapFirst_ = 0;                        // the index of the map's first colour
  std::vector<Rgb8> map_;
};

}  // namespace

Bytes tgaHead(int width, int height, const TgaPart& part) {
  assert(width >= 1 && height >= 1 && part.id.size() <= 255);
  Bytes head = {static_cast<std::uint8_t>(part.id.size()), 0, 2, 0, 0, 0, 0, 0};
  for (const int number : {part.x, part.y, width, height}) {
    assert(number >= 0 && number <= 65535);
    appendLittleEndian(static_cast<std::uint32_t>(number), 2, head);
  }
  head.insert(head.end(), {24, 0x20});  // bits of a pixel; the top row comes first
  head.insert(head.end(), part.id.begin(), part.id.end());
  return head;
}

Image decodeTga(const Bytes& bytes, const std::string& name) {
  return TgaReader(bytes, name).read();
}
