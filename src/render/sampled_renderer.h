// SampledRenderer: pictures with several samples in a pixel, or with a filter, tile by tile.
#pragma once
#include <memory>

#include "render/film.h"
#include "render/renderer.h"
#include "render/sample_tracing.h"
#include "render/tiles.h"

class SampledRenderer {
 public:
  /// Fills targets.color and targets.samples, whichever are given, of `size` pixels (before
  /// `samples` is enlarged). Nothing is owned. Tiles are small enough to be shared by so many
  /// threads.
  SampledRenderer(const SampledScene& scene, const SamplingOptions& options,
                  const RenderTargets& targets, Vec2<int> size, int threads);

  int tileCount() const { return tiling_.count(); }
  PixelRectangle areaOf(int tile) const { return tiling_.areaOf(tile); }
  void renderTile(int tile) const;

 private:
  void store(const Film& film, const PixelRectangle& area) const;

  const SampledScene scene_;
  const SamplingOptions options_;
  const RenderTargets targets_;
  const std::unique_ptr<const Sampler> sampler_;
  const Filter filter_;
  int reach_;  // pixels beyond a tile whose samples count in it
  Tiling tiling_;
};
