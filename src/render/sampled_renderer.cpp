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

int tilesAlong(int pixels, int tileSize) { return (pixels + tileSize - 1) / tileSize; }

/// The side of a tile with `margin` pixels around it that are traced too: 32 times as long, up to
/// 128 pixels, so that they are few; less where so many first samples could not be kept, or where
/// there would be too few tiles to keep all threads busy.
int tileSizeFor(Vec2<int> picture, const Sampler& sampler, int margin, int threads) {
  const auto isTooLarge = [&](int size) {
    const int side = size + 2 * margin;
    const std::size_t pixels = std::size_t(side) * std::size_t(side);
    const std::size_t samples = pixels * std::size_t(sampler.getNumFirst());
    const bool tooMany = samples * AdaptiveSampling::kBytesPerSample > kMostTileBytes;
    const int tiles = tilesAlong(picture.x(), size) * tilesAlong(picture.y(), size);
    return (isRefined(sampler) && tooMany) || tiles / kTilesPerThread < threads;
  };
  int blocks = std::clamp(2 * margin, 1, kMostBlocks);
  while (blocks > 1 && isTooLarge(kBlock * blocks)) --blocks;
  return kBlock * blocks;
}

}  // namespace

bool isRefined(const Sampler& sampler) { return sampler.getNumFirst() < sampler.getNumSamples(); }

void takeSamples(const SampledScene& scene, const Sampler& sampler, double tolerance,
                 const PixelRectangle& sources, const AdaptiveSampling::Receiver& receiver) {
  if (isRefined(sampler)) {
    return AdaptiveSampling(scene, sampler, tolerance, sources).finish(receiver);
  }
  SampleBatch batch(scene,
                    [&](const Sample& sample, const Vec3f& color) { receiver(sample, color, 1); });
  for (const Pixel at : pixelsInOrder(sources)) {
    for (int n = 0; n < sampler.getNumSamples(); ++n) {
      batch.add({at, sampler.getSamplePosition(at.i, at.j, n)});
    }
  }
  batch.flush();
}

SampledRenderer::SampledRenderer(const SampledScene& scene, const SamplingOptions& options,
                                 const RenderTargets& targets, Vec2<int> size, int threads)
    : scene_(scene),
      options_(options),
      targets_(targets),
      size_(size),
      sampler_(makeSampler(options)),
      filter_(makeFilter(options)),
      reach_(targets.color ? filter_->getSupportRadius() : 0),
      tileSize_(tileSizeFor(size, *sampler_, reach_ + int(isRefined(*sampler_)), threads)) {}

int SampledRenderer::tileCount() const {
  return tilesAlong(size_.x(), tileSize_) * tilesAlong(size_.y(), tileSize_);
}

PixelRectangle SampledRenderer::areaOf(int tile) const {
  const int columns = tilesAlong(size_.x(), tileSize_);
  const int left = tile % columns * tileSize_, bottom = tile / columns * tileSize_;
  return {left, bottom, std::min(left + tileSize_, size_.x()),
          std::min(bottom + tileSize_, size_.y())};
}

/// The same pixels, counted in the whole picture that the targets are a window of.
PixelRectangle SampledRenderer::inWhole(const PixelRectangle& area) const {
  const PictureWindow& window = targets_.window;
  return {area.left + window.left, area.bottom + window.bottom, area.right + window.left,
          area.top + window.bottom};
}

void SampledRenderer::renderTile(int tile) const {
  const PixelRectangle area = inWhole(areaOf(tile)), sources = area.grown(reach_);
  Film film(area, *filter_);
  if (targets_.samples) drawPixels(*targets_.samples, targets_.samplesZoom, area);
  const auto take = [&](const Sample& sample, const Vec3f& color, double share) {
    film.addSample(sample.at, sample.offset, color, share);
    if (targets_.samples && area.contains(sample.at)) {
      drawSample(*targets_.samples, targets_.samplesZoom, sample, color);
    }
  };
  takeSamples(scene_, *sampler_, options_.tolerance, sources, take);
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
