// Colours that are far apart for small numbers: the bits of the number are dealt out to red, green
// and blue in turn, and each component takes 0, 255, 127, 191, 63 ..., always the middle of a gap.
#include "render/material_colors.h"

namespace {

constexpr std::size_t kColors = (1 << 24) - 1;

unsigned reversedByte(unsigned byte) {
  unsigned reversed = 0;
  for (int bit = 0; bit < 8; ++bit) reversed = reversed << 1 | (byte >> bit & 1);
  return reversed;
}

/// Every third bit of `number` from bit `first` on, as a number.
unsigned everyThirdBit(std::size_t number, int first) {
  unsigned bits = 0;
  for (int bit = 0; bit < 8; ++bit) bits |= unsigned(number >> (first + 3 * bit) & 1) << bit;
  return bits;
}

/// Level 0 is 0; the other 255 are all different and above 0.
std::uint8_t componentOf(unsigned level) {
  return std::uint8_t(level == 0 ? 0 : 255 - reversedByte(level - 1));
}

std::uint32_t packed(Rgb8 color) {
  return std::uint32_t(color.r) << 16 | std::uint32_t(color.g) << 8 | color.b;
}

}  // namespace

MaterialColors::MaterialColors(const SceneParser& scene) : scene_(scene) {
  for (int i = 0; i < scene.getNumMaterials(); ++i) {
    numbers_.emplace(scene.getMaterial(i), std::size_t(i));
  }
}

Rgb8 MaterialColors::colorOf(std::size_t index) {
  const std::size_t number = index % kColors + 1;
  return {componentOf(everyThirdBit(number, 0)), componentOf(everyThirdBit(number, 1)),
          componentOf(everyThirdBit(number, 2))};
}

Rgb8 MaterialColors::of(const Material* material) const {
  const auto found = numbers_.find(material);
  return found == numbers_.end() ? Rgb8{128, 128, 128} : colorOf(found->second);
}

std::string MaterialColors::legend(const Image& picture) const {
  std::unordered_map<std::uint32_t, std::size_t> pixels;
  for (int y = 0; y < picture.Height(); ++y) {
    for (int x = 0; x < picture.Width(); ++x) ++pixels[packed(picture.getPixel(x, y))];
  }
  std::string lines;
  for (int i = 0; i < scene_.getNumMaterials(); ++i) {
    const Rgb8 color = colorOf(std::size_t(i));
    const auto found = pixels.find(packed(color));
    if (found == pixels.end()) continue;
    lines += "material " + std::to_string(i) + ": " + std::to_string(color.r) + " " +
             std::to_string(color.g) + " " + std::to_string(color.b) + ", " +
             scene_.getMaterial(i)->getKind() + ", " + std::to_string(found->second) +
             (found->second == 1 ? " pixel\n" : " pixels\n");
  }
  return lines;
}
