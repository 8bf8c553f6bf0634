// Camera: turns a place on the image into a ray in world space with a unit direction.
#pragma once
#include "geometry/ray.h"
#include "math/vec3.h"

/// The formulas of an eye ray through (x, y), for any number of rays (see math/number.h).
namespace eye_ray {

/// A coordinate of it, from a place in the picture: both `place` and `middle`, which lies at 0, are
/// in pixels from the lower left corner; `unit` pixels are 1 long.
template <class Number>
Number coordinate(const Number& place, const Number& middle, const Number& unit) {
  return (place - middle) / unit;
}

/// Its direction in a perspective picture. `spread` is how long the image plane's unit is at
/// distance 1.
template <class Number>
Vec3<Number> direction(const Vec3<Number>& ahead, const Vec3<Number>& right, const Vec3<Number>& up,
                       const Number& spread, const Number& x, const Number& y) {
  return normalize(ahead + (right * x + up * y) * spread);
}

/// Its origin in an orthographic picture. `size` is how long the image plane's unit is.
template <class Number>
Vec3<Number> origin(const Vec3<Number>& center, const Vec3<Number>& right, const Vec3<Number>& up,
                    const Number& size, const Number& x, const Number& y) {
  return center + (right * x + up * y) * size;
}

}  // namespace eye_ray

/// Where a camera looks, and what is right and up in its pictures; in world space.
struct CameraFrame {
  Vec3d direction;  ///< unit
  Vec3d right, up;  ///< as a rule unit vectors at right angles to it and to each other

  /// direction d made unit, right = normalize(d x up), true up = right x d. `up` need not be
  /// perpendicular to `direction`, but must not be parallel to it; neither may be zero.
  static CameraFrame turned(const Vec3d& direction, const Vec3d& up);
};

class Camera {
 public:
  virtual ~Camera() = default;

  /// The ray through point (x, y) of the image plane, in world space, its direction a unit vector,
  /// leaving no surface. x goes to the right and y up, over [-0.5, 0.5] along the side of the image
  /// that the renderer takes for the unit, as a rule the longer one; points beyond are as good.
  virtual Ray generateRay(const Vec2d& point) const = 0;

  /// The least t at which the camera sees, in units of the world: surfaces nearer are not there.
  virtual double getTMin() const = 0;

  const Vec3d& getCenter() const { return center_; }
  /// A unit vector.
  const Vec3d& getDirection() const { return frame_.direction; }
  /// One step to the right and up on the image, see CameraFrame.
  const Vec3d& getRight() const { return frame_.right; }
  const Vec3d& getUp() const { return frame_.up; }

 protected:
  Camera(const Vec3d& center, const CameraFrame& frame) : center_(center), frame_(frame) {}

  Vec3d center_;
  CameraFrame frame_;
};

/// Parallel rays; sees behind its centre too.
class OrthographicCamera : public Camera {
 public:
  /// `size` > 0 is the length in the world of the image plane's unit. Made of direction and up as
  /// the assignment has it, or of a frame.
  OrthographicCamera(const Vec3d& center, const Vec3d& direction, const Vec3d& up, double size)
      : OrthographicCamera(center, CameraFrame::turned(direction, up), size) {}
  OrthographicCamera(const Vec3d& center, const CameraFrame& frame, double size)
      : Camera(center, frame), size_(size) {}

  Ray generateRay(const Vec2d& point) const override;
  /// -infinity.
  double getTMin() const override;
  /// The length in the world of the image plane's unit.
  double getSize() const { return size_; }

 private:
  double size_;
};

/// Rays from one point.
class PerspectiveCamera : public Camera {
 public:
  /// `angle` is the opening angle over the image plane's unit, in radians, 0 < angle < pi.
  PerspectiveCamera(const Vec3d& center, const Vec3d& direction, const Vec3d& up, double angle)
      : PerspectiveCamera(center, CameraFrame::turned(direction, up), angle) {}
  PerspectiveCamera(const Vec3d& center, const CameraFrame& frame, double angle);

  Ray generateRay(const Vec2d& point) const override;
  double getTMin() const override { return 0; }
  /// 2 tan(angle / 2): the length of the image plane's unit at distance 1.
  double getSpread() const { return spread_; }

 private:
  double spread_;
};
