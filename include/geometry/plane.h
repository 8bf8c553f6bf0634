// Plane: all points p with normal . p = offset. It has no bounds.
#pragma once
#include "geometry/object3d.h"

class Plane : public Object3D {
 public:
  /// The normal is normalised first (it must not be zero); offset is the signed distance of the
  /// plane from the origin along it. The material is not owned.
  Plane(const Vec3d& normal, double offset, const Material* material)
      : normal_(normalize(normal)), offset_(offset), material_(material) {}

  /// A unit vector.
  const Vec3d& getNormal() const { return normal_; }
  /// The signed distance of the plane from the origin, along the unit normal.
  double getOffset() const { return offset_; }
  const Material* getMaterial() const { return material_; }

  /// A ray parallel to the plane never meets it.
  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;

 private:
  bool nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const;

  Vec3d normal_;
  double offset_;
  const Material* material_;  // not owned
};
