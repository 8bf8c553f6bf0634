// Transform: an object seen through an affine map.
// The ray is moved into the object's space by one multiplication with this map's inverse. Its
// direction is not renormalised there, so that t means the same on both sides.
#pragma once
#include "geometry/object3d.h"

/// The magnitude (Hit::getMagnitude) of a hit at `point` of a ray, both outside of a Transform of
/// this inverse, inside of which it is `within`: the largest of the numbers on both sides of the
/// map, and inside it. For any number of rays (see math/number.h).
template <class Number>
Number outsideMagnitude(const Matrix& inverse, const Number& within, const Vec3<Number>& point,
                        const Vec3<Number>& origin, const Vec3<Number>& direction) {
  const Number outside = larger(maxAbs(origin), maxAbs(point)) / length(direction);
  const Number between = inverse.magnitudeAt(point) / length(inverse.transformDirection(direction));
  return larger(within, larger(outside, between));
}

class Transform : public Object3D {
 public:
  /// `matrix` takes the object's space to the space of this Transform and must have an inverse
  /// (asserted). The object is not owned.
  Transform(const Matrix& matrix, const Object3D* object);

  const Matrix& getMatrix() const { return matrix_; }
  const Matrix& getInverse() const { return inverse_; }
  const Object3D* getObject() const { return object_; }

  /// The ray in the object's space; t and source are kept.
  Ray toObject(const Ray& ray) const { return ray.moved(inverse_); }
  /// Restates a hit in the object's space as one in this Transform's, where the ray is `ray`.
  void toParent(const Ray& ray, Hit& hit) const;

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override {
    return object_->occluded(toObject(ray), tmin, tmax);
  }
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override {
    object_->visitCrossings(toObject(ray), visitor);
  }
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override {
    object_->addBounds(toWorld * matrix_, box);
  }
  bool isBounded() const override { return object_->isBounded(); }

 private:
  Matrix matrix_, inverse_;
  const Object3D* object_;  // not owned
};
