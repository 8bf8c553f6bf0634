// RayTracer: the recursion. Every formula is the Shader's; here is what is asked of the scene, and
// in which order the terms are added.
//
//   traceRay    the background, or what shade makes of the nearest surface
//   shade       ambient + lights + mirrored + refracted; of a texture the mean of its components
//   light       does the surface face it, does it arrive, what comes back
//   branch      where the Shader sends a ray on, mirrored or refracted: traceRay, one bounce deeper
// The Shader says where it ends, so the recursion is as deep as RenderOptions::maxBounces at most.
#include "render/ray_tracer.h"

#include "render/transmittance.h"
#include "shading/solid_texture.h"

namespace {

RenderOptions optionsOf(int maxBounces, float minWeight) {
  RenderOptions options;
  options.maxBounces = maxBounces;
  options.minWeight = minWeight;
  return options;
}

}  // namespace

RayTracer::RayTracer(SceneParser* s, int max_bounces, float min_weight)
    : RayTracer(*s, *s->getGroup(), optionsOf(max_bounces, min_weight)) {}

RayTracer::RayTracer(const SceneParser& scene, const Object3D& geometry,
                     const RenderOptions& options)
    : scene_(&scene),
      geometry_(&geometry),
      shader_(scene, options),
      interfaces_(scene, geometry, shader_) {}

Vec3f RayTracer::traceRay(Ray& ray, float tmin, int bounces, float weight, float indexOfRefraction,
                          Hit& hit) const {
  Interface interface;
  if (!meet(ray, tmin, indexOfRefraction, hit, interface)) {
    return scene_->getBackground().colorAt(ray.getDirection());
  }
  return shade({ray, hit, interface, bounces, weight, indexOfRefraction});
}

bool RayTracer::meet(const Ray& ray, double tmin, float index, Hit& hit,
                     Interface& interface) const {
  return interfaces_.intersect(ray, tmin, index, hit, interface);
}

/// Summed in double, in this order, and rounded once: 0.02 + 0.9 * 0.2 is 0.2 again.
Vec3f RayTracer::shade(const Surface& s) const {
  if (const SolidTexture* texture = s.hit.getMaterial()->asTexture()) return mixture(*texture, s);
  Vec3d color = ambient(s);
  color += lights(s);
  color += branch(RayKind::mirror, s);
  color += branch(RayKind::refracted, s);
  return Vec3f(color * Vec3d(s.interface.tint));
}

/// The mean of a texture's components, each shaded as if the surface were of it alone. Its share
/// counts in the weights of rays that continue, so that they end where a component is faint.
Vec3f RayTracer::mixture(const SolidTexture& texture, const Surface& s) const {
  Vec3d sum;
  for (const WeightedMaterial& each : texture.materialsAt(s.hit.getIntersectionPoint())) {
    const Hit hit = s.hit.withSurface(each.material, s.hit.getNormal());
    const float weight = s.weight * float(each.weight);
    const Surface component = {s.ray, hit, s.interface, s.bounces, weight, s.indexOfRefraction};
    sum += each.weight * Vec3d(shadeComponent(component, each.weight));
  }
  return Vec3f(sum);
}

Vec3f RayTracer::shadeComponent(const Surface& s, double /*share*/) const { return shade(s); }

Vec3d RayTracer::lights(const Surface& s) const {
  Vec3d sum;
  for (int i = 0; i < scene_->getNumLights(); ++i) sum += light(i, s);
  return sum;
}

/// A light behind the surface is not asked for further.
Vec3d RayTracer::light(int index, const Surface& s) const {
  LightSample light;
  shader_.sampleLight(index, s, light);
  return light.isInFront ? shader_.reflected(s, light, visibility(s, light)) : Vec3d();
}

/// All of it without shadows; what transparent objects let through where they tint; else all or
/// nothing, as something lies between or not.
Vec3f RayTracer::visibility(const Surface& s, const LightSample& light) const {
  if (!shader_.options().shadows) return {1, 1, 1};
  ShadowQuery query;
  shader_.setShadowQuery(s, light, query);
  if (shader_.options().transparentShadows) {
    return transmittance(*geometry_, query.ray, query.tmin, query.tmax);
  }
  return geometry_->occluded(query.ray, query.tmin, query.tmax) ? Vec3f() : Vec3f(1, 1, 1);
}

Vec3d RayTracer::branch(RayKind kind, const Surface& s) const {
  TracedRay next;
  return shader_.continued(kind, s, next) == Outcome::follows ? follow(s, next) : Vec3d();
}

/// The colour that arrives along the continued ray, times the factor that the surface takes of it.
Vec3d RayTracer::follow(const Surface& s, TracedRay& next) const {
  Hit hit;
  const Vec3f color =
      traceRay(next.ray, float(next.tmin), s.bounces + 1, next.weight, next.indexOfRefraction, hit);
  return Vec3d(next.factor) * Vec3d(color);
}
