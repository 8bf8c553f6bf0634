// RayTracer: the colour of a ray. Reads like the assignment: ambient + lights + mirror +
// transmitted. A small value: every worker thread has a copy of its own.
#pragma once
#include <vector>

#include "geometry/batch_geometry.h"
#include "geometry/object3d.h"
#include "render/passage.h"
#include "render/ray_batch.h"
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

  /// traceRay for at most kBatchSize rays that belong together, all after the same
  /// number of bounces: colors[i] becomes the colour that arrives along ray i, with the very bits
  /// that traceRay gives. The rays go through the scene together, and so do the shadow rays to each
  /// light, the mirrored rays and the refracted rays that begin where they end. `hits` has as many
  /// hits as there are rays, passed in fresh; there what was hit is stored.
  void traceBatch(const RayBatch& batch, int bounces, Hit* hits, Vec3f* colors) const;

  /// Finds what eye rays hit, and no colours. Surfaces that change nothing, as
  /// RenderOptions::nestedDielectrics has them, are passed over here as well.
  void intersectBatch(const RayBatch& batch, Hit* hits) const;

 private:
  class PartBatch;
  class Continued;

  /// One light as a point sees it.
  struct LightSample {
    Vec3d direction;  ///< unit, to the light
    Vec3f color;      ///< what arrives where nothing is in the way
    double distance = 0;
    bool isInFront = false;  ///< n.l > 0
    LightSample() {}         // as that of Hit
  };

  /// The second half of traceRay: the colour of a surface that is known to be hit. Where its
  /// material is a solid texture: the mean, by weight, of its parts' colours, each as if the
  /// surface were of that part alone. The weights of the rays that continue are multiplied by the
  /// part's, so that RenderOptions::minWeight ends rays from faint parts.
  Vec3f shade(const Ray& ray, const Hit& hit, const Passage& passage, int bounces, float weight,
              float indexOfRefraction) const;
  Vec3f shadeTexture(const Ray& ray, const Hit& hit, const Passage& passage, int bounces,
                     float weight, float indexOfRefraction) const;
  Vec3d ambient(const Hit& hit) const {
    return Vec3d(scene_->getAmbientLight()) * Vec3d(hit.getMaterial()->getDiffuseColor());
  }
  Vec3d lights(const Ray& ray, const Hit& hit) const;
  /// `hit`, or a copy in `turned` whose normal faces the ray, where back sides are to be lit too.
  const Hit& litSide(const Ray& ray, const Hit& hit, Hit& turned) const {
    return options_.shadeBack ? sideTowards(ray, hit, turned) : hit;
  }
  static const Hit& sideTowards(const Ray& ray, const Hit& hit, Hit& turned);
  void sampleLight(int index, const Hit& lit, LightSample& light) const;
  Vec3d reflected(const Ray& ray, const Hit& lit, const LightSample& light,
                  const Vec3f& visible) const;
  /// The rays that continue `ray` where it hits, made in place: copying a ray that has just been
  /// written waits for its stores. False where there is none, or none is wanted.
  bool mirrored(const Ray& ray, const Hit& hit, const Passage& passage, int bounces, float weight,
                float indexOfRefraction, Ray& next, RayShare& share) const;
  bool refracted(const Ray& ray, const Hit& hit, const Passage& passage, int bounces, float weight,
                 Ray& next, RayShare& share) const;
  Vec3f mirrorFactor(const Ray& ray, const Hit& hit, const Passage& passage) const;
  Vec3f refractedFactor(const Ray& ray, const Hit& hit, const Passage& passage) const;
  Vec3d follow(Ray& next, double tmin, const RayShare& share, int bounces) const;
  /// Tells of a ray that begins after `bounces` others.
  void reportBegin(RayKind kind, const Ray& ray, double tmin, const RayShare& share,
                   int bounces) const;

  /// Finds what lies on both sides of `hit`, the nearest with t < tmax. Where the surface is inside
  /// a medium of higher priority and changes nothing, moves `hit` on to the nearest behind it that
  /// does; where there is none, returns false and `hit` is as before anything was found.
  bool settle(const Ray& ray, double tmax, Hit& hit, Passage& passage) const;
  bool passThrough(const Media& media, double start, const Hit& hit, Passage& passage) const;
  bool wantsMedia(const Hit& hit) const;
  double reachOf(const Hit& hit) const;

  bool mayTrace(RayKind kind, int bounces, float weight) const;
  Vec3f visibility(const Hit& hit, const LightSample& light) const;
  Vec3d told(ColorTerm term, const Vec3d& color) const;
  void reportLight(int index, const Hit& hit, const LightSample& light,
                   const Vec3f& visible) const {
    if (observer_) tellLight(index, hit, light, visible);
  }
  void tellLight(int index, const Hit& hit, const LightSample& light, const Vec3f& visible) const;
  template <class Event>
  void report(const Event& event) const {
    if (observer_) event(*observer_);
  }
  void setShadowQuery(const Hit& hit, const LightSample& light, ShadowQuery& way) const {
    setLeaving(hit, light.direction, way.ray);
    way.tmin = double(epsilonAt(hit));
    way.tmax = light.distance;
  }
  // Parts of traceBatch. The passages are none where every one is plain.
  void reportEyeRays(const RayBatch& batch) const;
  std::vector<Passage> findBatch(const RayBatch& batch, Hit* hits) const;
  void shadeBatch(const RayBatch& batch, const Hit* hits, const std::vector<Passage>& passages,
                  int bounces, Vec3f* colors) const;
  std::vector<Vec3d> localTerms(const std::vector<Ray>& rays, const Hit* hits) const;
  void addLight(int index, const std::vector<Ray>& rays, const Hit* hits,
                std::vector<Vec3d>& sums) const;
  void addContinued(Continued& next, int bounces, std::vector<Vec3d>& sums) const;

  void setLeaving(const Hit& hit, const Vec3d& direction, Ray& ray) const {
    ray.set(hit.getIntersectionPoint(), direction);
    if (options_.epsilon.kind == Epsilon::Kind::adaptive) {
      ray.setSource(hit.getObject(), hit.getFace());
    }
  }
  float epsilonAt(const Hit& hit) const {
    if (options_.epsilon.kind == Epsilon::Kind::fixed) return float(options_.epsilon.value);
    return float(hit.getMagnitude() *
                 0x1p-31);  // 4.7e-10: far above rounding, below the promised 1e-9
  }

  const SceneParser* scene_;         // not owned
  const Object3D* geometry_;         // not owned
  RenderOptions options_;            // epsilon is never `automatic` here
  bool hasTextures_;                 // some material of the scene is a solid texture
  bool tracksMedia_;                 // some passage may be other than plain
  RayObserver* observer_ = nullptr;  // not owned; null where nobody watches
};
