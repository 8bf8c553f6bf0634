// RayTracer::shadeBatch: the same sum of terms, with the shadow rays of eye rays sent in batches.
#include "render/ray_tracer.h"

void RayTracer::shadeBatch(const Ray* rays, const Hit* hits, const bool* found, int count,
                           Vec3f* colors) const {
  const bool plainShadows = options_.shadows && !options_.transparentShadows;
  Vec3d sums[Object3D::kBatchSize];
  for (int light = 0; plainShadows && light < scene_->getNumLights(); ++light) {
    addLight(light, rays, hits, found, count, sums);
  }
  for (int i = 0; i < count; ++i) {
    if (!found[i]) {
      colors[i] = scene_->getBackgroundColor();
    } else {
      const Vec3d fromLights = plainShadows ? sums[i] : lights(rays[i], hits[i]);
      colors[i] = sumOfTerms(rays[i], hits[i], fromLights, 0, 1, 1);
    }
  }
}

/// Adds to each sum what light `index` contributes there.
void RayTracer::addLight(int index, const Ray* rays, const Hit* hits, const bool* found, int count,
                         Vec3d* sums) const {
  int places[Object3D::kBatchSize];
  LightSample samples[Object3D::kBatchSize];
  ShadowQuery ways[Object3D::kBatchSize];
  bool blocked[Object3D::kBatchSize];
  int asked = 0;
  for (int i = 0; i < count; ++i) {
    if (!found[i]) continue;
    std::optional<Hit> turned;
    samples[asked] = sampleLight(index, litSide(rays[i], hits[i], turned));
    if (!samples[asked].isInFront) continue;
    ways[asked] = shadowQuery(hits[i], samples[asked]);
    places[asked++] = i;
  }
  geometry_->occludedBatch(ways, asked, blocked);
  for (int k = 0; k < asked; ++k) {
    if (blocked[k]) continue;
    const int i = places[k];
    std::optional<Hit> turned;
    const Hit& lit = litSide(rays[i], hits[i], turned);
    sums[i] += reflected(rays[i], lit, samples[k], Vec3f(1, 1, 1));
  }
}
