// Sends the rays of samples through the scene together.
#include "render/sample_batch.h"

void SampleBatch::flush() {
  Ray rays[Object3D::kBatchSize];
  Hit hits[Object3D::kBatchSize];
  bool found[Object3D::kBatchSize];
  Vec3f colors[Object3D::kBatchSize];
  for (int k = 0; k < count_; ++k) {
    const Sample& sample = samples_[k];
    rays[k] = scene_.camera.generateRay(imagePoint(sample.at.i + sample.offset.x(),
                                                   sample.at.j + sample.offset.y(), scene_.width,
                                                   scene_.height));
  }
  scene_.geometry.intersectBatch(rays, count_, scene_.camera.getTMin(), hits);
  for (int k = 0; k < count_; ++k) found[k] = hits[k].getT() < Hit().getT();
  scene_.tracer.shadeBatch(rays, hits, found, count_, colors);
  for (int k = 0; k < count_; ++k) receiver_(samples_[k], colors[k]);
  count_ = 0;
}
