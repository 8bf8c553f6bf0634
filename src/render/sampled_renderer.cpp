// Pictures with several samples in a pixel, or with a filter.
#include "render/sampled_renderer.h"

#include <algorithm>

#include "render/adaptive_sampling.h"
#include "render/film.h"
#include "render/samples_picture.h"

namespace {

constexpr int kBlock = 16, kMostBlocks = 8, kTilesPerThread = 4;
/// What the first samples of a tile may take where others may have to be added to them.
constexpr std::size_t kMostTileBytes = 32 << 20;

bool isRefined(const Sampler& sampler) { return sampler.getNumFirst() < sampler.getNumSamples(); }

int tilesAlong(int pixels, int tileSize) { return (pixels + tileSize - 1) / tileSize; }

/// The side of a tile with `margin` pixels around it that are traced too: 32 times as long, up to
/// 128 pixels, so that they are few; less where so many first samples could not be kept, or where
/// there would be too few tiles to keep all threads busy.
int tileSizeFor(const SampledScene& scene, const Sampler& sampler, int margin, int threads) {
  const auto isTooLarge = [&](int size) {
    const auto side = std::size_t(size + 2 * margin);
    const std::size_t samples = side * side * std::size_t(sampler.getNumFirst());
    const bool tooMany = samples * AdaptiveSampling::kBytesPerSample > kMostTileBytes;
    const int tiles = tilesAlong(scene.width, size) * tilesAlong(scene.height, size);
    return (isRefined(sampler) && tooMany) || tiles / kTilesPerThread < threads;
  };
  int blocks = std::clamp(2 * margin, 1, kMostBlocks);
  while (blocks > 1 && isTooLarge(kBlock * blocks)) --blocks;
  return kBlock * blocks;
}

}  // namespace

SampledRenderer::SampledRenderer(const SampledScene& scene, const SamplingOptions& options,
                                 const RenderTargets& targets, int threads)
    : scene_(scene),
      options_(options),
      targets_(targets),
      sampler_(makeSampler(options)),
      filter_(makeFilter(options)),
      reach_(targets.color ? filter_->getSupportRadius() : 0),
      tileSize_(tileSizeFor(scene, *sampler_, reach_ + int(isRefined(*sampler_)), threads)) {}

int SampledRenderer::tileCount() const {
  return tilesAlong(scene_.width, tileSize_) * tilesAlong(scene_.height, tileSize_);
}

PixelRectangle SampledRenderer::areaOf(int tile) const {
  const int columns = tilesAlong(scene_.width, tileSize_);
  const int left = tile % columns * tileSize_, bottom = tile / columns * tileSize_;
  return {left, bottom, std::min(left + tileSize_, scene_.width),
          std::min(bottom + tileSize_, scene_.height)};
}

void SampledRenderer::renderTile(int tile) const {
  const PixelRectangle area = areaOf(tile), sources = area.grown(reach_);
  Film film(area, *filter_);
  if (targets_.samples) drawPixels(*targets_.samples, targets_.samplesZoom, area);
  const auto take = [&](const Sample& sample, const Vec3f& color, double share) {
    film.addSample(sample.at, sample.offset, color, share);
    if (targets_.samples && area.contains(sample.at)) {
      drawSample(*targets_.samples, targets_.samplesZoom, sample, color);
    }
  };
  if (isRefined(*sampler_)) {
    AdaptiveSampling(scene_, *sampler_, options_.tolerance, sources).finish(take);
  } else {
    SampleBatch batch(scene_,
                      [&](const Sample& sample, const Vec3f& color) { take(sample, color, 1); });
    for (const Pixel at : pixelsInOrder(sources)) {
      for (int n = 0; n < sampler_->getNumSamples(); ++n) {
        batch.add({at, sampler_->getSamplePosition(at.i, at.j, n)});
      }
    }
    batch.flush();
  }
  if (targets_.color) store(film, area);
}

void SampledRenderer::store(const Film& film, const PixelRectangle& area) const {
  for (int j = area.bottom; j < area.top; ++j) {
    for (int i = area.left; i < area.right; ++i) {
      const Vec3f color = film.getColor({i, j});
      targets_.color->setPixel(i, j, color);
      if (targets_.exactColor) targets_.exactColor->setPixel(i, j, color);
    }
  }
}
