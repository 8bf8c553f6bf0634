// PNG writer: 8 bits per sample, RGB, with a filter for each row that makes it compress well.
#include <algorithm>

#include "image/checksum.h"
#include "image/deflate.h"
#include "image/output_file.h"
#include "image/png.h"
#include "image/png_filter.h"

namespace {

/// How hard to try.
struct Effort {
  unsigned trialDepth;  // 0: filters are chosen by the least differences, without a trial
  unsigned depth;
  int rounds;
};
constexpr Effort kThorough = {4, 32, 1}, kQuick = {0, 16, 1};
constexpr std::size_t kMostThorough = 1 << 19;  // pixels
constexpr std::size_t kStretch = 1 << 20;       // bytes that are compressed together, at least

Effort effortFor(const Image& image) {
  const auto pixels = static_cast<std::size_t>(image.Width()) * std::size_t(image.Height());
  return pixels <= kMostThorough ? kThorough : kQuick;
}

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
  appendBigEndian(crc32(bytes.data() + 4, bytes.size() - 4), bytes);
  return bytes;
}

Bytes headOf(const Image& image) {
  Bytes bytes = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'}, data;
  appendBigEndian(static_cast<std::uint32_t>(image.Width()), data);
  appendBigEndian(static_cast<std::uint32_t>(image.Height()), data);
  data.insert(data.end(), {8, 2, 0, 0, 0});  // 8 bits, RGB, deflate, filters, not interlaced
  const Bytes header = chunk("IHDR", data);
  bytes.insert(bytes.end(), header.begin(), header.end());
  return bytes;
}

/// The filtered rows of an image from the top, as many at a time as fill a stretch, behind the
/// bytes that copies may reach back to.
class FilteredRows {
 public:
  FilteredRows(const Image& image, Effort effort)
      : image_(image),
        effort_(effort),
        next_(image.Height()),
        row_(std::size_t(image.Width()) * 3),
        above_(row_.size()) {}

  bool done() const { return next_ == 0; }
  const Bytes& bytes() const { return bytes_; }
  std::size_t from() const { return from_; }

  void takeStretch() {
    const std::size_t kept = std::min<std::size_t>(bytes_.size(), deflate::kWindow);
    bytes_.erase(bytes_.begin(), bytes_.end() - std::ptrdiff_t(kept));
    from_ = kept;
    const Bytes above = above_;
    const int first = next_, count = std::min(next_, int(kStretch / stride() + 1));
    next_ -= count;
    bytes_.resize(from_ + std::size_t(count) * stride());
    const auto leastDifference = [this](std::size_t) { return png::leastDifference(row_, above_); };
    filterRows(first, leastDifference);
    if (effort_.trialDepth == 0) return;
    deflate::Estimate best = estimate();
    Bytes chosen = bytes_;
    const auto keepIfBetter = [&] {
      const deflate::Estimate tried = estimate();
      if (tried.total >= best.total) return;
      best = tried;
      chosen = bytes_;
    };
    for (unsigned filter = 0; filter < png::kFilters; ++filter) {
      above_ = above;
      filterRows(first, [filter](std::size_t) { return filter; });
      keepIfBetter();
    }
    above_ = above;
    chooseByTrial(first, best.costs);
    keepIfBetter();
    bytes_ = chosen;
  }

 private:
  std::size_t stride() const { return 1 + row_.size(); }

  /// Filters the rows below `first` by choose(place in bytes_), row_ and above_ being theirs.
  template <class Choose>
  void filterRows(int first, const Choose& choose) {
    std::size_t at = from_;
    for (int y = first - 1; y >= next_; --y, at += stride()) {
      readRow(y);
      png::filterRow(choose(at), row_, above_, &bytes_[at]);
      above_.swap(row_);
    }
  }

  deflate::Estimate estimate() const {
    return deflate::estimate(bytes_, from_, effort_.trialDepth, deflate::costsAtFirst());
  }

  void readRow(int y) {
    std::uint8_t* sample = row_.data();
    for (int x = 0; x < image_.Width(); ++x, sample += 3) {
      const Rgb8 pixel = image_.getPixel(x, y);
      sample[0] = pixel.r;
      sample[1] = pixel.g;
      sample[2] = pixel.b;
    }
  }

  /// Takes for each row the filter that costs least behind the rows that are chosen already.
  void chooseByTrial(int first, const deflate::Costs& costs) {
    CopyFinder finder(bytes_.data(), bytes_.size(), effort_.trialDepth);
    for (std::size_t at = 0; at < from_; ++at) finder.add(at);
    deflate::CopyLists lists;
    std::size_t done = from_;
    filterRows(first, [&](std::size_t at) {
      for (; done < at; ++done) finder.add(done);
      unsigned best = 0;
      std::uint64_t least = ~std::uint64_t{0};
      for (unsigned filter = 0; filter < png::kFilters; ++filter) {
        png::filterRow(filter, row_, above_, &bytes_[at]);
        lists.collect(finder, at, at + stride());
        finder.remove(at, at + stride());
        const std::uint64_t cost = deflate::leastCost(&bytes_[at], lists, costs);
        if (cost >= least) continue;
        least = cost;
        best = filter;
      }
      return best;
    });
  }

  const Image& image_;
  const Effort effort_;
  int next_;  // rows still to come: those with y below
  Bytes row_, above_, bytes_;
  std::size_t from_ = 0;
};

/// Hands the file to put(bytes), piece by piece.
template <class Put>
void encode(const Image& image, Effort effort, const Put& put) {
  put(headOf(image));
  FilteredRows rows(image, effort);
  DeflateWriter writer(effort.depth, effort.rounds);
  while (!rows.done()) {
    rows.takeStretch();
    writer.append(rows.bytes(), rows.from());
    if (rows.done()) writer.finish();
    put(chunk("IDAT", writer.take()));
  }
  put(chunk("IEND", {}));
}

}  // namespace

Bytes encodePng(const Image& image, PngEffort effort) {
  Bytes all;
  encode(image, effort == PngEffort::quick ? kQuick : effortFor(image),
         [&all](const Bytes& piece) { all.insert(all.end(), piece.begin(), piece.end()); });
  return all;
}

void writePng(const Image& image, const std::string& path) {
  OutputFile file(path);
  encode(image, effortFor(image),
         [&file](const Bytes& piece) { file.write(piece.data(), piece.size()); });
  file.commit();
}
