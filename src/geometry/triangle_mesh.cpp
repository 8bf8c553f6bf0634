// TriangleMesh: asks every face in turn. The compiled scene does better.
#include "geometry/triangle_mesh.h"

#include "geometry/triangle_test.h"

bool TriangleMesh::nearestRoot(std::uint32_t face, const Ray& ray, double tmin, double tmax,
                               double& t) const {
  double root;
  if (ray.leaves(this, face) ||
      !triangle::intersect(geometry_->corner(face, 0), geometry_->corner(face, 1),
                           geometry_->corner(face, 2), ray, root)) {
    return false;
  }
  if (!(root > tmin && root < tmax)) return false;
  t = root;
  return true;
}

void TriangleMesh::setHit(std::uint32_t face, const Ray& ray, double t, Hit& hit) const {
  setHit(face, geometry_->corner(face, 0), geometry_->corner(face, 1), geometry_->corner(face, 2),
         ray, t, hit);
}

void TriangleMesh::setHit(std::uint32_t face, const Vec3d& a, const Vec3d& b, const Vec3d& c,
                          const Ray& ray, double t, Hit& hit) const {
  const Vec3d point = ray.pointAtParameter(t);
  hit.record(t, material_, normalize(triangle::areaNormal(a, b, c)), point,
             {this, face, magnitudeOf(t, point, ray, triangle::extent(a, b, c))});
}

void TriangleMesh::visitFace(std::uint32_t face, const Ray& ray, CrossingVisitor& visitor) const {
  const Vec3d a = geometry_->corner(face, 0), b = geometry_->corner(face, 1),
              c = geometry_->corner(face, 2);
  double t;
  bool leaving;
  if (!triangle::crosses(a, b, c, ray, t, leaving) || !(t > 0)) return;
  visitor.visit({t, this, material_, geometry_->isClosed(), leaving});
}

bool TriangleMesh::intersect(const Ray& ray, Hit& hit, double tmin) const {
  bool found = false;
  std::uint32_t nearest = 0;
  double t = hit.getT();
  for (std::uint32_t face = 0; face < geometry_->faceCount(); ++face) {
    if (!nearestRoot(face, ray, tmin, t, t)) continue;
    nearest = face;
    found = true;
  }
  if (found) setHit(nearest, ray, t, hit);
  return found;
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

void TriangleMesh::addBounds(const Matrix& toWorld, BoundingBox& box) const {
  geometry_->addBounds(toWorld, box);
}
