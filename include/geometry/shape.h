// Shape: an object of one surface and one material, such as a sphere, a plane or a triangle. What
// kind it is decides in one function whether and at which t a ray meets it; all else that is asked
// of it follows from that.
#pragma once
#include "geometry/object3d.h"

class Shape : public Object3D {
 public:
  const Material* getMaterial() const { return material_; }

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override {
    double t;
    if (!nearestRoot(ray, tmin, hit.getT(), t)) return false;
    const Vec3d point = ray.pointAtParameter(t);
    hit.record(t, material_, normalAt(point), point,
               {this, 0, magnitudeOf(t, point, ray, extent())});
    return true;
  }
  bool occluded(const Ray& ray, double tmin, double tmax) const override {
    double t;
    return nearestRoot(ray, tmin, tmax, t);
  }

 protected:
  /// The material is not owned.
  explicit Shape(const Material* material) : material_(material) {}

  /// Finds the least t with tmin < t < tmax at which the ray meets the shape; where it leaves the
  /// shape, only another place of it counts. Where the result is false, `t` is anything.
  virtual bool nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const = 0;
  /// The unit normal at a point of the surface.
  virtual Vec3d normalAt(const Vec3d& point) const = 0;
  /// The largest number that describes the shape, see magnitudeOf.
  virtual double extent() const = 0;

 private:
  const Material* material_;
};
