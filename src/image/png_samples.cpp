// PNG samples.
#include "image/png_samples.h"

#include <algorithm>
#include <tuple>

namespace png {

namespace {

constexpr std::size_t kMostColors = 256;
constexpr std::size_t kEntry = 3,
                      kChunk = 12;  // bytes of a colour, and of a chunk besides its data

bool isLess(Rgb8 a, Rgb8 b) { return std::tie(a.r, a.g, a.b) < std::tie(b.r, b.g, b.b); }

/// Rising; empty where there are more than a palette holds.
std::vector<Rgb8> colorsOf(const Image& image) {
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
  return colors;
}

}  // namespace

Samples::Samples(const Image& image) : image_(image), palette_(colorsOf(image)) {
  const auto pixels = std::size_t(image.Width()) * std::size_t(image.Height());
  if (palette_.size() * kEntry + kChunk >= pixels * (kEntry - 1)) palette_.clear();
}

void Samples::readRow(int y, Bytes& row) const {
  row.clear();
  for (int x = 0; x < image_.Width(); ++x) {
    const Rgb8 pixel = image_.getPixel(x, y);
    if (palette_.empty()) {
      row.insert(row.end(), {pixel.r, pixel.g, pixel.b});
    } else {
      row.push_back(indexOf(pixel));
    }
  }
}

std::uint8_t Samples::indexOf(Rgb8 color) const {
  const auto place = std::lower_bound(palette_.begin(), palette_.end(), color, isLess);
  return static_cast<std::uint8_t>(place - palette_.begin());
}

}  // namespace png
