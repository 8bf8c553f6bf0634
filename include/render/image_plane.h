// Places on the picture: pixels, samples in them, rectangles of pixels. Pixels are counted from 0
// from the lower left corner of the whole picture.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "math/vec3.h"

struct Pixel {
  int i, j;
};

/// A place where a ray is sent through the picture.
struct Sample {
  Pixel at;
  Vec2d offset;  ///< from the lower left corner of the pixel: each component from 0 to below 1

  /// From that of the picture, in pixels.
  Vec2d place() const { return {at.i + offset.x(), at.j + offset.y()}; }
};

/// The pixels left <= i < right, bottom <= j < top, which may lie outside of the picture.
struct PixelRectangle {
  int left, bottom, right, top;

  int width() const { return right - left; }
  int height() const { return top - bottom; }
  bool contains(Pixel at) const {
    return at.i >= left && at.i < right && at.j >= bottom && at.j < top;
  }
  /// The number of a pixel inside, counted row by row.
  std::size_t index(Pixel at) const {
    return std::size_t(at.j - bottom) * std::size_t(width()) + std::size_t(at.i - left);
  }
  std::size_t pixelCount() const { return std::size_t(width()) * std::size_t(height()); }
  PixelRectangle moved(int x, int y) const { return {left + x, bottom + y, right + x, top + y}; }
  PixelRectangle grown(int margin) const {
    return {left - margin, bottom - margin, right + margin, top + margin};
  }
  /// What both have in common; where that is nothing, no pixel is in it.
  PixelRectangle within(const PixelRectangle& other) const {
    return {std::max(left, other.left), std::max(bottom, other.bottom),
            std::min(right, other.right), std::min(top, other.top)};
  }
};

/// A picture of width x height pixels in squares of `side`, those at its right and upper edge
/// perhaps cut off.
struct Tiling {
  int width, height, side;

  int columns() const { return (width + side - 1) / side; }
  int count() const { return columns() * ((height + side - 1) / side); }
  /// The pixels of a tile, 0 <= tile < count(): row by row from the lowest.
  PixelRectangle areaOf(int tile) const {
    const int left = tile % columns() * side, bottom = tile / columns() * side;
    return {left, bottom, std::min(left + side, width), std::min(bottom + side, height)};
  }
  /// The numbers of the tiles that make up `area`, whose edges are edges of tiles.
  std::vector<int> tilesIn(const PixelRectangle& area) const {
    std::vector<int> tiles;
    for (int j = area.bottom / side; j * side < area.top; ++j) {
      for (int i = area.left / side; i * side < area.right; ++i) tiles.push_back(j * columns() + i);
    }
    return tiles;
  }
};

/// The pixels of a block of 16 x 16 in the order in which they are taken (G. M. Morton's, 1966):
/// of a pixel's number every other bit, from the lowest on, makes its column, the others its row.
/// So any 2^n rays in a row lie in a small block, where they meet much the same things.
inline constexpr int kBlockSide = 16;
inline constexpr auto kBlockOrder = [] {
  std::array<Pixel, kBlockSide * kBlockSide> order{};
  for (int number = 0; number < kBlockSide * kBlockSide; ++number) {
    for (int bit = 0; 1 << bit < kBlockSide; ++bit) {
      order[std::size_t(number)].i |= (number >> 2 * bit & 1) << bit;
      order[std::size_t(number)].j |= (number >> (2 * bit + 1) & 1) << bit;
    }
  }
  return order;
}();

/// Calls visit(pixel) for the pixels of `area` in an order of the whole plane: blocks of 16 x 16
/// row by row, those of a block in kBlockOrder. Any two pixels come in the same order in every
/// area.
template <class Visit>
void visitInOrder(const PixelRectangle& area, const Visit& visit) {
  const auto blockStart = [](int at) { return at - (at % kBlockSide + kBlockSide) % kBlockSide; };
  for (int j = blockStart(area.bottom); j < area.top; j += kBlockSide) {
    for (int i = blockStart(area.left); i < area.right; i += kBlockSide) {
      const PixelRectangle block = {i, j, i + kBlockSide, j + kBlockSide};
      const bool isWhole = block.within(area).pixelCount() == block.pixelCount();
      for (const Pixel place : kBlockOrder) {
        const Pixel at = {i + place.i, j + place.j};
        if (isWhole || area.contains(at)) visit(at);
      }
    }
  }
}

/// Those pixels.
inline std::vector<Pixel> pixelsInOrder(const PixelRectangle& area) {
  std::vector<Pixel> pixels;
  pixels.reserve(area.pixelCount());
  visitInOrder(area, [&](Pixel at) { pixels.push_back(at); });
  return pixels;
}
