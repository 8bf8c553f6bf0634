// Object3D: what an object that only knows how to intersect answers to the other questions.
#include "geometry/object3d.h"

bool Object3D::occluded(const Ray& ray, double tmin, double tmax) const {
  Hit hit(tmax);
  return intersect(ray, hit, tmin);
}

void Object3D::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  double tmin = 0;
  for (Hit hit; intersect(ray, hit, tmin); hit = Hit()) {
    tmin = hit.getT();
    const bool leaving = dot(hit.getNormal(), ray.getDirection()) > 0;
    visitor.visit(
        {tmin, hit.getObject() ? hit.getObject() : this, hit.getMaterial(), false, leaving});
  }
}

void Object3D::addBounds(const Matrix&, BoundingBox&) const {}
