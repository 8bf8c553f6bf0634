// Sphere: a closed ball's surface. Its normal points outwards.
#pragma once
#include <algorithm>

#include "geometry/shape.h"

/// The formulas of a sphere, for any number of rays (see math/number.h).
namespace sphere {

/// Finds the roots of |origin + t direction - center| = radius as middle - half and middle + half;
/// false, and `half` anything, where the ray passes by. The discriminant is taken from the vector
/// between the centre and the ray's nearest point, which keeps its digits for a far or a huge
/// sphere. Source: Haines, Guenther and Akenine-Moeller, "Precision Improvements for Ray/Sphere
/// Intersection", Ray Tracing Gems, 2019.
template <class Number>
MaskOf<Number> roots(const Vec3<Number>& center, const Number& radius, const Vec3<Number>& origin,
                     const Vec3<Number>& direction, Number& middle, Number& half) {
  const Vec3<Number> toCenter = center - origin;
  const Number lengthSquared = dot(direction, direction);
  middle = dot(toCenter, direction) / lengthSquared;
  const Vec3<Number> beside = toCenter - direction * middle;
  const Number halfChordSquared = radius * radius - dot(beside, beside);
  const MaskOf<Number> meets = halfChordSquared >= 0;
  half = 0;
  if (any(meets)) half = squareRoot(halfChordSquared / lengthSquared);
  return meets;
}

/// Finds the least t with tmin < t < tmax at which the ray meets the sphere; `t` is anything where
/// the result is false. The one function that decides a sphere hit. `leaves` says which rays start
/// on this sphere: they meet it again only where they come out on its other side.
template <class Number>
MaskOf<Number> nearestRoot(const Vec3<Number>& center, const Number& radius,
                           const Vec3<Number>& origin, const Vec3<Number>& direction,
                           const Number& tmin, const Number& tmax, const MaskOf<Number>& leaves,
                           Number& t) {
  Number middle, half;
  const MaskOf<Number> meets = roots(center, radius, origin, direction, middle, half);
  t = middle;  // nobody reads it, but compilers cannot see that
  if (!any(meets)) return meets;
  const Number near = middle - half, far = middle + half;
  t = choose(leaves | !(near > tmin), far, near);
  return meets & !(leaves & (middle <= 0)) & (t > tmin) & (t < tmax);
}

}  // namespace sphere

class Sphere : public Shape {
 public:
  /// radius > 0, in the units of the space the sphere stands in. The material is not owned.
  Sphere(const Vec3d& center, double radius, const Material* material)
      : Shape(material), center_(center), radius_(radius) {}

  const Vec3d& getCenter() const { return center_; }
  double getRadius() const { return radius_; }

  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override;
  bool isBounded() const override { return true; }

 private:
  bool nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const override {
    return sphere::nearestRoot(center_, radius_, ray.getOrigin(), ray.getDirection(), tmin, tmax,
                               ray.leaves(this), t);
  }
  Vec3d normalAt(const Vec3d& point) const override { return normalize(point - center_); }
  double extent() const override { return std::max(maxAbs(center_), radius_); }

  Vec3d center_;
  double radius_;
};
