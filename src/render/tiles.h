// Tiles: a picture is cut into squares, which threads take one by one, so that none of them waits
// for another's slow one.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>

#include "render/image_plane.h"
#include "render/renderer.h"
#include "system/worker_threads.h"

/// The side of the smallest tiles, in pixels. Small, as some pixels take a hundred times as long as
/// others.
inline constexpr int kTileSide = TileStore::kSide;

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
};

/// The next tile that nobody has taken; none at the end. Any thread may ask at any time.
using NextTile = std::function<std::optional<PixelRectangle>()>;

/// How much stack a thread needs that traces rays: enough for the deepest scene, and for each
/// bounce that the options allow (measured: below 1 kB a bounce, 1.6 kB between solid textures,
/// 3 kB with sanitizers). In bytes.
inline std::size_t tracingStack(const RenderOptions& options) {
  constexpr std::size_t kBase = 2 << 20, kPerBounce = 8192;
  return kBase + std::size_t(options.maxBounces) * kPerBounce;
}

/// Calls work(next) on at most `threads` >= 1 threads, which have stack enough to trace rays; each
/// is to work on the tiles that it takes until there are no more. Throws what any of them throws.
inline void shareTiles(const Tiling& tiling, const RenderOptions& options, int threads,
                       const std::function<void(const NextTile& next)>& work) {
  std::atomic<int> taken{0};
  const NextTile next = [&]() -> std::optional<PixelRectangle> {
    const int tile = taken++;
    if (tile >= tiling.count()) return std::nullopt;
    return tiling.areaOf(tile);
  };
  runOnThreads(std::min(threads, tiling.count()), tracingStack(options), [&](int) { work(next); });
}
