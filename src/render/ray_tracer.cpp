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

template <class Property>
bool anyMaterial(const SceneParser& scene, const Property& hasIt) {
  for (int i = 0; i < scene.getNumMaterials(); ++i) {
    if (hasIt(*scene.getMaterial(i))) return true;
  }
  return false;
}

bool isTransparent(const Material& material) { return anyPositive(material.getTransparentColor()); }

bool isTextured(const Material& material) { return material.asTexture() != nullptr; }

}  // namespace

RayTracer::RayTracer(SceneParser* s, int max_bounces, float min_weight)
    : RayTracer(*s, *s->getGroup(), optionsOf(max_bounces, min_weight)) {}

RayTracer::RayTracer(const SceneParser& scene, const Object3D& geometry,
                     const RenderOptions& options)
    : scene_(&scene),
      geometry_(&geometry),
      options_(options),
      hasTextures_(anyMaterial(scene, isTextured)),
      tracksMedia_((options.fresnel || options.nestedDielectrics) &&
                   anyMaterial(scene, isTransparent)) {
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
    reportBegin(RayKind::eye, ray, tmin, {weight, indexOfRefraction, {1, 1, 1}}, 0);
  }
  const double tmax = hit.getT();
  Passage passage;
  const bool found = geometry_->intersect(ray, hit, tmin) && settle(ray, tmax, hit, passage);
  report([&](RayObserver& observer) { observer.rayMeets(found ? &hit : nullptr); });
  if (found) report([&](RayObserver& observer) { observer.passageIsKnown(passage); });
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
  Ray next;
  RayShare share;
  const bool isMirrored =
      mirrored(ray, hit, passage, bounces, weight, indexOfRefraction, next, share);
  const Vec3d fromMirror =
      told(ColorTerm::mirror, isMirrored ? follow(next, epsilonAt(hit), share, bounces) : Vec3d());
  const bool isRefracted = refracted(ray, hit, passage, bounces, weight, next, share);
  const Vec3d fromBehind = told(
      ColorTerm::transmitted, isRefracted ? follow(next, epsilonAt(hit), share, bounces) : Vec3d());
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
    report([&](RayObserver& observer) { observer.partBegins(*part.material, part.weight); });
    const Vec3f color = shade(ray, hit.withMaterial(part.material), passage, bounces,
                              weight * float(part.weight), indexOfRefraction);
    report([&](RayObserver& observer) { observer.partEnds(color); });
    sum += part.weight * Vec3d(color);
  }
  return Vec3f(sum);
}

Vec3d RayTracer::lights(const Ray& ray, const Hit& hit) const {
  Hit turned;
  const Hit& lit = litSide(ray, hit, turned);
  Vec3d sum;
  for (int i = 0; i < scene_->getNumLights(); ++i) {
    LightSample light;
    sampleLight(i, lit, light);
    const Vec3f visible = light.isInFront ? visibility(hit, light) : Vec3f();
    reportLight(i, hit, light, visible);
    if (visible == Vec3f()) continue;
    const Vec3d added = reflected(ray, lit, light, visible);
    report([&](RayObserver& observer) { observer.lightAdds(added); });
    sum += added;
  }
  return sum;
}

const Hit& RayTracer::sideTowards(const Ray& ray, const Hit& hit, Hit& turned) {
  if (dot(hit.getNormal(), ray.getDirection()) <= 0) return hit;
  turned = hit.withNormal(-hit.getNormal());
  return turned;
}

void RayTracer::sampleLight(int index, const Hit& lit, LightSample& light) const {
  scene_->getLight(index)->getIllumination(lit.getIntersectionPoint(), light.direction, light.color,
                                           light.distance);
  light.isInFront = dot(lit.getNormal(), light.direction) > 0;
}

Vec3d RayTracer::reflected(const Ray& ray, const Hit& lit, const LightSample& light,
                           const Vec3f& visible) const {
  if (visible == Vec3f()) return Vec3d();
  return lit.getMaterial()->Shade(ray, lit, Vec3f(light.direction), light.color * visible);
}

Vec3f RayTracer::visibility(const Hit& hit, const LightSample& light) const {
  if (!options_.shadows) return {1, 1, 1};
  ShadowQuery way;
  setShadowQuery(hit, light, way);
  if (options_.transparentShadows) return transmittance(*geometry_, way.ray, way.tmin, way.tmax);
  return geometry_->occluded(way.ray, way.tmin, way.tmax) ? Vec3f() : Vec3f(1, 1, 1);
}

void RayTracer::tellLight(int index, const Hit& hit, const LightSample& light,
                          const Vec3f& visible) const {
  const bool isAsked = light.isInFront && options_.shadows;
  ShadowQuery way;
  if (isAsked) setShadowQuery(hit, light, way);
  observer_->lightAnswers({index, light.isInFront, isAsked, visible, light.direction,
                           light.distance, isAsked ? &way : nullptr});
}

/// The mirror's and the transmitted term: what the next ray brings, `bounces` before it.
Vec3d RayTracer::follow(Ray& next, double tmin, const RayShare& share, int bounces) const {
  Hit hit;
  return Vec3d(share.factor) *
         traceRay(next, float(tmin), bounces + 1, share.weight, share.indexOfRefraction, hit);
}

void RayTracer::reportBegin(RayKind kind, const Ray& ray, double tmin, const RayShare& share,
                            int bounces) const {
  observer_->rayBegins(
      {kind, ray, bounces, share.weight, share.indexOfRefraction, tmin, share.factor});
}

/// The one place where recursion stops; a black factor asks for no ray at all.
bool RayTracer::mayTrace(RayKind kind, int bounces, float weight) const {
  const bool hasBounces = bounces < options_.maxBounces;
  if (hasBounces && weight >= options_.minWeight) return true;
  report([&](RayObserver& observer) {
    observer.branchStops(kind, hasBounces ? BranchStop::weight : BranchStop::bounces, weight);
  });
  return false;
}
