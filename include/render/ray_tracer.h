// RayTracer: the colour of a ray. Reads like the assignment: ambient + lights + mirror +
// transmitted. A small value: every worker thread has a copy of its own.
#pragma once
#include <optional>

#include "geometry/object3d.h"
#include "render/render_options.h"
#include "scene/scene_parser.h"

class RayTracer {
 public:
  /// The assignment's tracer: asks the scene's own group, with shadows and default options. The
  /// scene is not owned and must outlive the tracer.
  RayTracer(SceneParser* s, int max_bounces, float min_weight);
  /// Asks `geometry` (a compiled scene, or the scene's group) what a ray hits. Neither is owned.
  RayTracer(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options);

  /// The colour that arrives along `ray` from the nearest surface with t > tmin, or the background.
  /// `bounces` secondary rays came before this one (0 for an eye ray), `weight` is the part that
  /// its colour has in the pixel (1 for an eye ray), `indexOfRefraction` that of the medium it
  /// travels in. On return `hit` holds what was hit; it is best passed in fresh.
  Vec3f traceRay(Ray& ray, float tmin, int bounces, float weight, float indexOfRefraction,
                 Hit& hit) const;

  /// The second half of traceRay: the colour of a surface that is known to be hit.
  Vec3f shade(const Ray& ray, const Hit& hit, int bounces, float weight,
              float indexOfRefraction) const;

  /// shade for `count` <= Object3D::kBatchSize eye rays that were intersected together: colors[i]
  /// becomes shade(rays[i], hits[i], 0, 1, 1) where found[i], else the background. The shadow rays
  /// to each light go through the scene together.
  void shadeBatch(const Ray* rays, const Hit* hits, const bool* found, int count,
                  Vec3f* colors) const;

 private:
  /// One light as a point sees it.
  struct LightSample {
    Vec3d direction;  ///< unit, to the light
    Vec3f color;      ///< what arrives where nothing is in the way
    double distance;
    bool isInFront;  ///< n.l > 0
  };

  Vec3d ambient(const Hit& hit) const;
  Vec3d lights(const Ray& ray, const Hit& hit) const;
  Vec3f sumOfTerms(const Ray& ray, const Hit& hit, const Vec3d& fromLights, int bounces,
                   float weight, float indexOfRefraction) const;
  /// `hit`, or a copy in `turned` whose normal faces the ray, where back sides are to be lit too.
  const Hit& litSide(const Ray& ray, const Hit& hit, std::optional<Hit>& turned) const;
  LightSample sampleLight(int index, const Hit& lit) const;
  Vec3d reflected(const Ray& ray, const Hit& lit, const LightSample& light,
                  const Vec3f& visible) const;
  Vec3d mirror(const Ray& ray, const Hit& hit, int bounces, float weight,
               float indexOfRefraction) const;
  Vec3d transmitted(const Ray& ray, const Hit& hit, int bounces, float weight) const;

  bool mayTrace(const Vec3f& color, int bounces, float weight) const;
  Vec3f visibility(const Hit& hit, const LightSample& light) const;
  ShadowQuery shadowQuery(const Hit& hit, const LightSample& light) const;
  void addLight(int index, const Ray* rays, const Hit* hits, const bool* found, int count,
                Vec3d* sums) const;
  Ray leavingRay(const Hit& hit, const Vec3d& direction) const;
  float epsilonAt(const Hit& hit) const;

  const SceneParser* scene_;  // not owned
  const Object3D* geometry_;  // not owned
  RenderOptions options_;     // epsilon is never `automatic` here
};
