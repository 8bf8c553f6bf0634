// Triangle: see geometry/triangle_test.h for the test itself.
#include "geometry/triangle.h"

#include "geometry/triangle_test.h"

bool Triangle::hasArea() const {
  return triangle::areaNormal(vertices_[0], vertices_[1], vertices_[2]) != Vec3d();
}

bool Triangle::nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const {
  const auto& [a, b, c] = vertices_;
  double root;
  if (ray.leaves(this) || !triangle::intersect(a, b, c, ray, root)) return false;
  if (!(root > tmin && root < tmax)) return false;
  t = root;
  return true;
}

void Triangle::setHit(const Ray& ray, double t, Hit& hit) const {
  const auto& [a, b, c] = vertices_;
  const Vec3d point = ray.pointAtParameter(t);
  hit.record(t, material_, normalize(triangle::areaNormal(a, b, c)), point,
             {this, 0, magnitudeOf(t, point, ray, triangle::extent(a, b, c))});
}

bool Triangle::intersect(const Ray& ray, Hit& hit, double tmin) const {
  double t;
  if (!nearestRoot(ray, tmin, hit.getT(), t)) return false;
  setHit(ray, t, hit);
  return true;
}

bool Triangle::occluded(const Ray& ray, double tmin, double tmax) const {
  double t;
  return nearestRoot(ray, tmin, tmax, t);
}

void Triangle::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  const auto& [a, b, c] = vertices_;
  double t;
  bool leaving;
  if (!triangle::crosses(a, b, c, ray, t, leaving) || !(t > 0)) return;
  visitor.visit({t, this, material_, false, leaving});
}

void Triangle::addBounds(const Matrix& toWorld, BoundingBox& box) const {
  for (const Vec3d& vertex : vertices_) box.extend(toWorld.transformPoint(vertex));
}
