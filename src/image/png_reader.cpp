// PNG reader. The chunks are taken one after the other, each with its checksum: the head, the
// palette, and the data of all IDAT chunks, which are put together (RFC 2083, 3 and 4). A chunk
// that is unknown is skipped where its type begins with a small letter, which says that it may be.
// The data is inflated at once; then the filters are undone row by row from the top (6), as each
// needs the row above it, and the samples become pixels. Everything that the head declares is held
// against what the file has before memory is asked for: deflate makes at most kMostExpansion bytes
// of one. Order and number of the chunks are checked as the specification has them (4.3), so that a
// file that other readers refuse is refused here too.
#include <algorithm>
#include <cstring>

#include "image/deflate.h"
#include "image/picture_file.h"
#include "image/png_format.h"

namespace {

constexpr std::uint32_t kLongestField = 0x7FFFFFFF;  // lengths and sides stay below 2^31

struct Chunk {
  std::string type;  // four letters
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

Chunk takeChunk(ByteReader& reader) {
  const std::uint32_t size = bigEndian32(reader.take(4, "chunk length"));
  if (size > kLongestField) reader.fail("expected a chunk length below 2^31");
  const std::uint8_t* const type = reader.take(4, "chunk type");
  const bool isNamed = std::all_of(type, type + 4, [](std::uint8_t c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
  if (!isNamed) {
    reader.fail("expected a chunk type of four letters at byte ", reader.position() - 4);
  }
  Chunk chunk = {std::string(type, type + 4), nullptr, size};
  chunk.data = reader.take(size, chunk.type + " chunk");
  if (bigEndian32(reader.take(4, "chunk checksum")) != png::crc32(type, 4 + chunk.size)) {
    reader.fail("the CRC-32 checksum of chunk ", chunk.type, " is wrong");
  }
  return chunk;
}

class PngReader {
 public:
  PngReader(const Bytes& bytes, const std::string& name) : reader_(bytes, name) {}

  Image read() {
    reader_.take(sizeof png::kSignature, "signature");
    readHeader(takeChunk(reader_));
    Chunk chunk = takeChunk(reader_);
    for (std::string before; chunk.type != "IEND"; chunk = takeChunk(reader_)) {
      readChunk(chunk, before);
      before = chunk.type;
    }
    if (chunk.size != 0) reader_.fail("expected an empty IEND chunk");
    if (!hasData_) reader_.fail("expected image data before IEND, found none");
    Bytes rows = inflateRows();
    Image image(static_cast<int>(width_), static_cast<int>(height_));
    for (std::size_t row = 0; row < height_; ++row) {
      std::uint8_t* const samples = &rows[row * stride()];
      undoFilter(samples, row > 0);
      for (int x = 0; x < image.Width(); ++x) {
        image.setPixel(x, image.Height() - 1 - static_cast<int>(row), pixelOf(samples + 1, x));
      }
    }
    return image;
  }

 private:
  void readHeader(const Chunk& chunk) {
    if (chunk.type != "IHDR" || chunk.size != 13) {
      reader_.fail("expected an IHDR chunk of 13 bytes first, found ", chunk.type, " of ",
                   chunk.size);
    }
    width_ = bigEndian32(chunk.data);
    height_ = bigEndian32(chunk.data + 4);
    if (std::min(width_, height_) < 1 || std::max(width_, height_) > kLongestField) {
      reader_.fail("expected a width and height of 1 to 2^31 - 1, found ", width_, " x ", height_);
    }
    const unsigned depth = chunk.data[8], compression = chunk.data[10], filter = chunk.data[11];
    colorType_ = chunk.data[9];
    constexpr unsigned kChannels[] = {1, 0, 3, 1, 2, 0, 4};  // by colour type
    channels_ = colorType_ < std::size(kChannels) ? kChannels[colorType_] : 0;
    if (channels_ == 0) {
      reader_.fail("expected a colour type of 0, 2, 3, 4 or 6, found ", colorType_);
    }
    if (depth != 8) {
      reader_.fail("PNG images of ", depth, " bits per sample are not supported, only of 8");
    }
    if (compression != 0 || filter != 0) {
      reader_.fail("expected compression and filter method 0, found ", compression, " and ",
                   filter);
    }
    if (chunk.data[12] == 1) reader_.fail("interlaced PNG images are not supported");
    if (chunk.data[12] != 0) reader_.fail("expected interlace method 0 or 1");
  }

  /// `before` is the type of the chunk before this one.
  void readChunk(const Chunk& chunk, const std::string& before) {
    if (chunk.type == "IDAT") {
      if (hasData_ && before != "IDAT") reader_.fail("expected IDAT chunks without a gap");
      if (colorType_ == png::kPalette && palette_.empty()) {
        reader_.fail("expected PLTE before IDAT");
      }
      hasData_ = true;
      data_.insert(data_.end(), chunk.data, chunk.data + chunk.size);
    } else if (chunk.type == "PLTE") {
      readPalette(chunk);
    } else if (chunk.type == "tRNS") {
      checkTransparency(chunk);
    } else if (chunk.type[0] <= 'Z') {  // a capital: nobody may skip it
      reader_.fail("the critical chunk ", chunk.type, " is unknown or out of place");
    }
  }

  void readPalette(const Chunk& chunk) {
    if (hasData_ || hasTransparency_ || !palette_.empty()) {
      reader_.fail("expected one PLTE chunk, before tRNS and IDAT");
    }
    if (colorType_ == png::kGrey || colorType_ == png::kGreyAlpha) {
      reader_.fail("expected no PLTE chunk in a grey image");
    }
    if (chunk.size == 0 || chunk.size > 768 || chunk.size % 3 != 0) {
      reader_.fail("expected 1 to 256 palette entries of 3 bytes, found ", chunk.size, " bytes");
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
      reader_.fail("a tRNS chunk of ", chunk.size,
                   " bytes does not fit the colour type or palette");
    }
  }

  /// Bytes of a pixel, which is how far filters look back, and of a row with its filter. Samples of
  /// other depths than 8 bits would change these two and pixelOf.
  std::size_t perPixel() const { return channels_; }
  std::uint64_t stride() const { return 1 + std::uint64_t{width_} * channels_; }

  /// All rows, each behind its filter.
  Bytes inflateRows() const {
    const std::uint64_t size = height_ * stride(), pixels = std::uint64_t{width_} * height_;
    const bool isPossible = size / kMostExpansion <= data_.size();
    reader_.checkSize(width_, height_, isPossible ? pixels : 0, data_.size(), " compressed");
    try {
      Bytes rows = inflateZlib(data_, size);
      if (rows.size() == size) return rows;
      reader_.fail("expected ", size, " bytes of image data, found ", rows.size());
    } catch (const InflateError& error) {
      reader_.fail("in the image data: ", error.what());
    }
  }

  /// `row` points at the filter byte; the row before it is already done. Beyond the edges is 0.
  void undoFilter(std::uint8_t* row, bool hasAbove) const {
    const unsigned filter = row[0];
    if (filter >= png::kFilters) reader_.fail("expected a filter of 0 to 4, found ", filter);
    for (std::size_t i = 1; filter != 0 && i < stride(); ++i) {
      const bool hasLeft = i > perPixel();
      const int left = hasLeft ? row[i - perPixel()] : 0;
      const int above = hasAbove ? *(row + i - stride()) : 0;
      const int corner = hasLeft && hasAbove ? *(row + i - stride() - perPixel()) : 0;
      row[i] = static_cast<std::uint8_t>(row[i] + png::predict(filter, left, above, corner));
    }
  }

  /// The pixel at column x of a row of samples.
  Rgb8 pixelOf(const std::uint8_t* samples, int x) const {
    const std::uint8_t* const sample = samples + std::size_t(x) * channels_;
    if (channels_ >= 3) return {sample[0], sample[1], sample[2]};
    if (colorType_ != png::kPalette) return {sample[0], sample[0], sample[0]};
    if (sample[0] < palette_.size()) return palette_[sample[0]];
    reader_.fail("expected a palette index below ", palette_.size(), ", found ",
                 unsigned{sample[0]});
  }

  ByteReader reader_;
  std::uint32_t width_ = 0, height_ = 0;
  unsigned colorType_ = 0, channels_ = 0;
  bool hasData_ = false, hasTransparency_ = false;
  std::vector<Rgb8> palette_;
  Bytes data_;  // of all IDAT chunks
};

}  // namespace

bool isPng(const Bytes& bytes) {
  return bytes.size() >= sizeof png::kSignature &&
         std::equal(std::begin(png::kSignature), std::end(png::kSignature), bytes.begin());
}

Image decodePng(const Bytes& bytes, const std::string& name) {
  if (!isPng(bytes)) throw ImageError(name, "expected the signature of a PNG file");
  return PngReader(bytes, name).read();
}
