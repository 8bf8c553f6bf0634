// BMP: a file head of 14 bytes, an information head that begins with its own length, perhaps masks
// and a palette, then the rows, each filled up to a multiple of four bytes. All numbers have the
// low byte first, and so have pixels: blue, green, red.
#include <algorithm>

#include "image/picture_file.h"

namespace {

constexpr std::uint32_t kFileHead = 14, kInfoHead = 40;
/// BITMAPINFOHEADER, the same with three masks and with four, and with colour spaces, V4 and V5:
/// what stands behind the masks is skipped.
constexpr std::uint32_t kInfoHeads[] = {40, 52, 56, 108, 124};
enum Compression : std::uint32_t { kPlain = 0, kMasks = 3 };

/// Bytes of a row.
std::uint64_t strideOf(std::uint64_t width, unsigned bits) { return (width * bits + 31) / 32 * 4; }

class BmpReader {
 public:
  BmpReader(const Bytes& bytes, const std::string& name) : reader_(bytes, name) {}

  Image read() {
    const std::uint8_t* const head = reader_.take(kFileHead, "file head");
    const std::uint32_t start = littleEndian32(head + 10);
    readInfo(reader_.take(kInfoHead, "information head"));
    readPalette();
    reader_.check(start >= reader_.position() && start - reader_.position() <= reader_.remaining(),
                  "expected the pixels to begin behind the heads and in the file, found byte ",
                  start);
    reader_.take(start - reader_.position(), "gap before the pixels");
    const std::uint64_t stride = strideOf(width_, bits_);
    reader_.checkSize(width_, height_, reader_.remaining() / stride * width_, reader_.remaining());
    Image image(static_cast<int>(width_), static_cast<int>(height_));
    for (int row = 0; row < image.Height(); ++row) {
      const std::uint8_t* const pixels = reader_.take(stride, "row");
      for (int x = 0; x < image.Width(); ++x) {
        image.setPixel(x, isTopFirst_ ? image.Height() - 1 - row : row, pixelAt(pixels, x));
      }
    }
    return image;
  }

 private:
  void readInfo(const std::uint8_t* info) {
    infoSize_ = littleEndian32(info);
    width_ = littleEndian32(info + 4);
    const std::uint32_t height = littleEndian32(info + 8);
    isTopFirst_ = height >= 0x80000000u;
    height_ = isTopFirst_ ? 0u - height : height;
    reader_.check(width_ >= 1 && width_ < 0x80000000u && height_ >= 1 && height_ < 0x80000000u,
                  "expected a width of 1 to 2^31 - 1 and a height that is not 0, found ", width_,
                  " x ", height_);
    bits_ = littleEndian16(info + 14);
    reader_.check(bits_ == 8 || bits_ == 24 || bits_ == 32, "BMP images of ", bits_,
                  " bits a pixel are not supported, only of 8, 24 and 32");
    const std::uint32_t compression = littleEndian32(info + 16);
    reader_.check(compression == kPlain || (compression == kMasks && bits_ == 32),
                  "compressed BMP images are not supported");
    colors_ = littleEndian32(info + 32);
    if (compression == kMasks)
      checkMasks();
    else if (infoSize_ > kInfoHead)
      reader_.take(infoSize_ - kInfoHead, "information head");
  }

  /// The masks of red, green and blue follow the 40 bytes, in a longer head or behind it.
  void checkMasks() {
    const std::size_t size = std::max<std::size_t>(infoSize_ - kInfoHead, 12);
    const std::uint8_t* const masks = reader_.take(size, "colour masks");
    reader_.check(littleEndian32(masks) == 0xff0000 && littleEndian32(masks + 4) == 0xff00 &&
                      littleEndian32(masks + 8) == 0xff,
                  "BMP images with other masks than blue, green, red are not supported");
  }

  /// Entries of four bytes, the last one unused.
  void readPalette() {
    if (bits_ != 8) return;
    const std::size_t count = colors_ == 0 ? 256 : colors_;
    reader_.check(count <= 256, "expected a palette of at most 256 colours, found ", count);
    const std::uint8_t* const entries = reader_.take(4 * count, "palette");
    for (std::size_t k = 0; k < count; ++k) {
      palette_.push_back({entries[4 * k + 2], entries[4 * k + 1], entries[4 * k]});
    }
  }

  Rgb8 pixelAt(const std::uint8_t* row, int x) const {
    const std::uint8_t* const pixel = row + std::size_t(x) * (bits_ / 8);
    if (bits_ != 8) return {pixel[2], pixel[1], pixel[0]};
    return reader_.entryAt(*pixel, palette_);
  }

  ByteReader reader_;
  std::uint32_t infoSize_ = 0, width_ = 0, height_ = 0, colors_ = 0;
  unsigned bits_ = 0;
  bool isTopFirst_ = false;
  std::vector<Rgb8> palette_;
};

}  // namespace

bool isBmp(const Bytes& bytes) {
  if (bytes.size() < kFileHead + 4 || bytes[0] != 'B' || bytes[1] != 'M') return false;
  const std::uint32_t size = littleEndian32(&bytes[kFileHead]);
  return std::find(std::begin(kInfoHeads), std::end(kInfoHeads), size) != std::end(kInfoHeads);
}

Image decodeBmp(const Bytes& bytes, const std::string& name) {
  if (!isBmp(bytes)) throw ImageError(name, "expected a BMP file");
  return BmpReader(bytes, name).read();
}

Bytes bmpHead(int width, int height) {
  const auto w = std::uint32_t(width), h = std::uint32_t(height);
  const std::uint32_t pixels = std::uint32_t(strideOf(w, 24)) * h, start = kFileHead + kInfoHead;
  // Of the file, and where the pixels begin; then of the picture: one plane, 24 bits (numbers of 16
  // bits), not compressed, its size, no resolution, no palette.
  const std::uint32_t numbers[] = {start + pixels, 0,      start, kInfoHead, w, h, 1 | 24 << 16,
                                   kPlain,         pixels, 0,     0,         0, 0};
  Bytes head = {'B', 'M'};
  for (const std::uint32_t number : numbers) appendLittleEndian(number, 4, head);
  return head;
}
