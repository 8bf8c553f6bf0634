// Pictures and bytes as the files and streams that hold them.
#pragma once
#include <algorithm>

#include "image/deflate.h"
#include "image/picture_file.h"

namespace encoded {

/// All that encode(sink) puts out.
template <class Encode>
Bytes all(const Encode& encode) {
  Bytes bytes;
  encode([&bytes](const Bytes& piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); });
  return bytes;
}

inline Bytes tga(const Image& image) { return encodePicture(image, PictureFormat::tga); }
inline Bytes ppm(const Image& image) { return encodePicture(image, PictureFormat::ppm); }
inline Bytes png(const Image& image, int threads = 1) {
  return all([&](const Sink& sink) { encodePng(image, sink, threads); });
}

/// A zlib stream of pieces of `pieceSize` bytes, but for the last one.
inline Bytes zlib(const Bytes& bytes, std::size_t pieceSize = std::size_t(1) << 30) {
  Bytes stream(std::begin(kZlibHead), std::end(kZlibHead));
  std::size_t from = 0;
  do {
    const std::size_t to = std::min(bytes.size(), from + pieceSize);
    const Bytes piece = deflatePiece(bytes, from, to, to == bytes.size());
    stream.insert(stream.end(), piece.begin(), piece.end());
    from = to;
  } while (from < bytes.size());
  const std::uint32_t sum = adler32(bytes.data(), bytes.size());
  for (int shift = 24; shift >= 0; shift -= 8) stream.push_back(std::uint8_t(sum >> shift));
  return stream;
}

}  // namespace encoded
