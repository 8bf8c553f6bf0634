// Traces the rays of samples and hands over their colours, as many for each pixel as the sampler
// has, or fewer where colours agree.
#pragma once
#include <algorithm>
#include <functional>

#include "camera/camera.h"
#include "math/vec3.h"
#include "render/image_plane.h"
#include "render/sampler.h"
#include "render/wave_tables.h"
#include "render/wave_tracer.h"

/// A camera and the whole picture that it takes.
class PictureView {
 public:
  /// The camera is not owned. The picture is `pictureWidth` x `pictureHeight` pixels, at least one.
  PictureView(const Camera& ofCamera, const PixelPlaces& places, int pictureWidth,
              int pictureHeight);

  const Camera& camera;
  const int width, height;

  /// The point of a sample on the camera's image plane.
  Vec2d pointOf(const Sample& sample) const {
    const Vec2d place = sample.place();
    return {eye_ray::coordinate(place.x(), middle_.x(), unit_.x()),
            eye_ray::coordinate(place.y(), middle_.y(), unit_.y())};
  }
  /// What of pointOf the samples of a picture have in common.
  const Vec2d& middle() const { return middle_; }
  const Vec2d& unit() const { return unit_; }

 private:
  Vec2d middle_, unit_;  // see eye_ray::coordinate
};

/// The eye rays of some samples, at most RayTable::kMost, and what they have met. All memory is
/// that of the tracer's arena.
struct TracedSamples {
  WaveRays rays;
  HitTable hits;
  Vec3f* colors;  ///< where wanted

  TracedSamples(const PictureView& view, WaveTracer& tracer, const Sample* samples, int count,
                bool wantsColors);
  Hit hitOf(int row) const { return hits.hitOf(row, rays.tmax[row]); }
};

/// The colour of one sample, its rays traced one after the other: for those who watch the tracer.
Vec3f traceAlone(const PictureView& view, const RayTracer& tracer, const Sample& sample);

/// What samples come of. Nothing is owned.
struct SampleSource {
  const PictureView& view;
  WaveTracer& tracer;
  const Sampler& sampler;
};

/// The least and the greatest of some colours, each component on its own, clamped to 0..1.
class ColorRange {
 public:
  /// A component that is NaN counts as 0, as which it is shown.
  void add(const Vec3f& color) {
    const Vec3f shown = least(largest(Vec3f(), color), Vec3f(1, 1, 1));
    low_ = least(low_, shown);
    high_ = largest(high_, shown);
  }
  void add(const ColorRange& other) {
    low_ = least(low_, other.low_);
    high_ = largest(high_, other.high_);
  }
  /// The largest difference in a component; below 0 before anything was added.
  double width() const {
    const Vec3d widths = Vec3d(high_) - Vec3d(low_);
    return std::max({widths.r(), widths.g(), widths.b()});
  }

 private:
  Vec3f low_{1, 1, 1}, high_{-1, -1, -1};
};

/// Takes a sample, its colour, and the factor >= 1 that makes up for its pixel's having fewer
/// samples than another may have.
using SampleReceiver = std::function<void(const Sample& sample, const Vec3f& color, double share)>;

/// Takes the samples of the pixels in `area`, which may lie outside of the picture, and hands them
/// to `receiver`: pixels as in pixelsInOrder, the samples of each by number. Where the sampler is
/// adaptive, pixels in which, or around which, colours differ by more than the tolerance get more
/// of them; then the first samples of the pixels next to `area` are traced too.
void takeSamples(const SampleSource& source, const PixelRectangle& area,
                 const SampleReceiver& receiver);

/// About how many bytes takeSamples needs for each of the first samples, where the sampler is
/// adaptive.
inline constexpr std::size_t kBytesPerSample = 32;
