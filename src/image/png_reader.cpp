// PNG reader: chunks (RFC 2083, 3 and 4), filters (6), pixels.
#include <algorithm>
#include <cstring>

#include "image/byte_reader.h"
#include "image/checksum.h"
#include "image/inflate.h"
#include "image/png.h"
#include "image/png_filter.h"
#include "image/png_samples.h"

namespace {

constexpr std::uint8_t kSignature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::uint32_t kLongestField = 0x7FFFFFFF;  // lengths and sides stay below 2^31

struct Chunk {
  std::string type;  // four letters
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;

  bool isCritical() const { return type[0] >= 'A' && type[0] <= 'Z'; }
};

Chunk readChunk(ByteReader& reader) {
  const std::uint32_t size = bigEndian32(reader.take(4, "chunk length"));
  if (size > kLongestField) reader.fail("expected a chunk length below 2^31");
  const std::uint8_t* const typed = reader.take(4, "chunk type");
  const bool named = std::all_of(typed, typed + 4, [](std::uint8_t c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
  if (!named) {
    reader.fail("expected a chunk type of four letters at byte " +
                std::to_string(reader.position() - 4));
  }
  Chunk chunk;
  chunk.type.assign(typed, typed + 4);
  chunk.size = size;
  chunk.data = reader.take(size, (chunk.type + " chunk").c_str());
  if (bigEndian32(reader.take(4, "chunk checksum")) != crc32(typed, 4 + chunk.size)) {
    reader.fail("the CRC-32 checksum of chunk " + chunk.type + " is wrong");
  }
  return chunk;
}

/// The chunks of one file, taken in and checked one after the other.
class PngFile {
 public:
  PngFile(const Bytes& bytes, const std::string& name) : reader_(bytes, name) {}

  Image read() {
    readChunks();
    const Bytes rows = unpackRows();
    return makeImage(rows);
  }

 private:
  void readChunks() {
    reader_.take(sizeof kSignature, "signature");
    takeHeader(readChunk(reader_));
    Chunk chunk = readChunk(reader_);
    for (; chunk.type != "IEND"; chunk = readChunk(reader_)) {
      takeChunk(chunk);
      previous_ = chunk.type;
    }
    if (chunk.size != 0) reader_.fail("expected an empty IEND chunk");
    if (!hasData_) reader_.fail("expected image data before IEND, found none");
  }

  void takeHeader(const Chunk& chunk) {
    if (chunk.type != "IHDR" || chunk.size != 13) {
      reader_.fail("expected an IHDR chunk of 13 bytes first, found " + chunk.type + " of " +
                   std::to_string(chunk.size));
    }
    width_ = bigEndian32(chunk.data);
    height_ = bigEndian32(chunk.data + 4);
    if (std::min(width_, height_) < 1 || std::max(width_, height_) > kLongestField) {
      reader_.fail("expected a width and height of 1 to 2^31 - 1, found " + std::to_string(width_) +
                   " x " + std::to_string(height_));
    }
    takeFormat(chunk.data[8], chunk.data[9]);
    if (chunk.data[10] != 0 || chunk.data[11] != 0) {
      reader_.fail("expected compression and filter method 0, found " +
                   std::to_string(chunk.data[10]) + " and " + std::to_string(chunk.data[11]));
    }
    if (chunk.data[12] == 1) reader_.fail("interlaced PNG images are not supported");
    if (chunk.data[12] != 0) reader_.fail("expected interlace method 0 or 1");
  }

  void takeFormat(unsigned depth, unsigned colorType) {
    colorType_ = colorType;
    switch (colorType) {
      case png::kGrey:
      case png::kPalette:
        channels_ = 1;
        break;
      case png::kGreyAlpha:
        channels_ = 2;
        break;
      case png::kRgb:
        channels_ = 3;
        break;
      case png::kRgba:
        channels_ = 4;
        break;
      default:
        reader_.fail("expected a colour type of 0, 2, 3, 4 or 6, found " +
                     std::to_string(colorType));
    }
    if (depth != 8) {
      reader_.fail("PNG images of " + std::to_string(depth) +
                   " bits per sample are not supported, only of 8");
    }
  }

  void takeChunk(const Chunk& chunk) {
    if (chunk.type == "IDAT") {
      takeData(chunk);
    } else if (chunk.type == "PLTE") {
      takePalette(chunk);
    } else if (chunk.type == "tRNS") {
      checkTransparency(chunk);
    } else if (chunk.isCritical()) {
      reader_.fail("the critical chunk " + chunk.type + " is unknown or out of place");
    }
  }

  void takeData(const Chunk& chunk) {
    if (previous_ != "IDAT" && hasData_) reader_.fail("expected IDAT chunks without a gap");
    if (colorType_ == png::kPalette && palette_.empty()) reader_.fail("expected PLTE before IDAT");
    hasData_ = true;
    data_.insert(data_.end(), chunk.data, chunk.data + chunk.size);
  }

  void takePalette(const Chunk& chunk) {
    if (hasData_ || hasTransparency_ || !palette_.empty()) {
      reader_.fail("expected one PLTE chunk, before tRNS and IDAT");
    }
    if (colorType_ == png::kGrey || colorType_ == png::kGreyAlpha) {
      reader_.fail("expected no PLTE chunk in a grey image");
    }
    if (chunk.size == 0 || chunk.size > 768 || chunk.size % 3 != 0) {
      reader_.fail("expected 1 to 256 palette entries of 3 bytes, found " +
                   std::to_string(chunk.size) + " bytes");
    }
    for (std::size_t i = 0; i < chunk.size; i += 3) {
      palette_.push_back({chunk.data[i], chunk.data[i + 1], chunk.data[i + 2]});
    }
  }

  /// Transparency is dropped, but a chunk that is at fault is a file that is at fault.
  void checkTransparency(const Chunk& chunk) {
    if (hasData_ || hasTransparency_) reader_.fail("expected one tRNS chunk, before IDAT");
    hasTransparency_ = true;
    const bool fits = colorType_ == png::kGrey      ? chunk.size == 2
                      : colorType_ == png::kRgb     ? chunk.size == 6
                      : colorType_ == png::kPalette ? chunk.size <= palette_.size()
                                                    : false;
    if (!fits) {
      reader_.fail("a tRNS chunk of " + std::to_string(chunk.size) +
                   " bytes does not fit the colour type or palette");
    }
  }

  /// The filtered rows, each after a byte that names its filter, turned back into samples.
  Bytes unpackRows() {
    const std::uint64_t size = height_ * (1 + std::uint64_t{width_} * channels_);
    if (size / kMostExpansion > data_.size()) {
      reader_.fail("expected the data of " + std::to_string(width_) + " x " +
                   std::to_string(height_) + " pixels, found " + std::to_string(data_.size()) +
                   " compressed bytes");
    }
    reader_.checkSize(width_, height_);
    Bytes rows;
    try {
      rows = inflateZlib(data_, size);
    } catch (const InflateError& error) {
      reader_.fail(std::string("in the image data: ") + error.what());
    }
    if (rows.size() != size) {
      reader_.fail("expected " + std::to_string(size) + " bytes of image data, found " +
                   std::to_string(rows.size()));
    }
    const std::size_t step = rowSize();
    for (std::size_t row = 0; row < height_; ++row) unfilter(&rows[row * step], row > 0);
    return rows;
  }

  std::size_t rowSize() const { return 1 + std::size_t{width_} * channels_; }

  /// `row` points at the filter byte; the row before it is already done. Beyond the edges is 0.
  void unfilter(std::uint8_t* row, bool hasAbove) const {
    const unsigned filter = row[0];
    if (filter >= png::kFilters)
      reader_.fail("expected a filter of 0 to 4, found " + std::to_string(filter));
    if (filter == 0) return;
    for (std::size_t i = 1; i < rowSize(); ++i) {
      const bool hasLeft = i > channels_;
      const int left = hasLeft ? row[i - channels_] : 0;
      const int above = hasAbove ? *(row + i - rowSize()) : 0;
      const int corner = hasLeft && hasAbove ? *(row + i - rowSize() - channels_) : 0;
      row[i] = static_cast<std::uint8_t>(row[i] + png::predict(filter, left, above, corner));
    }
  }

  Image makeImage(const Bytes& rows) const {
    Image image(static_cast<int>(width_), static_cast<int>(height_));
    for (int y = 0; y < image.Height(); ++y) {
      const std::size_t row = height_ - 1 - static_cast<std::size_t>(y);  // the top one is first
      const std::uint8_t* sample = &rows[row * rowSize() + 1];
      for (int x = 0; x < image.Width(); ++x, sample += channels_) {
        image.setPixel(x, y, pixelFrom(sample));
      }
    }
    return image;
  }

  Rgb8 pixelFrom(const std::uint8_t* sample) const {
    if (channels_ >= 3) return {sample[0], sample[1], sample[2]};
    if (colorType_ != png::kPalette) return {sample[0], sample[0], sample[0]};
    if (sample[0] >= palette_.size()) {
      reader_.fail("expected a palette index below " + std::to_string(palette_.size()) +
                   ", found " + std::to_string(sample[0]));
    }
    return palette_[sample[0]];
  }

  ByteReader reader_;
  std::uint32_t width_ = 0, height_ = 0;
  unsigned colorType_ = 0, channels_ = 0;
  bool hasData_ = false, hasTransparency_ = false;
  std::string previous_;  // type of the chunk before this one
  std::vector<Rgb8> palette_;
  Bytes data_;  // of all IDAT chunks
};

}  // namespace

bool isPng(const Bytes& bytes) {
  return bytes.size() >= sizeof kSignature &&
         std::memcmp(bytes.data(), kSignature, sizeof kSignature) == 0;
}

Image decodePng(const Bytes& bytes, const std::string& name) {
  if (!isPng(bytes)) throw ImageError(name, "expected the signature of a PNG file");
  return PngFile(bytes, name).read();
}

Image readPng(const std::string& path) { return decodePng(readBytes(path), path); }
