// WatchedTracer: before or after each step of RayTracer the observer is told what comes of it.
// Nothing is computed here, but for a shadow ray, which is made once more to be shown. Where there
// is something to tell between the steps of RayTracer's meet, light and branch, these take the same
// steps themselves: who changes the ones changes the others.
//
// An eye ray is told of where it is traced, as nobody continues it. A secondary ray is told of
// where it branches off: its kind and its factor are known there, and so is why there is none.
#include "render/watched_tracer.h"

Vec3f WatchedTracer::traceRay(Ray& ray, float tmin, int bounces, float weight,
                              float indexOfRefraction, Hit& hit) const {
  // Secondary rays have been told of where they began, in branch().
  if (bounces == 0) {
    observer_.rayBegins(RayKind::eye, 0, {ray, double(tmin), weight, indexOfRefraction, {1, 1, 1}});
  }
  const Vec3f color = RayTracer::traceRay(ray, tmin, bounces, weight, indexOfRefraction, hit);
  observer_.rayEnds(color);
  return color;
}

/// Surfaces that are not there are told of before the one that is.
bool WatchedTracer::meet(const Ray& ray, double tmin, float index, Hit& hit,
                         Interface& interface) const {
  std::vector<Hit> passed;
  const bool isFound = interfaces().intersect(ray, tmin, index, hit, interface, &passed);
  for (const Hit& surface : passed) observer_.surfaceIsPassed(surface);
  observer_.rayMeets(isFound ? &hit : nullptr, interface);
  return isFound;
}

Vec3f WatchedTracer::shadeComponent(const Surface& s, double share) const {
  observer_.componentBegins(*s.hit.getMaterial(), share);
  const Vec3f color = RayTracer::shadeComponent(s, share);
  observer_.componentEnds(color);
  return color;
}

/// Tells of a term, and hands it on.
Vec3d WatchedTracer::report(ColorTerm term, const Vec3d& color) const {
  observer_.termIsKnown(term, color);
  return color;
}

Vec3d WatchedTracer::ambient(const Surface& s) const {
  return report(ColorTerm::ambient, RayTracer::ambient(s));
}

Vec3d WatchedTracer::lights(const Surface& s) const {
  return report(ColorTerm::lights, RayTracer::lights(s));
}

/// RayTracer::light with its steps apart, so that each can be shown.
Vec3d WatchedTracer::light(int index, const Surface& s) const {
  LightSample light;
  shader().sampleLight(index, s, light);
  const bool isAsked = light.isInFront && shader().options().shadows;
  const Vec3f visible = light.isInFront ? visibility(s, light) : Vec3f();
  ShadowQuery query;
  if (isAsked) shader().setShadowQuery(s, light, query);
  const Vec3d added = shader().reflected(s, light, visible);
  observer_.lightAnswers(index, light, isAsked ? &query : nullptr, visible, added);
  return added;
}

/// What the ray brings that continues at `s`; or tells why there is none.
Vec3d WatchedTracer::branch(RayKind kind, const Surface& s) const {
  TracedRay next;
  const Outcome outcome = shader().continued(kind, s, next);
  Vec3d color;
  if (outcome == Outcome::follows) {
    observer_.rayBegins(kind, s.bounces + 1, next);
    color = follow(s, next);
  } else if (outcome != Outcome::none) {
    observer_.branchEnds(kind, outcome, next.weight);
  }
  return report(kind == RayKind::mirror ? ColorTerm::mirror : ColorTerm::transmitted, color);
}
