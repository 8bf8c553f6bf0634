// PNG writer: 8 bits per sample, with a filter for each row that makes it compress well.
#include "image/checksum.h"
#include "image/deflate.h"
#include "image/output_file.h"
#include "image/png.h"
#include "image/png_rows.h"

namespace {

/// How hard to try.
struct Effort {
  png::FilterChoice choice;
  unsigned trialDepth;  // see png::FilteredRows
  unsigned depth;       // see DeflateWriter
  int rounds;
};
constexpr Effort kThorough = {png::FilterChoice::perRow, 16, 100, 2};
constexpr Effort kLarge = {png::FilterChoice::perStretch, 4, 48, 1};
constexpr Effort kQuick = {png::FilterChoice::leastDifferences, 0, 16, 1};
constexpr std::size_t kMostThorough = 1 << 19;  // pixels

Effort effortFor(const Image& image) {
  const auto pixels = static_cast<std::size_t>(image.Width()) * std::size_t(image.Height());
  return pixels <= kMostThorough ? kThorough : kLarge;
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

Bytes signature() { return {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'}; }

Bytes header(const Image& image, const png::Samples& samples) {
  Bytes data;
  appendBigEndian(static_cast<std::uint32_t>(image.Width()), data);
  appendBigEndian(static_cast<std::uint32_t>(image.Height()), data);
  data.insert(data.end(), {8, samples.colorType()});  // bits of a sample
  data.insert(data.end(), {0, 0, 0});                 // deflate, filters, not interlaced
  return chunk("IHDR", data);
}

Bytes palette(const png::Samples& samples) {
  Bytes data;
  for (const Rgb8 color : samples.palette()) {
    data.insert(data.end(), {color.r, color.g, color.b});
  }
  return chunk("PLTE", data);
}

/// Hands the file to put(bytes), piece by piece.
template <class Put>
void encode(const Image& image, Effort effort, int threads, const Put& put) {
  const png::Samples samples(image);
  put(signature());
  put(header(image, samples));
  if (samples.colorType() == png::kPalette) put(palette(samples));
  png::FilteredRows rows(samples, image.Height(), effort.choice, effort.trialDepth, threads);
  DeflateWriter writer(effort.depth, effort.rounds, threads);
  while (!rows.done()) {
    rows.takeStretch();
    writer.append(rows.bytes(), rows.from(), rows.costs());
    if (rows.done()) writer.finish();
    put(chunk("IDAT", writer.take()));
  }
  put(chunk("IEND", {}));
}

}  // namespace

Bytes encodePng(const Image& image, PngEffort effort, int threads) {
  Bytes all;
  encode(image, effort == PngEffort::quick ? kQuick : effortFor(image), threads,
         [&all](const Bytes& piece) { all.insert(all.end(), piece.begin(), piece.end()); });
  return all;
}

void writePng(const Image& image, const std::string& path, int threads) {
  OutputFile file(path);
  encode(image, effortFor(image), threads,
         [&file](const Bytes& piece) { file.write(piece.data(), piece.size()); });
  file.commit();
}
