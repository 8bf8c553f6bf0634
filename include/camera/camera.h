// Camera: turns a place on the image into a ray in world space with a unit direction.
#pragma once
#include "geometry/ray.h"
#include "math/vec3.h"

/// The formulas of an eye ray through (x, y), for any number of rays (see math/number.h).
namespace eye_ray {

/// Its direction in a perspective picture. `spread` is the length of the image's longer side at
/// distance 1.
template <class Number>
Vec3<Number> direction(const Vec3<Number>& ahead, const Vec3<Number>& right, const Vec3<Number>& up,
                       const Number& spread, const Number& x, const Number& y) {
  return normalize(ahead + (right * x + up * y) * spread);
}

/// Its origin in an orthographic picture. `size` is the length of the image's longer side.
template <class Number>
Vec3<Number> origin(const Vec3<Number>& center, const Vec3<Number>& right, const Vec3<Number>& up,
                    const Number& size, const Number& x, const Number& y) {
  return center + (right * x + up * y) * size;
}

}  // namespace eye_ray

class Camera {
 public:
  virtual ~Camera() = default;

  /// The ray through image point (x, y), in world space, its direction a unit vector, leaving no
  /// surface. Both run over [-0.5, 0.5] along the longer side of the image, x to the right and y
  /// up; points beyond (of a filter wider than a pixel) are as good.
  virtual Ray generateRay(const Vec2d& point) const = 0;

  /// The least t at which the camera sees, in units of the world: surfaces nearer are not there.
  virtual double getTMin() const = 0;

  const Vec3d& getCenter() const { return center_; }
  /// A unit vector.
  const Vec3d& getDirection() const { return direction_; }
  /// Unit vectors across the direction, at right angles to each other.
  const Vec3d& getRight() const { return right_; }
  const Vec3d& getUp() const { return up_; }

 protected:
  /// `up` need not be perpendicular to `direction`, but must not be parallel to it; neither may be
  /// zero. The frame is direction d normalised, right = normalize(d x up), true up = right x d.
  Camera(const Vec3d& center, const Vec3d& direction, const Vec3d& up);

  Vec3d center_, direction_, right_, up_;
};

/// Parallel rays; sees behind its centre too.
class OrthographicCamera : public Camera {
 public:
  /// `size` > 0 is the length in the world of the longer side of the image.
  OrthographicCamera(const Vec3d& center, const Vec3d& direction, const Vec3d& up, double size)
      : Camera(center, direction, up), size_(size) {}

  Ray generateRay(const Vec2d& point) const override;
  /// -infinity.
  double getTMin() const override;
  /// The length in the world of the longer side of the image.
  double getSize() const { return size_; }

 private:
  double size_;
};

/// Rays from one point.
class PerspectiveCamera : public Camera {
 public:
  /// `angle` is the opening angle along the longer side of the image, in radians, 0 < angle < pi.
  PerspectiveCamera(const Vec3d& center, const Vec3d& direction, const Vec3d& up, double angle);

  Ray generateRay(const Vec2d& point) const override;
  double getTMin() const override { return 0; }
  /// 2 tan(angle / 2): the length of the image's longer side at distance 1.
  double getSpread() const { return spread_; }

 private:
  double spread_;
};
