// Pictures with several samples in a pixel, or with a filter.
//
// A tile is computed from its own pixels and those around it that the filter reaches; these are
// traced again for each tile, so that memory does not grow with the picture. The samples are added
// in an order of the whole plane (that of pixelsInOrder, the samples of a pixel by number), so no
// byte depends on where tiles begin or end.
#include "render/sampled_renderer.h"

#include <algorithm>

namespace {

constexpr int kBlock = 16, kMostBlocks = 8, kTilesPerThread = 4;
/// What the first samples of a tile may take where others may have to be added to them.
constexpr std::size_t kMostTileBytes = 32 << 20;

/// Tiles with `margin` pixels around them that are traced too: 32 times as long as that, up to 128
/// pixels, so that the margins are few; less where so many first samples could not be kept, or
/// where there would be too few tiles to keep all threads busy. The sides are multiples of 16.
Tiling tilingFor(Vec2<int> picture, const Sampler& sampler, int margin, int threads) {
  const auto isTooLarge = [&](const Tiling& tiling) {
    const auto side = std::size_t(tiling.side + 2 * margin);
    const std::size_t samples = side * side * std::size_t(sampler.getNumFirst());
    const bool tooMany = sampler.isAdaptive() && samples * kBytesPerSample > kMostTileBytes;
    return tooMany || tiling.count() / kTilesPerThread < threads;
  };
  Tiling tiling = {picture.x(), picture.y(), kBlock * std::clamp(2 * margin, 1, kMostBlocks)};
  while (tiling.side > kBlock && isTooLarge(tiling)) tiling.side -= kBlock;
  return tiling;
}

}  // namespace

SampledRenderer::SampledRenderer(const SampledScene& scene, const SamplingOptions& options,
                                 const RenderTargets& targets, Vec2<int> size, int threads)
    : scene_(scene),
      options_(options),
      targets_(targets),
      sampler_(makeSampler(options)),
      filter_(options.filter, options.filterSize),
      reach_(targets.color ? filter_.getSupportRadius() : 0),
      tiling_(tilingFor(size, *sampler_, reach_ + int(sampler_->isAdaptive()), threads)) {}

void SampledRenderer::renderTile(int tile) const {
  // Samples are taken of the whole picture, which the targets may be a window of.
  const PixelRectangle inTargets = areaOf(tile);
  const PictureWindow& window = targets_.window;
  const PixelRectangle area = {inTargets.left + window.left, inTargets.bottom + window.bottom,
                               inTargets.right + window.left, inTargets.top + window.bottom};
  Film film(area, filter_);
  if (targets_.samples) drawSamplesGround(*targets_.samples, targets_.samplesZoom, area);
  const auto take = [&](const Sample& sample, const Vec3f& color, double share) {
    film.addSample(sample, color, share);
    if (targets_.samples && area.contains(sample.at)) {
      drawSample(*targets_.samples, targets_.samplesZoom, sample, color);
    }
  };
  takeSamples(scene_, *sampler_, options_.tolerance, area.grown(reach_), take);
  if (targets_.color) store(film, area);
}

void SampledRenderer::store(const Film& film, const PixelRectangle& area) const {
  for (int j = area.bottom; j < area.top; ++j) {
    for (int i = area.left; i < area.right; ++i) {
      const Vec3f color = film.getColor({i, j});
      const Pixel at = {i - targets_.window.left, j - targets_.window.bottom};
      targets_.color->setPixel(at.i, at.j, color);
      if (targets_.exactColor) targets_.exactColor->setPixel(at.i, at.j, color);
    }
  }
}
