// SampleBatch: collects samples and sends their rays through the scene together.
#pragma once
#include <functional>

#include "camera/camera.h"
#include "math/vec2.h"
#include "render/image_plane.h"
#include "render/wave_tracer.h"

/// A ray's place: `offset` from the lower left corner of pixel `at`.
struct Sample {
  Pixel at;
  Vec2d offset;
};

/// What a sample's colour comes from. Nothing is owned.
struct SampledScene {
  const Camera& camera;
  const WaveTracer& tracer;
  int width, height;  ///< of the picture, in pixels
};

class SampleBatch {
 public:
  /// Takes a sample and the colour that arrives there.
  using Receiver = std::function<void(const Sample& sample, const Vec3f& color)>;

  SampleBatch(const SampledScene& scene, Receiver receiver)
      : scene_(scene), receiver_(std::move(receiver)) {}

  /// Samples reach the receiver in the order in which they were added, each at the latest with the
  /// next flush().
  void add(const Sample& sample) {
    samples_[count_++] = sample;
    if (count_ == kBatchSize) flush();
  }
  void flush();

 private:
  const SampledScene& scene_;
  const Receiver receiver_;
  Sample samples_[kBatchSize];
  int count_ = 0;
};
