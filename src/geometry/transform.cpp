// Transform: moves the ray in, asks the object, moves the hit out.
//
// With M the matrix, a point inside is M^-1 p and a direction M^-1 d, of any length; the object's t
// is ours. The hit's point is the ray's at t, taken outside, and its normal is M^-T n, made a unit
// vector again: a normal stays at right angles to what lies in the surface, as a direction would
// not.
#include "geometry/transform.h"

#include <cassert>

Transform::Transform(const Matrix& matrix, const Object3D* object)
    : matrix_(matrix), object_(object) {
  const bool invertible = matrix.inverse(inverse_);
  assert(invertible);
  (void)invertible;
}

void Transform::toParent(const Ray& ray, Hit& hit) const {
  const Vec3d normal = normalize(inverse_.transposeTransformDirection(hit.getNormal()));
  const Vec3d point = ray.pointAtParameter(hit.getT());
  const double magnitude =
      outsideMagnitude(inverse_, hit.getMagnitude(), point, ray.getOrigin(), ray.getDirection());
  hit.record(hit.getT(), hit.getMaterial(), normal, point,
             {hit.getObject(), hit.getFace(), magnitude, hit.getTextureCoordinates()});
}

bool Transform::intersect(const Ray& ray, Hit& hit, double tmin) const {
  if (!object_->intersect(toObject(ray), hit, tmin)) return false;
  toParent(ray, hit);
  return true;
}
