// Shader: the terms of the sum, written once.
//
// At a surface with unit normal n, met by a ray of unit direction v:
//   light       l is the direction to it; L, what arrives, is the light's colour, dimmed by its
//               distance; Material::Shade knows what of L goes back along the ray
//   mirror      r = v - 2 (v.n) n, times the reflective colour
//   refraction  Snell's law between the indices of both sides, times the transparent colour
// With `fresnel` the two colours follow from angle and indices instead. A ray that continues starts
// at the hit's point, and meets only what lies beyond epsilon.
#include "render/shader.h"

#include <cmath>

#include "shading/optics.h"

namespace {

/// The assignment's constant suits scenes of the assignment's size: those that span 1 to 1000
/// units, and those of planes alone, which span nothing.
Epsilon resolved(const Epsilon& epsilon, const SceneParser& scene) {
  if (epsilon.kind != Epsilon::Kind::automatic) return epsilon;
  const double span = scene.getSpan();
  const bool isUsual = span == 0 || (span >= 1 && span <= 1000);
  return {isUsual ? Epsilon::Kind::fixed : Epsilon::Kind::adaptive, Epsilon::kCourse};
}

bool isTransparent(const Surface& s) {
  return anyPositive(s.hit.getMaterial()->getTransparentColor());
}

/// n.v: below 0 where the ray comes from outside.
double approach(const Surface& s) { return dot(s.hit.getNormal(), s.ray.getDirection()); }

Vec3f grey(double value) { return Vec3f(Vec3d(value, value, value)); }

/// The part of light that glass mirrors here, by Fresnel's equations.
double reflectance(const Surface& s) {
  const Material& material = *s.hit.getMaterial();
  const double before = double(s.interface.before.indexAt(material));
  const double behind = double(s.interface.behind.indexAt(material));
  return dielectricReflectance(std::fabs(approach(s)), behind / before);
}

/// Whether lights see the surface's other side: with `shadeBack` the one that the ray sees.
bool isTurned(const Surface& s, bool shadeBack) { return shadeBack && approach(s) > 0; }

}  // namespace

Shader::Shader(const SceneParser& scene, const RenderOptions& options)
    : scene_(&scene), options_(options) {
  options_.epsilon = resolved(options.epsilon, scene);
}

void Shader::sampleLight(int index, const Surface& s, LightSample& light) const {
  scene_->getLight(index)->getIllumination(s.hit.getIntersectionPoint(), light.direction,
                                           light.color, light.distance);
  const double cosine = dot(s.hit.getNormal(), light.direction);
  light.isInFront = isTurned(s, options_.shadeBack) ? cosine < 0 : cosine > 0;
}

void Shader::setShadowQuery(const Surface& s, const LightSample& light, ShadowQuery& query) const {
  setLeaving(s.hit, light.direction, query.ray);
  query.tmin = double(epsilonAt(s.hit));
  query.tmax = light.distance;
}

Vec3d Shader::reflected(const Surface& s, const LightSample& light, const Vec3f& visible) const {
  if (visible == Vec3f()) return Vec3d();
  const Material& material = *s.hit.getMaterial();
  const Vec3f direction(light.direction);
  if (isTurned(s, options_.shadeBack)) {
    return material.Shade(s.ray, s.hit.withNormal(-s.hit.getNormal()), direction,
                          light.color * visible);
  }
  return material.Shade(s.ray, s.hit, direction, light.color * visible);
}

/// Where recursion ends: by the number of bounces, or where a ray would weigh too little.
/// `factor` is its colour's in that of the surface.
Outcome Shader::follow(const Surface& s, const Vec3f& factor, TracedRay& next) const {
  if (!anyPositive(factor)) return Outcome::none;
  next.factor = factor;
  next.weight = s.weight * length(factor * s.interface.tint);
  if (s.bounces >= options_.maxBounces) return Outcome::tooManyBounces;
  if (!(next.weight >= options_.minWeight)) return Outcome::tooFaint;
  next.tmin = double(epsilonAt(s.hit));
  return Outcome::follows;
}

/// With an adaptive epsilon the ray knows what it leaves, so that rounding in its origin cannot
/// make it meet that again.
void Shader::setLeaving(const Hit& hit, const Vec3d& direction, Ray& ray) const {
  ray.set(hit.getIntersectionPoint(), direction);
  if (options_.epsilon.kind == Epsilon::Kind::adaptive) {
    ray.setSource(hit.getObject(), hit.getFace());
  }
}

Outcome Shader::mirrored(const Surface& s, TracedRay& next) const {
  const Outcome outcome = follow(s, mirrorFactor(s), next);
  if (outcome != Outcome::follows) return outcome;
  setLeaving(s.hit, mirrorDirection(s.hit.getNormal(), s.ray.getDirection()), next.ray);
  next.indexOfRefraction = s.indexOfRefraction;
  return Outcome::follows;
}

/// With `fresnel`, glass mirrors by Fresnel's equations and takes no notice of its reflective
/// colour; a metal's grows towards white at grazing angles (Schlick).
Vec3f Shader::mirrorFactor(const Surface& s) const {
  const Vec3f color = s.hit.getMaterial()->getReflectiveColor();
  if (!options_.fresnel) return color;
  if (isTransparent(s)) return grey(reflectance(s));
  if (!anyPositive(color)) return Vec3f();
  return Vec3f(schlickReflectance(std::fabs(approach(s)), Vec3d(color)));
}

Outcome Shader::refracted(const Surface& s, TracedRay& next) const {
  const Outcome outcome = follow(s, refractedFactor(s), next);
  if (outcome != Outcome::follows) return outcome;
  const Material& material = *s.hit.getMaterial();
  const float before = s.interface.before.indexAt(material);
  const float behind = s.interface.behind.indexAt(material);
  const Vec3d& incoming = s.ray.getDirection();
  const Vec3d normal = approach(s) < 0 ? s.hit.getNormal() : -s.hit.getNormal();
  // Between equal indices the ray goes straight on, to the last bit, where media are looked after.
  Vec3d direction = incoming;
  const bool isStraight = before == behind && (options_.nestedDielectrics || options_.fresnel);
  if (!isStraight && !transmittedDirection(normal, incoming, before, behind, direction)) {
    return Outcome::totalReflection;
  }
  setLeaving(s.hit, direction, next.ray);
  next.indexOfRefraction = behind;
  return Outcome::follows;
}

/// With `fresnel` what is not mirrored goes through; a closed object dims light on the way inside
/// (Interface::tint), an open one where it is crossed.
Vec3f Shader::refractedFactor(const Surface& s) const {
  const Vec3f color = s.hit.getMaterial()->getTransparentColor();
  if (!options_.fresnel || !anyPositive(color)) return color;
  const Vec3f passed = grey(1 - reflectance(s));
  return s.interface.isClosed ? passed : color * passed;
}
