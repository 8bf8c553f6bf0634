// Plane: all points p with normal . p = offset. It has no bounds.
//
// Any point of a ray has the distance n . (origin + t direction) - offset from the plane, which is
// linear in t and 0 where the ray meets it: t = (offset - n . origin) / (n . direction).
#pragma once
#include <cmath>
#include <limits>

#include "geometry/shape.h"

/// The formula of a plane, for any number of rays (see math/number.h).
namespace plane {

/// Finds t = (offset - n . origin) / (n . direction). True where tmin < t < tmax and the ray does
/// not leave this very plane; elsewhere `t` is anything. A ray parallel to the plane never meets
/// it.
template <class Number>
MaskOf<Number> nearestRoot(const Vec3<Number>& normal, const Number& offset,
                           const Vec3<Number>& origin, const Vec3<Number>& direction,
                           const Number& tmin, const Number& tmax, const MaskOf<Number>& leaves,
                           Number& t) {
  const Number approach = dot(normal, direction);
  t = (offset - dot(normal, origin)) / approach;
  return (approach != 0) & (t > tmin) & (t < tmax) & !leaves;
}

}  // namespace plane

class Plane : public Shape {
 public:
  /// The normal is normalised first (it must not be zero); offset is the signed distance of the
  /// plane from the origin along it. The material is not owned.
  Plane(const Vec3d& normal, double offset, const Material* material)
      : Shape(material), normal_(normalize(normal)), offset_(offset) {}

  /// A unit vector.
  const Vec3d& getNormal() const { return normal_; }
  /// The signed distance of the plane from the origin, along the unit normal.
  double getOffset() const { return offset_; }

  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override {
    double t;
    if (!nearestRoot(ray, 0, std::numeric_limits<double>::infinity(), t)) return;
    visitor.visit({t, this, getMaterial(), false, dot(normal_, ray.getDirection()) > 0});
  }

 private:
  bool nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const override {
    return plane::nearestRoot(normal_, offset_, ray.getOrigin(), ray.getDirection(), tmin, tmax,
                              ray.leaves(this), t);
  }
  Vec3d normalAt(const Vec3d& /*point*/) const override { return normal_; }
  double extent() const override { return std::fabs(offset_); }

  Vec3d normal_;
  double offset_;
};
