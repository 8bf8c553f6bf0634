// PNG reader. The chunks are taken one after the other, each with its checksum: the head, the
// palette, and the data of all IDAT chunks, which are put together (RFC 2083, 3 and 4). A chunk
// that is unknown is skipped where its type begins with a small letter, which says that it may be.
// The data is inflated at once; then the filters are undone row by row from the top (6), as each
// needs the row above it, and the samples become pixels. An interlaced picture is seven smaller
// ones, each of every eighth to every second pixel of some rows, one behind the other (2.6).
// Everything that the head declares is held against what the file has before memory is asked for:
// deflate makes at most kMostExpansion bytes of one. Order and number of the chunks are checked as
// the specification has them (4.3), so that a file that other readers refuse is refused here too.
#include <algorithm>

#include "image/deflate.h"
#include "image/picture_file.h"
#include "image/png_format.h"

namespace {

constexpr std::uint32_t kLongestField = 0x7FFFFFFF;  // lengths and sides stay below 2^31

/// A view of the file's bytes.
struct Chunk {
  std::string type;  // four letters
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

/// Length, type, data, and the checksum of type and data (RFC 2083, 3.2).
Chunk takeChunk(ByteReader& reader) {
  const std::uint32_t size = bigEndian32(reader.take(4, "chunk length"));
  reader.check(size <= kLongestField, "expected a chunk length below 2^31");
  const std::uint8_t* const type = reader.take(4, "chunk type");
  const bool isNamed = std::all_of(type, type + 4, [](std::uint8_t c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
  reader.check(isNamed, "expected a chunk type of four letters at byte ", reader.position() - 4);
  Chunk chunk = {std::string(type, type + 4), nullptr, size};
  chunk.data = reader.take(size, chunk.type + " chunk");
  const std::uint32_t checksum = bigEndian32(reader.take(4, "chunk checksum"));
  reader.check(checksum == png::crc32(type, 4 + chunk.size), "the CRC-32 checksum of chunk ",
               chunk.type, " is wrong");
  return chunk;
}

/// Some of a picture's pixels: column 0 of row 0 is (x, y), the next are dx and dy further.
struct Pass {
  std::uint32_t x, y, dx, dy;
  std::uint64_t columns = 0, rows = 0;  // both 0 where the picture is too small for any
  std::uint64_t stride = 0;             // bytes of a row, with its filter
};

/// Gathers what the chunks say: the head, a palette, compressed data. At IEND the picture is made.
class PngReader {
 public:
  PngReader(const Bytes& bytes, const std::string& name, FloatImage* exact)
      : reader_(bytes, name), exact_(exact) {}

  Image read() {
    reader_.take(sizeof png::kSignature, "signature");
    readHeader(takeChunk(reader_));
    Chunk chunk = takeChunk(reader_);
    for (std::string before; chunk.type != "IEND"; chunk = takeChunk(reader_)) {
      readChunk(chunk, before);
      before = chunk.type;
    }
    reader_.check(chunk.size == 0, "expected an empty IEND chunk");
    reader_.check(hasData_, "expected image data before IEND, found none");
    Bytes rows = inflateRows();
    Image image(static_cast<int>(width_), static_cast<int>(height_));
    if (isExact()) *exact_ = FloatImage(image.Width(), image.Height());
    std::uint8_t* row = rows.data();
    for (const Pass& pass : passes_) {
      for (std::uint64_t k = 0; k < pass.rows; ++k, row += pass.stride) {
        // In place: the row above, whose filter is undone, is still there for this one.
        undoFilter(row, pass.stride, k > 0);
        takeRow(pass, row + 1, image.Height() - 1 - int(pass.y + k * pass.dy), image);
      }
    }
    return image;
  }

 private:
  /// IHDR (4.1.1).
  void readHeader(const Chunk& chunk) {
    reader_.check(chunk.type == "IHDR" && chunk.size == 13,
                  "expected an IHDR chunk of 13 bytes first, found ", chunk.type, " of ",
                  chunk.size);
    width_ = bigEndian32(chunk.data);
    height_ = bigEndian32(chunk.data + 4);
    reader_.check(std::min(width_, height_) >= 1 && std::max(width_, height_) <= kLongestField,
                  "expected a width and height of 1 to 2^31 - 1, found ", width_, " x ", height_);
    const unsigned compression = chunk.data[10], filter = chunk.data[11],
                   interlace = chunk.data[12];
    depth_ = chunk.data[8];
    colorType_ = chunk.data[9];
    constexpr unsigned kChannels[] = {1, 0, 3, 1, 2, 0, 4};  // by colour type
    channels_ = colorType_ < std::size(kChannels) ? kChannels[colorType_] : 0;
    reader_.check(channels_ > 0, "expected a colour type of 0, 2, 3, 4 or 6, found ", colorType_);
    const bool isPowerOfTwo = depth_ == 1 || depth_ == 2 || depth_ == 4 || depth_ == 8;
    const bool isSmall = colorType_ == png::kGrey || colorType_ == png::kPalette;
    const bool fits =
        depth_ == 8 || (depth_ == 16 && colorType_ != png::kPalette) || (isPowerOfTwo && isSmall);
    reader_.check(fits, "samples of ", depth_, " bits do not fit colour type ", colorType_);
    reader_.check(compression == 0 && filter == 0,
                  "expected compression and filter method 0, found ", compression, " and ", filter);
    reader_.check(interlace <= 1, "expected interlace method 0 or 1, found ", interlace);
    setPasses(interlace == 1);
  }

  void setPasses(bool isInterlaced) {
    passes_ = {{0, 0, 1, 1}};
    if (isInterlaced) {
      passes_ = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                 {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
    }
    for (Pass& pass : passes_) {
      pass.columns = (std::uint64_t{width_} + pass.dx - 1 - pass.x) / pass.dx;
      pass.rows = (std::uint64_t{height_} + pass.dy - 1 - pass.y) / pass.dy;
      if (pass.columns == 0) pass.rows = 0;
      pass.stride = 1 + (pass.columns * channels_ * depth_ + 7) / 8;
    }
  }

  /// `before` is the type of the chunk before this one.
  void readChunk(const Chunk& chunk, const std::string& before) {
    if (chunk.type == "IDAT") {
      reader_.check(!hasData_ || before == "IDAT", "expected IDAT chunks without a gap");
      reader_.check(colorType_ != png::kPalette || !palette_.empty(), "expected PLTE before IDAT");
      hasData_ = true;
      data_.insert(data_.end(), chunk.data, chunk.data + chunk.size);
    } else if (chunk.type == "PLTE") {
      readPalette(chunk);
    } else if (chunk.type == "tRNS") {
      checkTransparency(chunk);
    } else {  // a small letter: it may be skipped
      reader_.check(chunk.type[0] > 'Z', "the critical chunk ", chunk.type,
                    " is unknown or out of place");
    }
  }

  /// PLTE (4.1.2). In an RGB picture it is a mere suggestion, but has to be a sound one.
  void readPalette(const Chunk& chunk) {
    reader_.check(!hasData_ && !hasTransparency_ && palette_.empty(),
                  "expected one PLTE chunk, before tRNS and IDAT");
    reader_.check(colorType_ != png::kGrey && colorType_ != png::kGreyAlpha,
                  "expected no PLTE chunk in a grey image");
    reader_.check(chunk.size > 0 && chunk.size <= 768 && chunk.size % 3 == 0,
                  "expected 1 to 256 palette entries of 3 bytes, found ", chunk.size, " bytes");
    for (std::size_t i = 0; i < chunk.size; i += 3) {
      palette_.push_back({chunk.data[i], chunk.data[i + 1], chunk.data[i + 2]});
    }
  }

  /// Transparency is dropped, but a chunk that is at fault is a file that is at fault.
  void checkTransparency(const Chunk& chunk) {
    reader_.check(!hasData_ && !hasTransparency_, "expected one tRNS chunk, before IDAT");
    hasTransparency_ = true;
    const bool fits = (colorType_ == png::kGrey && chunk.size == 2) ||
                      (colorType_ == png::kRgb && chunk.size == 6) ||
                      (colorType_ == png::kPalette && chunk.size <= palette_.size());
    reader_.check(fits, "a tRNS chunk of ", chunk.size,
                  " bytes does not fit the colour type or palette");
  }

  /// The picture is wanted in floats, and has more than bytes.
  bool isExact() const { return exact_ && depth_ == 16; }

  /// All rows, each behind its filter.
  Bytes inflateRows() const {
    std::uint64_t size = 0;
    for (const Pass& pass : passes_) size += pass.rows * pass.stride;
    // Deflate makes at most kMostExpansion bytes of one: too little data is told before inflating.
    const bool isPossible = size / kMostExpansion <= data_.size();
    const std::uint64_t pixels = std::uint64_t{width_} * height_;
    reader_.checkSize(width_, height_, isPossible ? pixels : 0, data_.size(), " compressed");
    // A small picture may be as dense as it likes: it costs little whatever the file says.
    constexpr std::uint64_t kMostBytes = 1 << 27, kMostPerByte = 256;
    const std::uint64_t memory = size + pixels * (isExact() ? 3 + sizeof(Vec3f) : 3);
    reader_.check(memory <= kMostBytes || memory / kMostPerByte <= data_.size(), "a picture of ",
                  width_, " x ", height_, " pixels in ", data_.size(),
                  " compressed bytes is refused");
    Bytes rows;
    try {
      rows = inflateZlib(data_, size);
    } catch (const InflateError& error) {
      reader_.fail("in the image data: ", error.what());
    }
    reader_.check(rows.size() == size, "expected ", size, " bytes of image data, found ",
                  rows.size());
    return rows;
  }

  /// `row` points at the filter byte; the row before it is already done. Beyond the edges is 0.
  void undoFilter(std::uint8_t* row, std::uint64_t size, bool hasAbove) const {
    const unsigned filter = row[0];
    const std::size_t perPixel = std::max(1u, channels_ * depth_ / 8);  // of several in a byte 1
    reader_.check(filter < png::kFilters, "expected a filter of 0 to 4, found ", filter);
    for (std::size_t i = 1; filter != 0 && i < size; ++i) {
      const bool hasLeft = i > perPixel;
      const int left = hasLeft ? row[i - perPixel] : 0;
      const int above = hasAbove ? *(row + i - size) : 0;
      const int corner = hasLeft && hasAbove ? *(row + i - size - perPixel) : 0;
      row[i] = static_cast<std::uint8_t>(row[i] + png::predict(filter, left, above, corner));
    }
  }

  /// Sample `number` of a row, counted from its left: those of less than 8 bits from the high end
  /// of their byte on (2.3).
  unsigned sampleAt(const std::uint8_t* samples, std::uint64_t number) const {
    if (depth_ == 8) return samples[number];
    if (depth_ == 16) return samples[2 * number] * 256u + samples[2 * number + 1];
    const std::uint64_t bit = number * depth_;
    return samples[bit / 8] >> (8 - depth_ - bit % 8) & ((1u << depth_) - 1);
  }
  /// As a byte (12.5 of the specification's third edition).
  std::uint8_t byteOf(unsigned sample) const {
    return depth_ == 8 ? std::uint8_t(sample) : byteFromSample(sample, (1u << depth_) - 1);
  }

  /// Enters a row of samples as pixels of row y. Of a grey all three components are one sample.
  void takeRow(const Pass& pass, const std::uint8_t* samples, int y, Image& image) {
    const unsigned next = channels_ >= 3 ? 1 : 0;
    for (std::uint64_t column = 0; column < pass.columns; ++column) {
      const int x = int(pass.x + column * pass.dx);
      const std::uint64_t first = column * channels_;
      const unsigned r = sampleAt(samples, first), g = sampleAt(samples, first + next),
                     b = sampleAt(samples, first + 2 * next);
      image.setPixel(x, y,
                     colorType_ == png::kPalette ? reader_.entryAt(r, palette_)
                                                 : Rgb8{byteOf(r), byteOf(g), byteOf(b)});
      if (isExact()) exact_->setPixel(x, y, Vec3f(float(r), float(g), float(b)) / 65535);
    }
  }

  ByteReader reader_;
  FloatImage* const exact_;  // not owned; may be null
  std::uint32_t width_ = 0, height_ = 0;
  unsigned colorType_ = 0, channels_ = 0, depth_ = 8;
  bool hasData_ = false, hasTransparency_ = false;
  std::vector<Pass> passes_;
  std::vector<Rgb8> palette_;
  Bytes data_;  // of all IDAT chunks
};

}  // namespace

bool isPng(const Bytes& bytes) {
  return bytes.size() >= sizeof png::kSignature &&
         std::equal(std::begin(png::kSignature), std::end(png::kSignature), bytes.begin());
}

Image decodePng(const Bytes& bytes, const std::string& name, FloatImage* exact) {
  if (!isPng(bytes)) throw ImageError(name, "expected the signature of a PNG file");
  return PngReader(bytes, name, exact).read();
}
