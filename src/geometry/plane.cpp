// Plane: t = (offset - n . origin) / (n . direction).
// Any point of the ray has the distance n . (origin + t direction) - offset from the plane, which
// is linear in t and 0 where the ray meets it.
#include "geometry/plane.h"

#include <cmath>
#include <limits>

/// Finds that t where tmin < t < tmax and the ray does not start on the plane.
bool Plane::nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const {
  if (ray.leaves(this)) return false;
  const double approach = dot(normal_, ray.getDirection());
  const double root = (offset_ - dot(normal_, ray.getOrigin())) / approach;
  if (approach == 0 || !(root > tmin && root < tmax)) return false;
  t = root;
  return true;
}

bool Plane::intersect(const Ray& ray, Hit& hit, double tmin) const {
  double t;
  if (!nearestRoot(ray, tmin, hit.getT(), t)) return false;
  const Vec3d point = ray.pointAtParameter(t);
  const double extent = std::fabs(offset_);
  hit.record(t, material_, normal_, point, {this, 0, magnitudeOf(t, point, ray, extent)});
  return true;
}

bool Plane::occluded(const Ray& ray, double tmin, double tmax) const {
  double t;
  return nearestRoot(ray, tmin, tmax, t);
}

void Plane::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  double t;
  if (!nearestRoot(ray, 0, std::numeric_limits<double>::infinity(), t)) return;
  visitor.visit({t, this, material_, false, dot(normal_, ray.getDirection()) > 0});
}
