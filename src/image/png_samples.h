// The samples of a picture in a PNG: of the kind that takes the fewest bytes.
#pragma once
#include <cstdint>
#include <vector>

#include "image/bytes.h"
#include "image/image.h"

namespace png {

/// Colour types (RFC 2083, 4.1.1).
enum ColorType : std::uint8_t { kGrey = 0, kRgb = 2, kPalette = 3, kGreyAlpha = 4, kRgba = 6 };

/// Indices of 8 bits into a palette where there are at most 256 colours and the palette costs less
/// than it saves; else RGB. Grey pictures get a palette too: readers turn that into RGB, while a
/// grey PNG of one channel counts as another picture than the TGA for some (OpenImageIO's idiff).
class Samples {
 public:
  /// Refers to `image`.
  explicit Samples(const Image& image);

  ColorType colorType() const { return palette_.empty() ? kRgb : kPalette; }
  unsigned perPixel() const { return palette_.empty() ? 3 : 1; }
  std::size_t rowSize() const { return perPixel() * std::size_t(image_.Width()); }
  /// Rising by red, then green, then blue; empty for RGB.
  const std::vector<Rgb8>& palette() const { return palette_; }
  /// The samples of the row at height y, from the left: rowSize() bytes.
  void readRow(int y, Bytes& row) const;

 private:
  std::uint8_t indexOf(Rgb8 color) const;

  const Image& image_;
  std::vector<Rgb8> palette_;
};

}  // namespace png
