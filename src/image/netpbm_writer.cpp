// PPM and PFM writer.
#include <cstring>

#include "image/netpbm.h"
#include "image/output_file.h"

namespace {

std::string headOf(const char* kind, int width, int height, const char* range) {
  return std::string(kind) + "\n" + std::to_string(width) + " " + std::to_string(height) + "\n" +
         range + "\n";
}

void appendFloat(float value, Bytes& bytes) {
  static_assert(sizeof(float) == 4);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(bits >> shift & 255));
  }
}

/// Hands the file to put(bytes), row by row.
template <class Put>
void encode(const Image& image, const Put& put) {
  const std::string head = headOf("P6", image.Width(), image.Height(), "255");
  Bytes bytes(head.begin(), head.end());
  for (int y = image.Height() - 1; y >= 0; --y) {
    for (int x = 0; x < image.Width(); ++x) {
      const Rgb8 pixel = image.getPixel(x, y);
      bytes.insert(bytes.end(), {pixel.r, pixel.g, pixel.b});
    }
    put(bytes);
    bytes.clear();
  }
}

template <class Put>
void encode(const FloatImage& image, const Put& put) {
  const std::string head = headOf("PF", image.Width(), image.Height(), "-1");
  Bytes bytes(head.begin(), head.end());
  for (int y = 0; y < image.Height(); ++y) {
    for (int x = 0; x < image.Width(); ++x) {
      const Vec3f& pixel = image.getPixel(x, y);
      for (const float component : {pixel.r(), pixel.g(), pixel.b()}) appendFloat(component, bytes);
    }
    put(bytes);
    bytes.clear();
  }
}

template <class Picture>
Bytes encoded(const Picture& image) {
  Bytes all;
  encode(image, [&all](const Bytes& piece) { all.insert(all.end(), piece.begin(), piece.end()); });
  return all;
}

template <class Picture>
void writeEncoded(const Picture& image, const std::string& path) {
  OutputFile file(path);
  encode(image, [&file](const Bytes& piece) { file.write(piece.data(), piece.size()); });
  file.commit();
}

}  // namespace

Bytes encodePpm(const Image& image) { return encoded(image); }
void writePpm(const Image& image, const std::string& path) { writeEncoded(image, path); }
Bytes encodePfm(const FloatImage& image) { return encoded(image); }
void writePfm(const FloatImage& image, const std::string& path) { writeEncoded(image, path); }
