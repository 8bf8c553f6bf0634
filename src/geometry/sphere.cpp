// Sphere: the two roots of |origin + t direction - center| = radius, which sphere.h finds.
#include "geometry/sphere.h"

void Sphere::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  double middle, half;
  if (!sphere::roots(center_, radius_, ray.getOrigin(), ray.getDirection(), middle, half)) return;
  if (middle - half > 0) visitor.visit({middle - half, this, getMaterial(), true, false});
  if (middle + half > 0) visitor.visit({middle + half, this, getMaterial(), true, true});
}

void Sphere::addBounds(const Matrix& toWorld, BoundingBox& box) const {
  const Vec3d center = toWorld.transformPoint(center_);
  Vec3d reach;  // an ellipsoid reaches as far along an axis as that row of the matrix is long
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d row(toWorld.at(axis, 0), toWorld.at(axis, 1), toWorld.at(axis, 2));
    reach[axis] = radius_ * length(row);
  }
  box.extend({center - reach, center + reach});
}
