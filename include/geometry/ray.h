// Ray: an origin, a direction, and the surface that it leaves, if any.
// The direction need not be a unit vector: a Transform hands its child a ray whose parameter t is
// still the world's t. Only rays made by a camera or a surface have unit directions.
#pragma once
#include <cstdint>

#include "math/matrix.h"

class Object3D;

class Ray {
 public:
  Ray() = default;
  /// The direction must not be zero; its length is the unit of t.
  Ray(const Vec3d& origin, const Vec3d& direction) : origin_(origin), direction_(direction) {}

  /// Becomes the ray from `origin` along `direction` that leaves nothing. In place: a ray that is
  /// made elsewhere and then copied makes the processor wait for its stores.
  void set(const Vec3d& origin, const Vec3d& direction) {
    origin_ = origin;
    direction_ = direction;
    source_ = nullptr;
    sourceFace_ = 0;
  }
  const Vec3d& getOrigin() const { return origin_; }
  const Vec3d& getDirection() const { return direction_; }
  /// origin + t direction: t counts lengths of the direction, and may be negative.
  Vec3d pointAtParameter(double t) const { return origin_ + direction_ * t; }

  /// Says that the ray starts on `surface`, where that is a mesh on its triangle `face`. A plane or
  /// triangle is then never hit by this ray, and a sphere only where the ray comes out on its other
  /// side: rounding in the origin cannot make a ray meet the surface it leaves.
  void setSource(const Object3D* surface, std::uint32_t face) {
    source_ = surface;
    sourceFace_ = face;
  }
  const Object3D* getSource() const { return source_; }
  std::uint32_t getSourceFace() const { return sourceFace_; }
  /// Whether the ray starts on `surface`, where that is a mesh on its triangle `face`.
  bool leaves(const Object3D* surface, std::uint32_t face = 0) const {
    return source_ == surface && sourceFace_ == face;
  }

  /// The same ray in the space to which `map` takes this one: t and source are kept.
  Ray moved(const Matrix& map) const {
    Ray ray = *this;
    ray.origin_ = map.transformPoint(origin_);
    ray.direction_ = map.transformDirection(direction_);
    return ray;
  }

 private:
  Vec3d origin_, direction_;
  const Object3D* source_ = nullptr;  // not owned
  std::uint32_t sourceFace_ = 0;
};
