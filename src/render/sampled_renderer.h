// SampledRenderer: pictures with several samples in a pixel, or with a filter, tile by tile.
//
// A tile is computed from its own pixels and those around it that the filter reaches; these are
// traced again for each tile, so that memory does not grow with the picture. The samples are added
// in an order of the whole plane (blocks of 16 x 16 pixels row by row, Morton's order in a block,
// the samples of a pixel by number), so no byte depends on where tiles begin or end.
#pragma once
#include "render/film.h"
#include "render/renderer.h"
#include "render/sample_batch.h"
#include "render/sampler.h"

class SampledRenderer {
 public:
  /// Fills targets.color and targets.samples, whichever are given. Nothing is owned. Tiles are
  /// small enough to be shared by so many threads.
  SampledRenderer(const SampledScene& scene, const SamplingOptions& options,
                  const RenderTargets& targets, int threads);

  int tileCount() const;
  PixelRectangle areaOf(int tile) const;
  void renderTile(int tile) const;

 private:
  void store(const Film& film, const PixelRectangle& area) const;

  const SampledScene scene_;
  const SamplingOptions options_;
  const RenderTargets targets_;
  const std::unique_ptr<const Sampler> sampler_;
  const std::unique_ptr<const Filter> filter_;
  int reach_;     // pixels beyond a tile whose samples count in it
  int tileSize_;  // a multiple of 16
};
