// RayTracer: the colour of a ray, as the assignment sums it up: ambient + lights + mirror +
// transmitted. It walks the tree of rays depth first; WaveTracer walks the same tree breadth first.
// Const and without state while rays are traced: any number of threads may use one.
// Source: Whitted, "An Improved Illumination Model for Shaded Display", 1980.
#pragma once
#include "render/interfaces.h"
#include "render/shader.h"

class RayTracer {
 public:
  /// The assignment's tracer: asks the scene's own group, with shadows and default options. The
  /// scene is not owned and must outlive the tracer.
  RayTracer(SceneParser* s, int max_bounces, float min_weight);
  /// Asks `geometry` (a compiled scene, or the scene's group) what a ray hits. Neither is owned.
  RayTracer(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options);
  virtual ~RayTracer() = default;
  RayTracer(const RayTracer&) = delete;
  RayTracer& operator=(const RayTracer&) = delete;

  /// The colour that arrives along `ray` from the nearest surface with t > tmin, or the background.
  /// `bounces` secondary rays came before this one (0 for an eye ray), `weight` is the share that
  /// its colour has in the pixel (1 for an eye ray), `indexOfRefraction` that of the medium it
  /// travels in. The direction is a unit vector. On return `hit` holds what was hit; it is best
  /// passed in fresh.
  virtual Vec3f traceRay(Ray& ray, float tmin, int bounces, float weight, float indexOfRefraction,
                         Hit& hit) const;

  const SceneParser& scene() const { return *scene_; }
  const Object3D& geometry() const { return *geometry_; }
  const Shader& shader() const { return shader_; }
  const Interfaces& interfaces() const { return interfaces_; }
  const RenderOptions& options() const { return shader_.options(); }

  /// What of a light's colour arrives at the surface: 0..1 in each component.
  Vec3f visibility(const Surface& s, const LightSample& light) const;

 protected:  // each step on its own, so that a WatchedTracer can tell of it
  virtual bool meet(const Ray& ray, double tmin, float index, Hit& hit, Interface& interface) const;
  virtual Vec3f shadeComponent(const Surface& s, double share) const;
  virtual Vec3d ambient(const Surface& s) const { return shader_.ambient(s); }
  virtual Vec3d lights(const Surface& s) const;
  virtual Vec3d light(int index, const Surface& s) const;
  /// The mirrored, or the refracted, term.
  virtual Vec3d branch(RayKind kind, const Surface& s) const;

  /// What `next`, which continues at `s`, brings there.
  Vec3d follow(const Surface& s, TracedRay& next) const;

 private:
  Vec3f shade(const Surface& s) const;
  Vec3f mixture(const SolidTexture& texture, const Surface& s) const;

  const SceneParser* scene_;  // not owned
  const Object3D* geometry_;  // not owned
  const Shader shader_;
  const Interfaces interfaces_;
};
