// PNG writer: 8 bits per sample, as indices of a palette where there are few colours, else as RGB.
// Of an RGB row all five filters are tried, and the one is taken whose differences have the least
// sum of absolute values (RFC 2083, 9.6): slopes then become many small numbers, which compress
// well. Indices of a palette are no measure of anything, and stay as they are.
// The rows are taken in pieces of some 256 KB, which threads filter and compress apart; each piece
// is one IDAT chunk. Where a piece ends, its last byte is filled up, and copies reach back into the
// piece before it, the end of which is filtered once more for that; so the stream is a little
// longer than without, and the same for any number of threads. Some pieces at a time are held in
// memory.
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

constexpr std::size_t kMostColors = 256;  // of a palette
constexpr std::size_t kPiece = 1 << 18;   // bytes of filtered rows, about
constexpr std::size_t kHeld = 1 << 23;    // and of all pieces that are held at once
constexpr std::size_t kStack = 1 << 18;   // bytes, of a thread

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

/// Signature, head, palette, the pieces in groups that threads work on, end.
class PngWriter {
 public:
  PngWriter(const Image& image, int threads, const Sink& sink)
      : image_(image), threads_(threads), sink_(sink), palette_(paletteOf(image)) {}

  void write() {
    sink_(Bytes(std::begin(png::kSignature), std::end(png::kSignature)));
    writeHead();
    const std::size_t piecesAtOnce = 1 + kHeld / (rowsOfPiece_ * stride_);
    std::uint32_t checksum = 1;
    for (std::size_t first = 0; first < pieces_; first += piecesAtOnce) {
      std::vector<Piece> pieces(std::min(piecesAtOnce, pieces_ - first));
      shareOnThreads(threads_, kStack, pieces.size(),
                     [&](std::size_t i) { pieces[i] = pieceAt(first + i); });
      for (Piece& piece : pieces) {
        checksum = adler32(&piece.rows[piece.begin], piece.rows.size() - piece.begin, checksum);
        const bool isLast = &piece == &pieces.back() && first + pieces.size() == pieces_;
        if (isLast) appendBigEndian(checksum, piece.packed);
        sink_(chunk("IDAT", piece.packed));
      }
    }
    sink_(chunk("IEND", {}));
  }

 private:
  struct Piece {
    Bytes rows;         // filtered, from the one with the first byte that a copy may reach on
    std::size_t begin;  // of its own ones
    Bytes packed;
  };

  void writeHead() const {
    Bytes head, colors;
    appendBigEndian(static_cast<std::uint32_t>(image_.Width()), head);
    appendBigEndian(static_cast<std::uint32_t>(image_.Height()), head);
    const std::uint8_t type = palette_.empty() ? png::kRgb : png::kPalette;
    head.insert(head.end(), {8, type, 0, 0, 0});  // bits; deflate, filters, not interlaced
    sink_(chunk("IHDR", head));
    for (const Rgb8 color : palette_) colors.insert(colors.end(), {color.r, color.g, color.b});
    if (!palette_.empty()) sink_(chunk("PLTE", colors));
  }

  /// What one thread does: the rows of a piece and those before it that fill deflate's window are
  /// filtered, and its own ones compressed. The first piece begins with zlib's head.
  Piece pieceAt(std::size_t index) const {
    const std::size_t top = index * rowsOfPiece_;
    const std::size_t bottom = std::min(top + rowsOfPiece_, std::size_t(image_.Height()));
    const std::size_t before = std::min(top, (deflate::kWindow + stride_ - 1) / stride_);
    Piece piece = {Bytes((before + bottom - top) * stride_), before * stride_, {}};
    filterRows(int(top - before), int(bottom), piece.rows.data());
    piece.packed = deflatePiece(piece.rows, piece.begin, piece.rows.size(), index + 1 == pieces_);
    if (index == 0) {
      piece.packed.insert(piece.packed.begin(), std::begin(kZlibHead), std::end(kZlibHead));
    }
    return piece;
  }

  /// Puts the rows top <= y < bottom, from the top, behind each other, each behind its filter.
  void filterRows(int top, int bottom, std::uint8_t* out) const {
    Bytes above(perPixel_ + rowSize_), row(above), tried(rowSize_);
    if (top > 0) readRow(top - 1, &above[perPixel_]);
    for (int y = top; y < bottom; ++y, out += stride_) {
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
    const int row = image_.Height() - 1 - y;
    if (palette_.empty()) std::copy_n(image_.rowBytes(row), rowSize_, out);
    for (int x = 0; !palette_.empty() && x < image_.Width(); ++x) {
      const Rgb8 pixel = image_.getPixel(x, row);
      const auto place = std::lower_bound(palette_.begin(), palette_.end(), pixel, isLess);
      *out++ = static_cast<std::uint8_t>(place - palette_.begin());
    }
  }

  const Image& image_;
  const int threads_;
  const Sink& sink_;
  const std::vector<Rgb8> palette_;  // empty: RGB
  const unsigned perPixel_ = palette_.empty() ? 3 : 1;
  const std::size_t rowSize_ = perPixel_ * std::size_t(image_.Width()), stride_ = 1 + rowSize_;
  const std::size_t rowsOfPiece_ = (kPiece + stride_ - 1) / stride_;
  const std::size_t pieces_ = (std::size_t(image_.Height()) + rowsOfPiece_ - 1) / rowsOfPiece_;
};

}  // namespace

void encodePng(const Image& image, const Sink& sink, int threads) {
  PngWriter(image, threads, sink).write();
}
