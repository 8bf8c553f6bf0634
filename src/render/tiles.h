// Tiles: the squares of a picture, which threads take one by one, so that none of them waits for
// another's slow one.
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
inline void shareTiles(const Tiling& tiling, const RayTracer& tracer, int threads,
                       const std::function<void(const NextTile& next)>& work) {
  std::atomic<int> taken{0};
  const NextTile next = [&]() -> std::optional<PixelRectangle> {
    const int tile = taken++;
    if (tile >= tiling.count()) return std::nullopt;
    return tiling.areaOf(tile);
  };
  const std::size_t stack = tracingStack(tracer.options());
  runOnThreads(std::min(threads, tiling.count()), stack, [&](int) { work(next); });
}
