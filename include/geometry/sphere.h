// Sphere: a closed ball's surface. Its normal points outwards.
#pragma once
#include "geometry/object3d.h"

class Sphere : public Object3D {
 public:
  /// radius > 0, in the units of the space the sphere stands in. The material is not owned.
  Sphere(const Vec3d& center, double radius, const Material* material)
      : center_(center), radius_(radius), material_(material) {}

  const Vec3d& getCenter() const { return center_; }
  double getRadius() const { return radius_; }
  const Material* getMaterial() const { return material_; }

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override;
  bool isBounded() const override { return true; }

 private:
  bool nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const;
  bool roots(const Ray& ray, double& middle, double& half) const;

  Vec3d center_;
  double radius_;
  const Material* material_;  // not owned
};
