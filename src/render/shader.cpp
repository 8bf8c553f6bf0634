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

#include "shading/diffuse_map.h"
#include "shading/optics.h"

namespace {

/// The assignment's constant suits scenes of the assignment's size: those that span 1 to 1000
/// units, and those of planes alone, which span nothing; but not where glass is thinner than it.
Epsilon resolved(const Epsilon& epsilon, const SceneParser& scene) {
  if (epsilon.kind != Epsilon::Kind::automatic) return epsilon;
  static_assert(SceneParser::kThinSolid >= Epsilon::kCourse, "thinner glass is looked for");
  const double span = scene.getSpan();
  const bool hasThinGlass = scene.getThinnestSolid().thickness < Epsilon::kCourse;
  const bool isUsual = (span == 0 || (span >= 1 && span <= 1000)) && !hasThinGlass;
  return {isUsual ? Epsilon::Kind::fixed : Epsilon::Kind::adaptive, Epsilon::kCourse};
}

/// n.v: below 0 where the ray comes from outside.
double approachOf(const Surface& s) { return dot(s.hit.getNormal(), s.ray.getDirection()); }

Vec3f grey(double value) { return Vec3f(Vec3d(value, value, value)); }

}  // namespace

Shader::Shader(const SceneParser& scene, const RenderOptions& options)
    : scene_(&scene), options_(options) {
  options_.epsilon = resolved(options.epsilon, scene);
  if (options.shadeBack) options_.backs = RenderOptions::Backs::litAsFront;
}

Vec3d Shader::ambient(const Surface& s) const {
  return !hasAmbient(approachOf(s)) ? Vec3d() : ambient(*s.hit.getMaterial(), s.hit);
}

Vec3d Shader::ambient(const Material& material, const Hit& hit) const {
  const DiffuseMap* const map = ambientMap(material);
  const Vec3f plain = material.getDiffuseColor();
  const Vec3d diffuse = map ? map->colorAt(hit, plain) : Vec3d(plain);
  return Vec3d(scene_->getAmbientLight()) * diffuse;
}

void Shader::sampleLight(int index, const Surface& s, LightSample& light) const {
  scene_->getLight(index)->getIllumination(s.hit.getIntersectionPoint(), light.direction,
                                           light.color, light.distance);
  const Vec3d lit = litNormal(s.hit.getNormal(), approachOf(s));
  light.isInFront = isLit(lit, light.direction, scene_->hasHighlightsBehind());
}

void Shader::setShadowQuery(const Surface& s, const LightSample& light, ShadowQuery& query) const {
  setLeaving(s.hit, light.direction, query.ray);
  query.tmin = double(epsilonAt(s.hit.getMagnitude()));
  query.tmax = light.distance;
}

Vec3d Shader::reflected(const Surface& s, const LightSample& light, const Vec3f& visible) const {
  if (visible == Vec3f()) return Vec3d();
  const Material& material = *s.hit.getMaterial();
  const Vec3f direction(light.direction);
  if (isTurned(approachOf(s))) {
    return material.Shade(s.ray, s.hit.withSurface(&material, -s.hit.getNormal()), direction,
                          light.color * visible);
  }
  return material.Shade(s.ray, s.hit, direction, light.color * visible);
}

bool Shader::sends(RayKind kind, const Material& material) const {
  if (kind == RayKind::refracted) return material.isTransparent();
  return anyPositive(material.getReflectiveColor()) ||
         (options_.fresnel && material.isTransparent());
}

/// By the number of bounces, or where a ray would weigh too little.
Outcome Shader::outcomeOf(int bounces, float weight, const Vec3f& factor, const Vec3f& tint,
                          float& nextWeight) const {
  if (!anyPositive(factor)) return Outcome::none;
  nextWeight = weight * length(factor * tint);
  if (bounces >= options_.maxBounces) return Outcome::tooManyBounces;
  return isFaint(nextWeight) ? Outcome::tooFaint : Outcome::follows;
}

/// With an adaptive epsilon the ray knows what it leaves, so that rounding in its origin cannot
/// make it meet that again.
void Shader::setLeaving(const Hit& hit, const Vec3d& direction, Ray& ray) const {
  ray.set(hit.getIntersectionPoint(), direction);
  if (options_.epsilon.kind == Epsilon::Kind::adaptive) {
    ray.setSource(hit.getObject(), hit.getFace());
  }
}

Outcome Shader::continued(RayKind kind, const Surface& s, TracedRay& next) const {
  const Vec3f factor = factorOf(kind, *s.hit.getMaterial(), s.interface, approachOf(s));
  const Outcome outcome = outcomeOf(s.bounces, s.weight, factor, s.interface.tint, next.weight);
  if (outcome != Outcome::follows) return outcome;
  next.factor = factor;
  next.tmin = double(epsilonAt(s.hit.getMagnitude()));
  next.indexOfRefraction = s.indexOfRefraction;
  Vec3d direction = s.ray.getDirection();
  if (kind == RayKind::mirror) {
    direction = mirrorDirection(s.hit.getNormal(), direction);
  } else if (!refract(s, direction, next.indexOfRefraction)) {
    return Outcome::totalReflection;
  }
  setLeaving(s.hit, direction, next.ray);
  return Outcome::follows;
}

/// Turns `direction` as Snell's law has it, and stores the index of the medium behind; false where
/// all light is mirrored.
bool Shader::refract(const Surface& s, Vec3d& direction, float& index) const {
  const Material& material = *s.hit.getMaterial();
  const float before = s.interface.before.indexAt(material);
  index = s.interface.behind.indexAt(material);
  if (before == index && keepsStraight()) return true;
  const Vec3d normal = approachOf(s) < 0 ? s.hit.getNormal() : -s.hit.getNormal();
  return transmittedDirection(normal, s.ray.getDirection(), before, index, direction);
}

/// The part of light that glass mirrors: by Fresnel's equations, or as Schlick has it, by the index
/// behind the surface.
double Shader::mirroredPart(const Material& material, const Interface& interface,
                            double approach) const {
  const double before = double(interface.before.indexAt(material));
  const double behind = double(interface.behind.indexAt(material));
  return options_.fresnel ? dielectricReflectance(std::fabs(approach), behind / before)
                          : blendedReflectance(approach, before, behind);
}

/// With `fresnel`, glass mirrors by Fresnel's equations and takes no notice of its reflective
/// colour; a metal's grows towards white at grazing angles (Schlick). Blended glass mirrors a part
/// of its reflective colour.
Vec3f Shader::mirrorFactor(const Material& material, const Interface& interface,
                           double approach) const {
  const Vec3f color = material.getReflectiveColor();
  if (isBlended(material)) return color * grey(mirroredPart(material, interface, approach));
  if (!options_.fresnel) return color;
  if (material.isTransparent()) return grey(mirroredPart(material, interface, approach));
  if (!anyPositive(color)) return Vec3f();
  return Vec3f(schlickReflectance(std::fabs(approach), Vec3d(color)));
}

/// With `fresnel` what is not mirrored goes through; a closed object dims light on the way inside
/// (Interface::tint), an open one where it is crossed.
Vec3f Shader::refractedFactor(const Material& material, const Interface& interface,
                              double approach) const {
  const Vec3f color = material.getTransparentColor();
  if (!areFactorsAngular() || !material.isTransparent()) return color;
  const Vec3f passed = grey(1 - mirroredPart(material, interface, approach));
  return options_.fresnel && interface.isClosed ? passed : color * passed;
}
