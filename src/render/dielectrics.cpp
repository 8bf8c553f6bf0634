// RayTracer: the rays that continue where a ray hits, and what they pass through.
#include <algorithm>
#include <cmath>
#include <optional>

#include "render/media.h"
#include "render/optics.h"
#include "render/ray_tracer.h"
#include "render/transmittance.h"
#include "shading/fresnel.h"

namespace {

bool isTransparent(const Hit& hit) { return anyPositive(hit.getMaterial()->getTransparentColor()); }

bool isOutside(const Ray& ray, const Hit& hit) {
  return dot(hit.getNormal(), ray.getDirection()) < 0;
}

double cosineOf(const Ray& ray, const Hit& hit) {
  return std::fabs(dot(hit.getNormal(), ray.getDirection()));
}

Vec3f grey(double value) { return Vec3f(Vec3d(value, value, value)); }

double reflectance(const Ray& ray, const Hit& hit, const Passage& passage) {
  const Material& material = *hit.getMaterial();
  const double before = double(passage.before.indexAt(material));
  return dielectricReflectance(cosineOf(ray, hit),
                               double(passage.behind.indexAt(material)) / before);
}

Passage::Side sideOf(const Media::Medium& medium, const Hit& hit) {
  return {medium.object == hit.getObject(), medium.indexAt(hit.getIntersectionPoint())};
}

}  // namespace

/// Whether `hit` asks for all that lies along the ray. What is far from all solids has air around.
bool RayTracer::wantsMedia(const Hit& hit) const {
  if (!options_.fresnel && !(options_.nestedDielectrics && isTransparent(hit))) return false;
  const SolidObjects* solids = scene_->getSolids();
  return !solids || !solids->areBeyond(hit.getIntersectionPoint(), reachOf(hit));
}

/// Surfaces as near as this to a hit belong to it: secondary rays do not see them either.
double RayTracer::reachOf(const Hit& hit) const {
  return std::max(double(epsilonAt(hit)), hit.getMagnitude() * 0x1p-31);
}

bool RayTracer::settle(const Ray& ray, double tmax, Hit& hit, Passage& passage) const {
  std::optional<Media> media;  // of the line that begins just before the first hit
  double start = 0;
  for (;;) {
    passage = plainPassage(dot(hit.getNormal(), ray.getDirection()) < 0);
    if (!tracksMedia_ || !wantsMedia(hit)) return true;
    if (!media) {
      start = hit.getT() - reachOf(hit);
      media.emplace(*geometry_, scene_->getSolids(),
                    Ray(ray.pointAtParameter(start), ray.getDirection()));
    }
    if (passThrough(*media, start, hit, passage)) return true;
    report([&](RayObserver& observer) { observer.surfaceIsPassed(hit); });
    Hit next(tmax);
    const bool isFound = geometry_->intersect(ray, next, hit.getT());
    hit = next;
    if (!isFound) return false;
  }
}

/// Fills in `passage` from the media along the ray, whose parameter is `start` where `media`
/// begins. False where the surface hit changes nothing: the medium before and behind is the same.
bool RayTracer::passThrough(const Media& media, double start, const Hit& hit,
                            Passage& passage) const {
  const double t = hit.getT() - start, reach = reachOf(hit);
  const double length = std::max(hit.getT(), 0.0);
  passage.isClosed = media.isClosed(hit.getObject());
  if (!options_.nestedDielectrics) {
    passage.tint = media.tintOfAll(t - reach, hit.getIntersectionPoint(), length);
    return true;
  }
  const Media::Medium before = media.mediumAt(t - reach), behind = media.mediumAt(t + reach);
  if (options_.fresnel && before.material) {
    passage.tint = absorption(transparencyAt(*before.material, hit.getIntersectionPoint()), length);
  }
  if (!passage.isClosed) return true;
  passage.before = sideOf(before, hit);
  passage.behind = sideOf(behind, hit);
  return before.object != behind.object;
}

/// The colour of the mirror ray in that of the surface.
Vec3f RayTracer::mirrorFactor(const Ray& ray, const Hit& hit, const Passage& passage) const {
  const Vec3f color = hit.getMaterial()->getReflectiveColor();
  if (!options_.fresnel) return color;
  if (isTransparent(hit)) return grey(reflectance(ray, hit, passage));
  return anyPositive(color) ? Vec3f(schlickReflectance(cosineOf(ray, hit), Vec3d(color))) : Vec3f();
}

/// The colour of the refracted ray in that of the surface. With `fresnel` a closed object dims the
/// light on the way inside, and an open one where it is crossed.
Vec3f RayTracer::refractedFactor(const Ray& ray, const Hit& hit, const Passage& passage) const {
  const Vec3f color = hit.getMaterial()->getTransparentColor();
  if (!options_.fresnel || !isTransparent(hit)) return color;
  const Vec3f passed = grey(1 - reflectance(ray, hit, passage));
  return passage.isClosed ? passed : color * passed;
}

bool RayTracer::mirrored(const Ray& ray, const Hit& hit, const Passage& passage, int bounces,
                         float weight, float indexOfRefraction, Ray& next, RayShare& share) const {
  const Vec3f color = mirrorFactor(ray, hit, passage);
  if (!anyPositive(color)) return false;
  const float mirrorWeight = weight * length(color * passage.tint);
  if (!mayTrace(RayKind::mirror, bounces, mirrorWeight)) return false;
  const Vec3d direction = mirrorDirection(hit.getNormal(), ray.getDirection());
  setLeaving(hit, direction, next);
  share = {mirrorWeight, indexOfRefraction, color};
  if (observer_) reportBegin(RayKind::mirror, next, epsilonAt(hit), share, bounces + 1);
  return true;
}

bool RayTracer::refracted(const Ray& ray, const Hit& hit, const Passage& passage, int bounces,
                          float weight, Ray& next, RayShare& share) const {
  const Vec3f color = refractedFactor(ray, hit, passage);
  if (!anyPositive(color)) return false;
  const float refractedWeight = weight * length(color * passage.tint);
  if (!mayTrace(RayKind::refracted, bounces, refractedWeight)) return false;
  const Material& material = *hit.getMaterial();
  const float before = passage.before.indexAt(material), behind = passage.behind.indexAt(material);
  const Vec3d normal = isOutside(ray, hit) ? hit.getNormal() : -hit.getNormal();
  Vec3d direction = ray.getDirection();
  const bool isStraight =
      before == behind && (options_.nestedDielectrics || options_.fresnel);  // to the last bit
  if (!isStraight && !transmittedDirection(normal, ray.getDirection(), before, behind, direction)) {
    report([&](RayObserver& observer) {
      observer.branchStops(RayKind::refracted, BranchStop::totalReflection, refractedWeight);
    });
    return false;
  }
  setLeaving(hit, direction, next);
  share = {refractedWeight, behind, color};
  if (observer_) reportBegin(RayKind::refracted, next, epsilonAt(hit), share, bounces + 1);
  return true;
}
