// The rival's Whitted shading, in float: mesh by Embree's single-ray calls, floor and ball by hand.
#pragma once
#include <embree3/rtcore.h>

#include "math/vec3.h"
#include "program_scene.h"

namespace bench {

class PlainTracer {
 public:
  /// `scene` holds the mesh alone; not owned.
  explicit PlainTracer(RTCScene scene) : scene_(scene) {}

  /// The colour along a ray with unit direction, from t > tmin on; `bounces` and `weight` as in
  /// the assignment.
  Vec3f trace(const Vec3f& origin, const Vec3f& direction, float tmin, int bounces,
              float weight) const;

 private:
  struct Found {
    float t;
    const Surface* surface = nullptr;
    Vec3f normal;
  };
  bool nearest(const Vec3f& origin, const Vec3f& direction, float tmin, Found& found) const;
  bool blocked(const Vec3f& origin, const Vec3f& direction, float tmax) const;
  Vec3f lit(const Vec3f& point, const Vec3f& direction, const Found& found) const;
  Vec3f mirror(const Vec3f& point, const Vec3f& direction, const Found& found, int bounces,
               float weight) const;
  Vec3f refracted(const Vec3f& point, const Vec3f& direction, const Found& found, int bounces,
                  float weight) const;

  RTCScene scene_;
};

}  // namespace bench
