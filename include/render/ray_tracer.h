// RayTracer: the colour of a ray. Reads like the assignment: ambient + lights + mirror +
// transmitted. A small value: every worker thread has a copy of its own.
#pragma once
#include <optional>
#include <vector>

#include "geometry/object3d.h"
#include "render/passage.h"
#include "render/ray_observer.h"
#include "render/render_options.h"
#include "scene/scene_parser.h"

class Media;

class RayTracer {
 public:
  /// The assignment's tracer: asks the scene's own group, with shadows and default options. The
  /// scene is not owned and must outlive the tracer.
  RayTracer(SceneParser* s, int max_bounces, float min_weight);
  /// Asks `geometry` (a compiled scene, or the scene's group) what a ray hits. Neither is owned.
  RayTracer(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options);

  /// A tracer that does the same, asks `geometry` and tells `observer` of it; nothing is reported
  /// where that is null. Neither is owned. Both may be one thread's own.
  RayTracer watchedBy(RayObserver* observer, const Object3D& geometry) const;

  /// The colour that arrives along `ray` from the nearest surface with t > tmin, or the background.
  /// `bounces` secondary rays came before this one (0 for an eye ray), `weight` is the part that
  /// its colour has in the pixel (1 for an eye ray), `indexOfRefraction` that of the medium it
  /// travels in. On return `hit` holds what was hit; it is best passed in fresh.
  Vec3f traceRay(Ray& ray, float tmin, int bounces, float weight, float indexOfRefraction,
                 Hit& hit) const;

  /// A ray as the recursion knows it.
  struct TracedRay {
    Ray ray;
    double tmin;
    float weight;             ///< the part that its colour has in the pixel
    float indexOfRefraction;  ///< of the medium it travels in
    Vec3f factor;  ///< of its colour in that of the ray it continues; white for an eye ray
  };

  /// traceRay for `count` <= Object3D::kBatchSize rays that belong together, all after the same
  /// number of bounces: colors[i] becomes the colour that arrives along rays[i], with the very bits
  /// that traceRay gives. The rays go through the scene together, and so do the shadow rays to each
  /// light, the mirrored rays and the refracted rays that begin where they end. `hits` has room for
  /// `count` hits, passed in fresh; there what was hit is stored.
  void traceBatch(const TracedRay* rays, int count, int bounces, Hit* hits, Vec3f* colors) const;

  /// Finds what `count` eye rays hit, and no colours. Surfaces that change nothing, as
  /// RenderOptions::nestedDielectrics has them, are passed over here as well.
  void intersectBatch(const TracedRay* rays, int count, Hit* hits) const;

 private:
  class PartBatch;

  /// One light as a point sees it.
  struct LightSample {
    Vec3d direction;  ///< unit, to the light
    Vec3f color;      ///< what arrives where nothing is in the way
    double distance;
    bool isInFront;  ///< n.l > 0
  };

  /// The second half of traceRay: the colour of a surface that is known to be hit. Where its
  /// material is a solid texture: the mean, by weight, of its parts' colours, each as if the
  /// surface were of that part alone. The weights of the rays that continue are multiplied by the
  /// part's, so that RenderOptions::minWeight ends rays from faint parts.
  Vec3f shade(const Ray& ray, const Hit& hit, const Passage& passage, int bounces, float weight,
              float indexOfRefraction) const;
  Vec3f shadeTexture(const Ray& ray, const Hit& hit, const Passage& passage, int bounces,
                     float weight, float indexOfRefraction) const;
  Vec3d ambient(const Hit& hit) const;
  Vec3d lights(const Ray& ray, const Hit& hit) const;
  /// `hit`, or a copy in `turned` whose normal faces the ray, where back sides are to be lit too.
  const Hit& litSide(const Ray& ray, const Hit& hit, std::optional<Hit>& turned) const;
  LightSample sampleLight(int index, const Hit& lit) const;
  Vec3d reflected(const Ray& ray, const Hit& lit, const LightSample& light,
                  const Vec3f& visible) const;
  /// The rays that continue `ray` where it hits; nothing where there is none, or none is wanted.
  std::optional<TracedRay> mirrored(const Ray& ray, const Hit& hit, const Passage& passage,
                                    int bounces, float weight, float indexOfRefraction) const;
  std::optional<TracedRay> refracted(const Ray& ray, const Hit& hit, const Passage& passage,
                                     int bounces, float weight) const;
  Vec3f mirrorFactor(const Ray& ray, const Hit& hit, const Passage& passage) const;
  Vec3f refractedFactor(const Ray& ray, const Hit& hit, const Passage& passage) const;
  Vec3d follow(std::optional<TracedRay> next, int bounces) const;
  /// `next`, told of as a ray that begins after `bounces` others.
  TracedRay begun(RayKind kind, const TracedRay& next, int bounces) const;

  /// Finds what lies on both sides of `hit`, the nearest with t < tmax. Where the surface is inside
  /// a medium of higher priority and changes nothing, moves `hit` on to the nearest behind it that
  /// does; where there is none, returns false and `hit` is as before anything was found.
  bool settle(const Ray& ray, double tmax, Hit& hit, Passage& passage) const;
  bool passThrough(const Media& media, double start, const Hit& hit, Passage& passage) const;
  bool wantsMedia(const Hit& hit) const;
  double reachOf(const Hit& hit) const;

  bool mayTrace(RayKind kind, const Vec3f& color, int bounces, float weight) const;
  Vec3f visibility(const Hit& hit, const LightSample& light) const;
  Vec3d told(ColorTerm term, const Vec3d& color) const;
  void reportLight(int index, const LightSample& light, const Vec3f& visible) const;
  template <class Event>
  void report(const Event& event) const {
    if (observer_) event(*observer_);
  }
  ShadowQuery shadowQuery(const Hit& hit, const LightSample& light) const;
  // Parts of traceBatch.
  void reportEyeRays(const TracedRay* rays, int count) const;
  std::vector<Passage> findBatch(const TracedRay* rays, int count, Hit* hits) const;
  void shadeBatch(const TracedRay* rays, const Hit* hits, const Passage* passages, int count,
                  int bounces, Vec3f* colors) const;
  std::vector<Vec3d> localTerms(const TracedRay* rays, const Hit* hits, int count) const;
  void addLight(int index, const TracedRay* rays, const Hit* hits, int count,
                std::vector<Vec3d>& sums) const;
  template <class Continue>
  void addContinued(const Hit* hits, int count, int bounces, std::vector<Vec3d>& sums,
                    const Continue& continued) const;

  Ray leavingRay(const Hit& hit, const Vec3d& direction) const;
  float epsilonAt(const Hit& hit) const;

  const SceneParser* scene_;         // not owned
  const Object3D* geometry_;         // not owned
  RenderOptions options_;            // epsilon is never `automatic` here
  bool hasGlass_;                    // some material of the scene is transparent
  RayObserver* observer_ = nullptr;  // not owned; null where nobody watches
};
