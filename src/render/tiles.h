// Tiles: a picture is cut into squares, which threads take one by one, so that none of them waits
// for another's slow one.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>

#include "render/image_plane.h"
#include "render/render_options.h"
#include "system/worker_threads.h"

/// A picture of width x height pixels in squares of `side`, those at its right and upper edge
/// perhaps smaller.
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

/// How much stack a thread needs that traces rays: enough for the deepest scene, and for each
/// bounce that the options allow (measured: below 1 kB a bounce, 1.6 kB between solid textures,
/// 3 kB with sanitizers). In bytes.
inline std::size_t tracingStack(const RenderOptions& options) {
  constexpr std::size_t kBase = 2 << 20, kPerBounce = 8192;
  return kBase + std::size_t(options.maxBounces) * kPerBounce;
}

/// Calls work(area) for every tile, on at most `threads` >= 1 threads with stack enough to trace
/// rays; each takes the next tile that nobody has begun. Throws what a worker throws.
template <class Work>
void shareTiles(const Tiling& tiling, const RenderOptions& options, int threads, const Work& work) {
  const int tiles = tiling.count();
  std::atomic<int> next{0};
  runOnThreads(std::min(threads, tiles), tracingStack(options), [&](int) {
    for (int tile; (tile = next++) < tiles;) work(tiling.areaOf(tile));
  });
}
