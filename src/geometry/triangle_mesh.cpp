// TriangleMesh: asks every face in turn. A face is decided by triangle::intersect, as a Triangle
// is; the normal and the hit's other numbers are made of the nearest face alone, at the end. The
// compiled scene does better, with the same answers: it only leaves out faces that the ray cannot
// hit.
#include "geometry/triangle_mesh.h"

#include "geometry/triangle.h"

bool TriangleMesh::nearestRoot(std::uint32_t face, const Ray& ray, double tmin, double tmax,
                               double& t) const {
  const auto [a, b, c] = geometry_->corners(face);
  return !ray.leaves(this, face) && triangle::intersect(a, b, c, ray, t) && t > tmin && t < tmax;
}

void TriangleMesh::setHit(std::uint32_t face, const Ray& ray, double t, Hit& hit) const {
  const auto [a, b, c] = geometry_->corners(face);
  const Vec3d point = ray.pointAtParameter(t);
  Vec3d normal = normalize(triangle::areaNormal(a, b, c));
  Primitive primitive = {this, face, magnitudeOf(t, point, ray, triangle::extent(a, b, c))};
  if (!geometry_->getShading().isEmpty()) {
    shadeHit(*geometry_, face, point, normal, primitive.textureCoordinates);
  }
  hit.record(t, material_, normal, point, primitive);
}

void TriangleMesh::visitFace(std::uint32_t face, const Ray& ray, CrossingVisitor& visitor) const {
  const auto [a, b, c] = geometry_->corners(face);
  double t;
  bool leaving;
  if (!triangle::crosses(a, b, c, ray, t, leaving) || !(t > 0)) return;
  visitor.visit({t, this, material_, geometry_->isClosed(), leaving});
}

bool TriangleMesh::intersect(const Ray& ray, Hit& hit, double tmin) const {
  // Each face must be nearer than those before it, so among equal ones the first wins.
  const std::uint32_t none = geometry_->faceCount();
  std::uint32_t nearest = none;
  double t, least = hit.getT();
  for (std::uint32_t face = 0; face < none; ++face) {
    if (!nearestRoot(face, ray, tmin, least, t)) continue;
    nearest = face;
    least = t;
  }
  if (nearest != none) setHit(nearest, ray, least, hit);
  return nearest != none;
}

bool TriangleMesh::occluded(const Ray& ray, double tmin, double tmax) const {
  double t;
  for (std::uint32_t face = 0; face < geometry_->faceCount(); ++face) {
    if (nearestRoot(face, ray, tmin, tmax, t)) return true;
  }
  return false;
}

void TriangleMesh::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  for (std::uint32_t face = 0; face < geometry_->faceCount(); ++face) {
    visitFace(face, ray, visitor);
  }
}
