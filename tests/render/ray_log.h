// RayLog: stands before the objects of a scene and notes every ray that is traced.
#pragma once
#include <vector>

#include "geometry/object3d.h"

class RayLog : public Object3D {
 public:
  /// Neither is owned. Rays that start where the last one did go on along it: they are not noted
  /// again.
  RayLog(const Object3D& object, std::vector<Ray>* rays) : object_(&object), rays_(rays) {}

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override {
    if (rays_->empty() || rays_->back().getOrigin() != ray.getOrigin() ||
        rays_->back().getDirection() != ray.getDirection()) {
      rays_->push_back(ray);
    }
    return object_->intersect(ray, hit, tmin);
  }
  bool occluded(const Ray& ray, double tmin, double tmax) const override {
    return object_->occluded(ray, tmin, tmax);
  }
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override {
    object_->visitCrossings(ray, visitor);
  }

 private:
  const Object3D* object_;
  std::vector<Ray>* rays_;
};
