// Sphere: the two roots of |origin + t direction - center| = radius.
#include "geometry/sphere.h"

#include <algorithm>
#include <cmath>

/// Finds the roots as middle - half and middle + half; false where the ray passes by. The
/// discriminant is taken from the vector between the centre and the ray's nearest point, which
/// keeps its digits for a far or a huge sphere. Source: Haines, Guenther and Akenine-Moeller,
/// "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019.
bool Sphere::roots(const Ray& ray, double& middle, double& half) const {
  const Vec3d& direction = ray.getDirection();
  const Vec3d toCenter = center_ - ray.getOrigin();
  const double lengthSquared = dot(direction, direction);
  middle = dot(toCenter, direction) / lengthSquared;
  const Vec3d beside = toCenter - direction * middle;
  const double halfChordSquared = radius_ * radius_ - dot(beside, beside);
  if (!(halfChordSquared >= 0)) return false;
  half = std::sqrt(halfChordSquared / lengthSquared);
  return true;
}

/// Finds the least t with tmin < t < tmax at which the ray meets the sphere; on success stores it
/// in `t`. The one function that decides a sphere hit.
bool Sphere::nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const {
  double middle, half;
  if (!roots(ray, middle, half)) return false;
  // A ray that leaves this sphere meets it again only where it comes out on the other side.
  const bool leaves = ray.leaves(this);
  if (leaves && middle <= 0) return false;
  double root = middle - half;
  if (leaves || !(root > tmin)) root = middle + half;
  if (!(root > tmin && root < tmax)) return false;
  t = root;
  return true;
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
  if (!roots(ray, middle, half)) return;
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
