// Triangle: three points; its normal points to where they run counter-clockwise.
#pragma once
#include "geometry/object3d.h"

class Triangle : public Object3D {
 public:
  /// The material is not owned. Without area the triangle is never hit.
  Triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Material* material)
      : vertices_{a, b, c}, material_(material) {}

  /// Vertex 0, 1 or 2.
  const Vec3d& getVertex(int index) const { return vertices_[index]; }
  const Material* getMaterial() const { return material_; }
  bool hasArea() const;

  /// Like Sphere::nearestRoot.
  bool nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const;
  void setHit(const Ray& ray, double t, Hit& hit) const;

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override;
  bool isBounded() const override { return true; }

 private:
  Vec3d vertices_[3];
  const Material* material_;  // not owned
};
