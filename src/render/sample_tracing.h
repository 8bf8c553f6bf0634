// Traces the rays of samples and hands over their colours, as many for each pixel as the sampler
// has, or fewer where colours agree.
#pragma once
#include <functional>

#include "camera/camera.h"
#include "math/vec3.h"
#include "render/image_plane.h"
#include "render/sampler.h"
#include "render/wave_tracer.h"

/// What a sample's colour comes from. Nothing is owned.
struct SampledScene {
  const Camera& camera;
  const WaveTracer& tracer;
  int width, height;  ///< of the whole picture, in pixels

  /// The ray that the camera sends through a sample's place.
  Ray rayOf(const Sample& sample) const {
    return camera.generateRay(imagePoint(sample.at.i + sample.offset.x(),
                                         sample.at.j + sample.offset.y(), width, height));
  }
};

/// The least and the greatest of some colours, each component on its own, clamped to 0..1.
class ColorRange {
 public:
  /// A component that is NaN counts as 0, as which it is shown.
  void add(const Vec3f& color);
  void add(const ColorRange& other);
  /// The largest difference in a component; below 0 before anything was added.
  double width() const;

 private:
  Vec3f low_{1, 1, 1}, high_{-1, -1, -1};
};

/// Takes a sample, its colour, and the factor >= 1 that makes up for its pixel's having fewer
/// samples than another may have.
using SampleReceiver = std::function<void(const Sample& sample, const Vec3f& color, double share)>;

/// Takes the samples of the pixels in `sources`, which may lie outside of the picture, and hands
/// them to `receiver`: pixels as in pixelsInOrder, the samples of each by number. Where the sampler
/// is adaptive, pixels whose colours differ by more than `tolerance` from each other, or from those
/// of their neighbours, get more of them; then the first samples of the pixels around `sources` are
/// traced too.
void takeSamples(const SampledScene& scene, const Sampler& sampler, double tolerance,
                 const PixelRectangle& sources, const SampleReceiver& receiver);

/// About how many bytes takeSamples needs for each of the first samples, where the sampler is
/// adaptive.
inline constexpr std::size_t kBytesPerSample = 32;
