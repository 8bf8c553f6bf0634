// Sends the rays of samples through the scene together.
#include "render/sample_batch.h"

void SampleBatch::flush() {
  RayBatch rays(static_cast<std::size_t>(count_));
  Hit hits[kBatchSize];
  Vec3f colors[kBatchSize];
  for (int k = 0; k < count_; ++k) {
    const Sample& sample = samples_[k];
    const Vec2d point = imagePoint(sample.at.i + sample.offset.x(), sample.at.j + sample.offset.y(),
                                   scene_.width, scene_.height);
    TracedRay& ray = rays[std::size_t(k)];
    ray.ray = scene_.camera.generateRay(point);
    ray.tmin = scene_.camera.getTMin();
  }
  scene_.tracer.trace(rays, 0, hits, colors);
  for (int k = 0; k < count_; ++k) receiver_(samples_[k], colors[k]);
  count_ = 0;
}
