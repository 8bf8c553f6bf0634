// PNG writer: 8 bits per sample, as indices of a palette where there are few colours, else as RGB.
// Of an RGB row all five filters are tried, and the one is taken whose differences have the least
// sum of absolute values (RFC 2083, 9.6): slopes then become many small numbers, which compress
// well. Indices of a palette are no measure of anything, and stay as they are.
// The rows are taken in pieces of some 256 KB, which threads filter and then compress apart; each
// piece is one IDAT chunk. Where a piece ends, its last byte is filled up, and copies reach back
// into the piece before it, so that the stream is a little longer than without, and the same for
// any number of threads. A stretch of pieces at a time is held in memory.
#include <algorithm>
#include <limits>
#include <tuple>

#include "image/deflate.h"
#include "image/picture_file.h"
#include "image/png_format.h"
#include "system/worker_threads.h"

namespace png {

namespace {

/// One loop for each filter, which the compiler then makes of vectors.
template <unsigned filter>
void subtractGuesses(unsigned perPixel, const std::uint8_t* row, const std::uint8_t* above,
                     std::size_t size, std::uint8_t* out) {
  const std::uint8_t *const left = row - perPixel, *const corner = above - perPixel;
  for (std::size_t i = 0; i < size; ++i) {
    out[i] = static_cast<std::uint8_t>(row[i] - predict(filter, left[i], above[i], corner[i]));
  }
}

}  // namespace

std::uint64_t filterRow(unsigned filter, unsigned perPixel, const std::uint8_t* row,
                        const std::uint8_t* above, std::size_t size, std::uint8_t* out) {
  static constexpr decltype(&subtractGuesses<0>) kSubtract[kFilters] = {
      subtractGuesses<0>, subtractGuesses<1>, subtractGuesses<2>, subtractGuesses<3>,
      subtractGuesses<4>};
  kSubtract[filter](perPixel, row, above, size, out);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += std::min(out[i] + 0u, 256u - out[i]);
  return sum;
}

}  // namespace png

namespace {

constexpr std::size_t kMostColors = 256;   // of a palette
constexpr std::size_t kPiece = 1 << 18;    // bytes of filtered rows, about
constexpr std::size_t kPiecesAtOnce = 32;  // 8 MB
constexpr std::size_t kStack = 1 << 18;    // bytes, of a thread

void appendBigEndian(std::uint32_t value, Bytes& bytes) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> shift & 255));
  }
}

Bytes chunk(const char* type, const Bytes& data) {
  Bytes bytes;
  bytes.reserve(data.size() + 12);
  appendBigEndian(static_cast<std::uint32_t>(data.size()), bytes);
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(type[i]));
  bytes.insert(bytes.end(), data.begin(), data.end());
  appendBigEndian(png::crc32(bytes.data() + 4, bytes.size() - 4), bytes);
  return bytes;
}

bool isLess(Rgb8 a, Rgb8 b) { return std::tie(a.r, a.g, a.b) < std::tie(b.r, b.g, b.b); }

/// The colours of the picture, rising by red, then green, then blue. None where a palette does not
/// hold them, or takes as many bytes as it saves. Grey pictures get one too: readers turn that into
/// RGB, while a PNG of one grey channel counts as another picture than the TGA for some.
std::vector<Rgb8> paletteOf(const Image& image) {
  std::vector<Rgb8> colors;
  for (int y = 0; y < image.Height(); ++y) {
    for (int x = 0; x < image.Width(); ++x) {
      const Rgb8 pixel = image.getPixel(x, y);
      if (x > 0 && pixel == image.getPixel(x - 1, y)) continue;
      const auto place = std::lower_bound(colors.begin(), colors.end(), pixel, isLess);
      if (place != colors.end() && *place == pixel) continue;
      if (colors.size() == kMostColors) return {};
      colors.insert(place, pixel);
    }
  }
  // An entry has 3 bytes, the chunk 12 besides; an index saves 2 of the 3 bytes of a pixel.
  const std::size_t saved = 2 * std::size_t(image.Width()) * std::size_t(image.Height());
  return 3 * colors.size() + 12 < saved ? colors : std::vector<Rgb8>();
}

class PngWriter {
 public:
  PngWriter(const Image& image, int threads, const Sink& sink)
      : image_(image), threads_(threads), sink_(sink), palette_(paletteOf(image)) {}

  void write() {
    sink_(Bytes(std::begin(png::kSignature), std::end(png::kSignature)));
    sink_(header());
    if (!palette_.empty()) sink_(palette());
    const int rows = static_cast<int>(rowsOfPiece_ * kPiecesAtOnce);
    for (int top = 0; top < image_.Height(); top += std::min(rows, image_.Height() - top)) {
      writeStretch(top, std::min(rows, image_.Height() - top));
    }
    sink_(chunk("IEND", {}));
  }

 private:
  Bytes header() const {
    Bytes data;
    appendBigEndian(static_cast<std::uint32_t>(image_.Width()), data);
    appendBigEndian(static_cast<std::uint32_t>(image_.Height()), data);
    const std::uint8_t type = palette_.empty() ? png::kRgb : png::kPalette;
    data.insert(data.end(), {8, type, 0, 0, 0});  // bits; deflate, filters, not interlaced
    return chunk("IHDR", data);
  }

  Bytes palette() const {
    Bytes data;
    for (const Rgb8 color : palette_) data.insert(data.end(), {color.r, color.g, color.b});
    return chunk("PLTE", data);
  }

  /// Writes `count` rows from the one that is `top`-th from the top on.
  void writeStretch(int top, int count) {
    const std::size_t window = std::min<std::size_t>(filtered_.size(), deflate::kWindow);
    filtered_.erase(filtered_.begin(), filtered_.end() - std::ptrdiff_t(window));
    filtered_.resize(window + std::size_t(count) * stride_);
    const std::size_t pieces = (std::size_t(count) + rowsOfPiece_ - 1) / rowsOfPiece_;
    const auto rowOfPiece = [&](std::size_t i) {
      return std::min(std::size_t(count), i * rowsOfPiece_);
    };
    // All pieces are filtered before the first is compressed, for copies reach into the one before.
    shareOnThreads(threads_, kStack, pieces, [&](std::size_t i) {
      const std::size_t first = rowOfPiece(i);
      filterRows(top + int(first), int(rowOfPiece(i + 1) - first),
                 &filtered_[window + first * stride_]);
    });
    std::vector<Bytes> packed(pieces);
    const bool isLast = top + count == image_.Height();
    shareOnThreads(threads_, kStack, pieces, [&](std::size_t i) {
      packed[i] = deflatePiece(filtered_, window + rowOfPiece(i) * stride_,
                               window + rowOfPiece(i + 1) * stride_, isLast && i + 1 == pieces);
    });
    checksum_ = adler32(&filtered_[window], filtered_.size() - window, checksum_);
    if (top == 0) packed[0].insert(packed[0].begin(), std::begin(kZlibHead), std::end(kZlibHead));
    if (isLast) appendBigEndian(checksum_, packed.back());
    for (const Bytes& data : packed) sink_(chunk("IDAT", data));
  }

  /// Puts `count` filtered rows from the top-th one on behind each other, each behind its filter.
  void filterRows(int top, int count, std::uint8_t* out) const {
    Bytes above(perPixel_ + rowSize_), row(above), tried(rowSize_);
    if (top > 0) readRow(top - 1, &above[perPixel_]);
    for (int y = top; y < top + count; ++y, out += stride_) {
      readRow(y, &row[perPixel_]);
      std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
      for (unsigned filter = 0; filter < (palette_.empty() ? png::kFilters : 1); ++filter) {
        const std::uint64_t sum = png::filterRow(filter, perPixel_, &row[perPixel_],
                                                 &above[perPixel_], rowSize_, tried.data());
        if (sum >= least) continue;
        least = sum;
        out[0] = static_cast<std::uint8_t>(filter);
        std::copy(tried.begin(), tried.end(), out + 1);
      }
      row.swap(above);
    }
  }

  /// The samples of the row that is y-th from the top.
  void readRow(int y, std::uint8_t* out) const {
    for (int x = 0; x < image_.Width(); ++x) {
      const Rgb8 pixel = image_.getPixel(x, image_.Height() - 1 - y);
      if (palette_.empty()) {
        *out++ = pixel.r;
        *out++ = pixel.g;
        *out++ = pixel.b;
      } else {
        const auto place = std::lower_bound(palette_.begin(), palette_.end(), pixel, isLess);
        *out++ = static_cast<std::uint8_t>(place - palette_.begin());
      }
    }
  }

  const Image& image_;
  const int threads_;
  const Sink& sink_;
  const std::vector<Rgb8> palette_;  // empty: RGB
  const unsigned perPixel_ = palette_.empty() ? 3 : 1;
  const std::size_t rowSize_ = perPixel_ * std::size_t(image_.Width()), stride_ = 1 + rowSize_;
  const std::size_t rowsOfPiece_ = (kPiece + stride_ - 1) / stride_;
  Bytes filtered_;  // the rows of the stretch, behind the end of those before
  std::uint32_t checksum_ = 1;
};

}  // namespace

void encodePng(const Image& image, const Sink& sink, int threads) {
  PngWriter(image, threads, sink).write();
}
