// Hit: the nearest surface found so far along a ray.
// getT() is also the upper bound of the search: intersect() only reports what lies nearer.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/ray.h"

class Material;

class Hit {
 public:
  /// Nothing found yet, and everything is near enough.
  Hit() {}  // were it defaulted, Hit() would first clear all bytes, slowly
  /// Nothing found yet; only surfaces with t < tmax count.
  explicit Hit(double tmax) : t_(tmax) {}
  Hit(double t, const Material* material, const Vec3d& normal)
      : t_(t), material_(material), normal_(normal) {}

  double getT() const { return t_; }
  /// Null until something is hit. Not owned.
  const Material* getMaterial() const { return material_; }
  /// The unit normal, in world space once intersect() has returned to the top; its side is the
  /// surface's own, whichever side the ray came from.
  const Vec3d& getNormal() const { return normal_; }
  const Vec3d& getIntersectionPoint() const { return point_; }
  /// The primitive that was hit, and which triangle of it where it is a mesh. Not owned.
  const Object3D* getObject() const { return object_; }
  std::uint32_t getPart() const { return part_; }
  /// The largest number that took part in finding the point, counted in units of t: rounding
  /// errors are proportional to it.
  double getMagnitude() const { return magnitude_; }

  /// Records a surface of `material` with unit normal `normal` at parameter t of `ray`.
  void set(double t, const Material* material, const Vec3d& normal, const Ray& ray) {
    t_ = t;
    material_ = material;
    normal_ = normal;
    point_ = ray.pointAtParameter(t);
  }
  /// Says which primitive it is, after set(). `extent` is the largest number that describes the
  /// primitive (a coordinate, a radius, an offset), in the space of `ray`.
  void setPrimitive(const Object3D* object, std::uint32_t part, const Ray& ray, double extent) {
    object_ = object;
    part_ = part;
    const double largest = std::max({extent, maxAbs(ray.getOrigin()), maxAbs(point_)});
    magnitude_ = std::max(std::fabs(t_), largest / length(ray.getDirection()));
  }
  /// Records a hit that has been computed elsewhere, exactly as set and setPrimitive would.
  void restore(double t, const Material* material, const Vec3d& normal, const Vec3d& point,
               const Object3D* object, std::uint32_t part, double magnitude) {
    t_ = t;
    material_ = material;
    normal_ = normal;
    point_ = point;
    object_ = object;
    part_ = part;
    magnitude_ = magnitude;
  }
  /// The same hit of a surface of another material.
  Hit withMaterial(const Material* material) const {
    Hit hit = *this;
    hit.material_ = material;
    return hit;
  }
  /// Restates the hit in the space of `ray`, where its unit normal is `normal`.
  void moveTo(const Ray& ray, const Vec3d& normal, double magnitude) {
    set(t_, material_, normal, ray);
    if (magnitude > magnitude_) magnitude_ = magnitude;
  }

 private:
  double t_ = std::numeric_limits<double>::infinity();
  const Material* material_ = nullptr;
  Vec3d normal_;
  Vec3d point_;
  const Object3D* object_ = nullptr;
  std::uint32_t part_ = 0;
  double magnitude_ = 0;
};
