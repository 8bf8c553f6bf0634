// Fuzz target: the PNG reader. As no made-up input has right checksums, it is taken three ways:
// - with PNG's signature: as a file, once as it is and once with every chunk's CRC put right;
// - else, where the first byte is odd: as the deflate data of a stream;
// - else as a picture: width - 1, height - 1, colour type and interlacing, depth, then what the
// zlib
//   stream holds.
// Demands: errors are ImageError or InflateError and one line that prints; a picture that was read
// has pixels; one that was well wrapped is read exactly when its size fits.
#include <algorithm>

#include "fuzz.h"
#include "image/deflate.h"
#include "image/picture_file.h"
#include "image/png_format.h"

namespace {

const Bytes kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kMostInflated = 1 << 20;

void appendBig(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(std::uint8_t(value >> shift));
}

void appendChunk(Bytes& file, const std::string& type, const Bytes& content) {
  appendBig(file, std::uint32_t(content.size()));
  const std::size_t start = file.size();
  file.insert(file.end(), type.begin(), type.end());
  file.insert(file.end(), content.begin(), content.end());
  appendBig(file, png::crc32(&file[start], file.size() - start));
}

/// A zlib stream of stored blocks.
Bytes wrapped(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kBlock = 65535;
  Bytes stream = {0x78, 0x01};
  for (std::size_t at = 0; at == 0 || at < size; at += kBlock) {
    const std::size_t length = std::min(kBlock, size - at);
    stream.push_back(at + length == size);
    for (const std::size_t word : {length, ~length}) {
      stream.push_back(std::uint8_t(word));
      stream.push_back(std::uint8_t(word >> 8));
    }
    stream.insert(stream.end(), data + at, data + at + length);
  }
  appendBig(stream, adler32(data, size));
  return stream;
}

/// Returns whether it is a picture.
bool decode(const Bytes& file) {
  try {
    FloatImage exact;
    const Image image = decodePng(file, "in.png", &exact);
    fuzz::demand(image.Width() >= 1 && image.Height() >= 1, "a picture has pixels");
    fuzz::demand(exact.Width() == 0 || exact.Width() == image.Width(), "floats are as many");
    return true;
  } catch (const ImageError& error) {
    fuzz::demand(fuzz::isPlainLine(error.what()), "an error is one line that prints");
    return false;
  }
}

void repairChecksums(Bytes& file) {
  std::size_t at = kSignature.size();
  while (file.size() - at >= 12) {
    const std::size_t length = std::size_t(file[at]) << 24 | std::size_t(file[at + 1]) << 16 |
                               std::size_t(file[at + 2]) << 8 | file[at + 3];
    if (length > file.size() - at - 12) return;
    const std::uint32_t crc = png::crc32(&file[at + 4], length + 4);
    at += 8 + length;
    for (int shift = 24; shift >= 0; shift -= 8) file[at++] = std::uint8_t(crc >> shift);
  }
}

void inflateAlone(const Bytes& input) {
  try {
    std::size_t position = 1;
    const Bytes output = inflate(input, position, kMostInflated);
    fuzz::demand(output.size() <= kMostInflated, "no more is inflated than was allowed");
    fuzz::demand(position <= input.size(), "a stream ends inside its bytes");
  } catch (const InflateError& error) {
    fuzz::demand(fuzz::isPlainLine(error.what()), "an error is one line that prints");
  }
}

void decodeWrapped(const Bytes& input) {
  if (input.size() < 4) return;
  static constexpr std::uint8_t kTypes[] = {0, 2, 3, 4, 6, 1, 5, 7};
  Bytes header;
  appendBig(header, input[0] / 2 + 1u);
  appendBig(header, input[1] + 1u);
  const std::uint8_t depths[] = {8, 1, 2, 4, 16, 8, 8, input[3]};
  const std::uint8_t interlacing = input[2] >> 3 & 1;
  header.insert(header.end(), {depths[input[3] & 7], kTypes[input[2] & 7], 0, 0, interlacing});
  Bytes file = kSignature;
  appendChunk(file, "IHDR", header);
  if (kTypes[input[2] & 7] == 3) appendChunk(file, "PLTE", Bytes(3 * (1 + input[3] / 8u), 77));
  const Bytes stream = wrapped(input.data() + 4, input.size() - 4);
  const auto middle = stream.begin() + std::ptrdiff_t(stream.size() / 2);
  appendChunk(file, "IDAT", Bytes(stream.begin(), middle));
  appendChunk(file, "IDAT", Bytes(middle, stream.end()));
  appendChunk(file, "IEND", {});
  decode(file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes input(data, data + size);
  if (size >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), data)) {
    decode(input);
    repairChecksums(input);
    decode(input);
  } else if (size > 0 && (data[0] & 1) != 0) {
    inflateAlone(input);
  } else {
    decodeWrapped(input);
  }
  return 0;
}
