// RayTracer: ambient + lights + mirror + transmitted.
// Source: Whitted, "An Improved Illumination Model for Shaded Display", 1980.
#include "render/ray_tracer.h"

#include "render/optics.h"
#include "render/transmittance.h"

namespace {

RenderOptions optionsOf(int maxBounces, float minWeight) {
  RenderOptions options;
  options.maxBounces = maxBounces;
  options.minWeight = minWeight;
  return options;
}

/// The assignment's constant suits scenes of the assignment's size.
Epsilon resolved(const Epsilon& epsilon, const SceneParser& scene) {
  if (epsilon.kind != Epsilon::Kind::automatic) return epsilon;
  const double span = scene.getSpan();
  const bool usual = span == 0 || (span >= 1 && span <= 1000);
  return {usual ? Epsilon::Kind::fixed : Epsilon::Kind::adaptive, Epsilon::kCourse};
}

}  // namespace

RayTracer::RayTracer(SceneParser* s, int max_bounces, float min_weight)
    : RayTracer(*s, *s->getGroup(), optionsOf(max_bounces, min_weight)) {}

RayTracer::RayTracer(const SceneParser& scene, const Object3D& geometry,
                     const RenderOptions& options)
    : scene_(&scene), geometry_(&geometry), options_(options) {
  options_.epsilon = resolved(options.epsilon, scene);
}

Vec3f RayTracer::traceRay(Ray& ray, float tmin, int bounces, float weight, float indexOfRefraction,
                          Hit& hit) const {
  if (!geometry_->intersect(ray, hit, tmin)) return scene_->getBackgroundColor();
  return shade(ray, hit, bounces, weight, indexOfRefraction);
}

Vec3f RayTracer::shade(const Ray& ray, const Hit& hit, int bounces, float weight,
                       float indexOfRefraction) const {
  // Summed in double and rounded once: 0.02 + 0.9 * 0.2 is 0.2 again.
  return Vec3f(ambient(hit) + lights(ray, hit) +
               mirror(ray, hit, bounces, weight, indexOfRefraction) +
               transmitted(ray, hit, bounces, weight));
}

Vec3d RayTracer::ambient(const Hit& hit) const {
  return Vec3d(scene_->getAmbientLight()) * Vec3d(hit.getMaterial()->getDiffuseColor());
}

Vec3d RayTracer::lights(const Ray& ray, const Hit& hit) const {
  Hit lit = hit;
  if (options_.shadeBack && dot(hit.getNormal(), ray.getDirection()) > 0) {
    lit.set(hit.getT(), hit.getMaterial(), -hit.getNormal(), ray);
  }
  Vec3d sum;
  for (int i = 0; i < scene_->getNumLights(); ++i) {
    Vec3d dirToLight;
    Vec3f color;
    double distance;
    scene_->getLight(i)->getIllumination(lit.getIntersectionPoint(), dirToLight, color, distance);
    if (!(dot(lit.getNormal(), dirToLight) > 0)) continue;
    const Vec3f visible = visibility(hit, dirToLight, distance);
    if (visible == Vec3f()) continue;
    sum += hit.getMaterial()->Shade(ray, lit, Vec3f(dirToLight), color * visible);
  }
  return sum;
}

Vec3f RayTracer::visibility(const Hit& hit, const Vec3d& dirToLight, double distance) const {
  if (!options_.shadows) return {1, 1, 1};
  const Ray ray = leavingRay(hit, dirToLight);
  const double epsilon = epsilonAt(hit);
  if (options_.transparentShadows) return transmittance(*geometry_, ray, epsilon, distance);
  return geometry_->occluded(ray, epsilon, distance) ? Vec3f() : Vec3f(1, 1, 1);
}

Vec3d RayTracer::mirror(const Ray& ray, const Hit& hit, int bounces, float weight,
                        float indexOfRefraction) const {
  const Vec3f color = hit.getMaterial()->getReflectiveColor();
  const float mirrorWeight = weight * length(color);
  if (!mayTrace(color, bounces, mirrorWeight)) return Vec3d();
  Ray mirrored = leavingRay(hit, mirrorDirection(hit.getNormal(), ray.getDirection()));
  Hit next;
  return Vec3d(color) *
         traceRay(mirrored, epsilonAt(hit), bounces + 1, mirrorWeight, indexOfRefraction, next);
}

Vec3d RayTracer::transmitted(const Ray& ray, const Hit& hit, int bounces, float weight) const {
  const Vec3f color = hit.getMaterial()->getTransparentColor();
  const float refractedWeight = weight * length(color);
  if (!mayTrace(color, bounces, refractedWeight)) return Vec3d();
  const bool outside = dot(hit.getNormal(), ray.getDirection()) < 0;
  const float inner = hit.getMaterial()->getIndexOfRefraction();
  const float before = outside ? 1 : inner, behind = outside ? inner : 1;
  const Vec3d normal = outside ? hit.getNormal() : -hit.getNormal();
  Vec3d direction;
  if (!transmittedDirection(normal, ray.getDirection(), before, behind, direction)) return Vec3d();
  Ray refracted = leavingRay(hit, direction);
  Hit next;
  return Vec3d(color) *
         traceRay(refracted, epsilonAt(hit), bounces + 1, refractedWeight, behind, next);
}

/// The one place where recursion stops.
bool RayTracer::mayTrace(const Vec3f& color, int bounces, float weight) const {
  return anyPositive(color) && bounces < options_.maxBounces && weight >= options_.minWeight;
}

Ray RayTracer::leavingRay(const Hit& hit, const Vec3d& direction) const {
  Ray ray(hit.getIntersectionPoint(), direction);
  if (options_.epsilon.kind == Epsilon::Kind::adaptive) {
    ray.setSource(hit.getObject(), hit.getPart());
  }
  return ray;
}

float RayTracer::epsilonAt(const Hit& hit) const {
  if (options_.epsilon.kind == Epsilon::Kind::fixed) return float(options_.epsilon.value);
  return float(hit.getMagnitude() *
               0x1p-31);  // 4.7e-10: far above rounding, below the promised 1e-9
}
