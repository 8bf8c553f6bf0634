// The rival's shading.
#include "rivals/plain_shading.h"

#include <cmath>
#include <limits>

#include "shading/optics.h"

namespace bench {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

RTCRay rayOf(const Vec3f& o, const Vec3f& d, float tmin, float tmax) {
  RTCRay ray{};
  ray.org_x = o.x();
  ray.org_y = o.y();
  ray.org_z = o.z();
  ray.tnear = tmin;
  ray.dir_x = d.x();
  ray.dir_y = d.y();
  ray.dir_z = d.z();
  ray.tfar = tmax;
  ray.mask = ~0u;
  return ray;
}

/// The least t of the floor in (tmin, tmax), or tmax.
float floorAt(const Vec3f& o, const Vec3f& d, float tmin, float tmax) {
  const float t = (kFloorHeight - o.y()) / d.y();
  return t > tmin && t < tmax ? t : tmax;
}

/// The same of the ball.
float ballAt(const Vec3f& o, const Vec3f& d, float tmin, float tmax) {
  const Vec3f way = kBallCenter - o;
  const float middle = dot(way, d);
  const Vec3f off = way - d * middle;
  const float square = kBallRadius * kBallRadius - dot(off, off);
  if (!(square > 0)) return tmax;
  const float half = std::sqrt(square);
  if (middle - half > tmin && middle - half < tmax) return middle - half;
  return middle + half > tmin && middle + half < tmax ? middle + half : tmax;
}

}  // namespace

bool PlainTracer::nearest(const Vec3f& o, const Vec3f& d, float tmin, Found& found) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit hit;
  hit.ray = rayOf(o, d, tmin, kFar);
  hit.hit.geomID = hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_, &context, &hit);
  found.t = hit.ray.tfar;
  if (hit.hit.geomID != RTC_INVALID_GEOMETRY_ID) found.surface = &kMeshSurface;
  const float ground = floorAt(o, d, tmin, found.t);
  if (ground < found.t) found = {ground, &kFloorSurface, {0, 1, 0}};
  const float ball = ballAt(o, d, tmin, found.t);
  if (ball < found.t) {
    found = {ball, &kGlassSurface, (o + d * ball - kBallCenter) / kBallRadius};
  }
  if (found.surface == &kMeshSurface) {
    found.normal = normalize(Vec3f(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z));
  }
  return found.surface != nullptr;
}

bool PlainTracer::blocked(const Vec3f& o, const Vec3f& d, float tmax) const {
  if (floorAt(o, d, kRayEpsilon, tmax) < tmax || ballAt(o, d, kRayEpsilon, tmax) < tmax)
    return true;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = rayOf(o, d, kRayEpsilon, tmax);
  rtcOccluded1(scene_, &context, &ray);
  return ray.tfar < 0;
}

Vec3f PlainTracer::lit(const Vec3f& point, const Vec3f& direction, const Found& found) const {
  const Vec3f way = kLightPlace - point;
  const float distance = length(way);
  const Vec3f l = way / distance;
  const float cosine = dot(found.normal, l);
  if (!(cosine > 0) || blocked(point, l, distance)) return Vec3f();
  Vec3f sum = found.surface->diffuse * cosine;
  const float highlight = dot(mirrorDirection(found.normal, direction), l);
  if (highlight > 0 && anyPositive(found.surface->specular)) {
    sum += found.surface->specular * std::pow(highlight, found.surface->exponent);
  }
  return kLightColor * sum;
}

Vec3f PlainTracer::mirror(const Vec3f& point, const Vec3f& direction, const Found& found,
                          int bounces, float weight) const {
  const Vec3f& color = found.surface->reflective;
  const float next = weight * length(color);
  if (!anyPositive(color) || bounces >= kBounces || next < kMinWeight) return Vec3f();
  return color *
         trace(point, mirrorDirection(found.normal, direction), kRayEpsilon, bounces + 1, next);
}

Vec3f PlainTracer::refracted(const Vec3f& point, const Vec3f& direction, const Found& found,
                             int bounces, float weight) const {
  const Vec3f& color = found.surface->transparent;
  const float next = weight * length(color);
  if (!anyPositive(color) || bounces >= kBounces || next < kMinWeight) return Vec3f();
  const bool outside = dot(found.normal, direction) < 0;
  const float index = found.surface->index;
  Vec3f through;
  if (!transmittedDirection(outside ? found.normal : -found.normal, direction, outside ? 1 : index,
                            outside ? index : 1, through)) {
    return Vec3f();
  }
  return color * trace(point, through, kRayEpsilon, bounces + 1, next);
}

Vec3f PlainTracer::trace(const Vec3f& origin, const Vec3f& direction, float tmin, int bounces,
                         float weight) const {
  Found found;
  if (!nearest(origin, direction, tmin, found)) return kBackground;
  const Vec3f point = origin + direction * found.t;
  return kAmbient * found.surface->diffuse + lit(point, direction, found) +
         mirror(point, direction, found, bounces, weight) +
         refracted(point, direction, found, bounces, weight);
}

}  // namespace bench
