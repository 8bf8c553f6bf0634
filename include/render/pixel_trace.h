// One pixel of a picture, looked into: its rays are traced once more, and observers keep what
// becomes of them, such as RayLines, which draws them in space.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "render/watched_tracer.h"

/// Tells each of the observers, one after the other, what becomes of the ray through the centre of
/// pixel (window.left, window.bottom); width and height of `window` are given, above 0. Returns the
/// pixel's colour, in which other samples may have a share: to the last bit that of a whole
/// picture, unclamped. Traces on threads of its own, for as much stack as the bounces need.
Vec3f tracePixel(const RayTracer& tracer, const PictureWindow& window,
                 const std::vector<RayObserver*>& observers);

/// An observer that keeps rays as lines in space, for a modeller or mesh viewer.
class RayLines : public RayObserver {
 public:
  /// Of rays traced as by `tracer`, which is not owned. One that meets nothing is drawn
  /// `escapeLength` > 0 long.
  RayLines(const RayTracer& tracer, double escapeLength)
      : tracer_(tracer), escapeLength_(escapeLength) {}

  void rayBegins(RayKind kind, int bounces, const TracedRay& ray) override;
  void rayMeets(const Hit* hit, const Interface&) override;
  void lightAnswers(int light, const LightSample& sample, const ShadowQuery* shadowRay,
                    const Vec3f& visible, const Vec3d&) override;

  /// All lines as a Wavefront OBJ file in the scene's units, at least one object for each kind of
  /// ray that there is, named by the kind: eye, mirror, refracted, and the shadow rays that are
  /// lit, tinted and blocked. Each ray is an `l` of two vertices, which have the kind's colour
  /// (`v x y z r g b`). Lines with an end that is not finite are left out.
  std::string obj() const;

 private:
  enum Kind { eye, mirror, refracted, lit, tinted, blocked };
  static constexpr int kKinds = 6;
  struct Line {
    Vec3d from, to;
  };

  void add(Kind kind, const Ray& ray, double from, double to);

  const RayTracer& tracer_;
  const double escapeLength_;
  Ray ray_;  // the one that began last
  Kind kind_ = eye;
  std::array<std::vector<Line>, kKinds> lines_;
};
