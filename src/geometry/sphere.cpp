// Sphere: the two roots of |origin + t direction - center| = radius, which sphere.h finds.
#include "geometry/sphere.h"

#include <algorithm>

bool Sphere::nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const {
  return sphere::nearestRoot(center_, radius_, ray.getOrigin(), ray.getDirection(), tmin, tmax,
                             ray.leaves(this), t);
}

bool Sphere::intersect(const Ray& ray, Hit& hit, double tmin) const {
  double t;
  if (!nearestRoot(ray, tmin, hit.getT(), t)) return false;
  const Vec3d point = ray.pointAtParameter(t);
  const double extent = std::max(maxAbs(center_), radius_);
  hit.record(t, material_, normalize(point - center_), point,
             {this, 0, magnitudeOf(t, point, ray, extent)});
  return true;
}

bool Sphere::occluded(const Ray& ray, double tmin, double tmax) const {
  double t;
  return nearestRoot(ray, tmin, tmax, t);
}

void Sphere::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  double middle, half;
  if (!sphere::roots(center_, radius_, ray.getOrigin(), ray.getDirection(), middle, half)) return;
  if (middle - half > 0) visitor.visit({middle - half, this, material_, true, false});
  if (middle + half > 0) visitor.visit({middle + half, this, material_, true, true});
}

void Sphere::addBounds(const Matrix& toWorld, BoundingBox& box) const {
  const Vec3d center = toWorld.transformPoint(center_);
  Vec3d reach;  // an ellipsoid reaches as far along an axis as that row of the matrix is long
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d row(toWorld.at(axis, 0), toWorld.at(axis, 1), toWorld.at(axis, 2));
    reach[axis] = radius_ * length(row);
  }
  box.extend(center - reach);
  box.extend(center + reach);
}
