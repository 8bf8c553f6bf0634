// RayTracer: ambient + lights + mirror + transmitted.
// Source: Whitted, "An Improved Illumination Model for Shaded Display", 1980.
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

/// The assignment's constant suits scenes of the assignment's size.
Epsilon resolved(const Epsilon& epsilon, const SceneParser& scene) {
  if (epsilon.kind != Epsilon::Kind::automatic) return epsilon;
  const double span = scene.getSpan();
  const bool usual = span == 0 || (span >= 1 && span <= 1000);
  return {usual ? Epsilon::Kind::fixed : Epsilon::Kind::adaptive, Epsilon::kCourse};
}

bool hasTransparentMaterial(const SceneParser& scene) {
  for (int i = 0; i < scene.getNumMaterials(); ++i) {
    if (anyPositive(scene.getMaterial(i)->getTransparentColor())) return true;
  }
  return false;
}

}  // namespace

RayTracer::RayTracer(SceneParser* s, int max_bounces, float min_weight)
    : RayTracer(*s, *s->getGroup(), optionsOf(max_bounces, min_weight)) {}

RayTracer::RayTracer(const SceneParser& scene, const Object3D& geometry,
                     const RenderOptions& options)
    : scene_(&scene),
      geometry_(&geometry),
      options_(options),
      hasGlass_(hasTransparentMaterial(scene)) {
  options_.epsilon = resolved(options.epsilon, scene);
}

RayTracer RayTracer::watchedBy(RayObserver* observer, const Object3D& geometry) const {
  RayTracer tracer = *this;
  tracer.observer_ = observer;
  tracer.geometry_ = &geometry;
  return tracer;
}

Vec3f RayTracer::traceRay(Ray& ray, float tmin, int bounces, float weight, float indexOfRefraction,
                          Hit& hit) const {
  if (observer_ && bounces == 0) {
    begun(RayKind::eye, {ray, tmin, weight, indexOfRefraction, {}}, 0);
  }
  const double tmax = hit.getT();
  Passage passage;
  const bool found = geometry_->intersect(ray, hit, tmin) && settle(ray, tmax, hit, passage);
  report([&](RayObserver& observer) { observer.rayMeets(found ? &hit : nullptr); });
  const Vec3f color = found ? shade(ray, hit, passage, bounces, weight, indexOfRefraction)
                            : scene_->getBackgroundColor();
  report([&](RayObserver& observer) { observer.rayEnds(color); });
  return color;
}

Vec3f RayTracer::shade(const Ray& ray, const Hit& hit, const Passage& passage, int bounces,
                       float weight, float indexOfRefraction) const {
  if (hit.getMaterial()->asTexture()) {
    return shadeTexture(ray, hit, passage, bounces, weight, indexOfRefraction);
  }
  const Vec3d fromAmbient = told(ColorTerm::ambient, ambient(hit));
  const Vec3d fromLights = told(ColorTerm::lights, lights(ray, hit));
  const Vec3d fromMirror =
      told(ColorTerm::mirror,
           follow(mirrored(ray, hit, passage, bounces, weight, indexOfRefraction), bounces));
  const Vec3d fromBehind =
      told(ColorTerm::transmitted, follow(refracted(ray, hit, passage, bounces, weight), bounces));
  // Summed in double and rounded once: 0.02 + 0.9 * 0.2 is 0.2 again.
  return Vec3f((fromAmbient + fromLights + fromMirror + fromBehind) * Vec3d(passage.tint));
}

Vec3d RayTracer::told(ColorTerm term, const Vec3d& color) const {
  report([&](RayObserver& observer) { observer.termIsKnown(term, color); });
  return color;
}

Vec3f RayTracer::shadeTexture(const Ray& ray, const Hit& hit, const Passage& passage, int bounces,
                              float weight, float indexOfRefraction) const {
  const SolidTexture& texture = *hit.getMaterial()->asTexture();
  Vec3d sum;
  for (const WeightedMaterial& part : texture.partsAt(hit.getIntersectionPoint())) {
    const Vec3f color = shade(ray, hit.withMaterial(part.material), passage, bounces,
                              weight * float(part.weight), indexOfRefraction);
    sum += part.weight * Vec3d(color);
  }
  return Vec3f(sum);
}

Vec3d RayTracer::ambient(const Hit& hit) const {
  return Vec3d(scene_->getAmbientLight()) * Vec3d(hit.getMaterial()->getDiffuseColor());
}

Vec3d RayTracer::lights(const Ray& ray, const Hit& hit) const {
  std::optional<Hit> turned;
  const Hit& lit = litSide(ray, hit, turned);
  Vec3d sum;
  for (int i = 0; i < scene_->getNumLights(); ++i) {
    const LightSample light = sampleLight(i, lit);
    const Vec3f visible = light.isInFront ? visibility(hit, light) : Vec3f();
    reportLight(i, light, visible);
    if (light.isInFront) sum += reflected(ray, lit, light, visible);
  }
  return sum;
}

const Hit& RayTracer::litSide(const Ray& ray, const Hit& hit, std::optional<Hit>& turned) const {
  if (!options_.shadeBack || dot(hit.getNormal(), ray.getDirection()) <= 0) return hit;
  turned = hit;
  turned->set(hit.getT(), hit.getMaterial(), -hit.getNormal(), ray);
  return *turned;
}

RayTracer::LightSample RayTracer::sampleLight(int index, const Hit& lit) const {
  LightSample light;
  scene_->getLight(index)->getIllumination(lit.getIntersectionPoint(), light.direction, light.color,
                                           light.distance);
  light.isInFront = dot(lit.getNormal(), light.direction) > 0;
  return light;
}

Vec3d RayTracer::reflected(const Ray& ray, const Hit& lit, const LightSample& light,
                           const Vec3f& visible) const {
  if (visible == Vec3f()) return Vec3d();
  return lit.getMaterial()->Shade(ray, lit, Vec3f(light.direction), light.color * visible);
}

Vec3f RayTracer::visibility(const Hit& hit, const LightSample& light) const {
  if (!options_.shadows) return {1, 1, 1};
  const ShadowQuery way = shadowQuery(hit, light);
  if (options_.transparentShadows) return transmittance(*geometry_, way.ray, way.tmin, way.tmax);
  return geometry_->occluded(way.ray, way.tmin, way.tmax) ? Vec3f() : Vec3f(1, 1, 1);
}

ShadowQuery RayTracer::shadowQuery(const Hit& hit, const LightSample& light) const {
  return {leavingRay(hit, light.direction), epsilonAt(hit), light.distance};
}

void RayTracer::reportLight(int index, const LightSample& light, const Vec3f& visible) const {
  report([&](RayObserver& observer) {
    observer.lightAnswers({index, light.isInFront, light.isInFront && options_.shadows, visible});
  });
}

/// The mirror's and the transmitted term: what the next ray brings, `bounces` before it.
Vec3d RayTracer::follow(std::optional<TracedRay> next, int bounces) const {
  if (!next) return Vec3d();
  Hit hit;
  return Vec3d(next->factor) * traceRay(next->ray, float(next->tmin), bounces + 1, next->weight,
                                        next->indexOfRefraction, hit);
}

RayTracer::TracedRay RayTracer::begun(RayKind kind, const TracedRay& next, int bounces) const {
  report([&](RayObserver& observer) {
    observer.rayBegins({kind, next.ray, bounces, next.weight, next.indexOfRefraction});
  });
  return next;
}

/// The one place where recursion stops.
bool RayTracer::mayTrace(RayKind kind, const Vec3f& color, int bounces, float weight) const {
  if (!anyPositive(color)) return false;
  const bool hasBounces = bounces < options_.maxBounces;
  if (hasBounces && weight >= options_.minWeight) return true;
  report([&](RayObserver& observer) {
    observer.branchStops(kind, hasBounces ? BranchStop::weight : BranchStop::bounces, weight);
  });
  return false;
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
