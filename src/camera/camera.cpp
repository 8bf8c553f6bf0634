// Camera: the frame that both kinds share, and their rays.
//
// The frame is three unit vectors at right angles: where the camera looks, right, and true up. The
// image is a rectangle that lies across the direction, 1 along its longer side:
//   orthographic  it stands at the centre, `size` times as large, and every ray starts on it and
//                 runs along the direction;
//   perspective   it stands at distance 1 before the centre, 2 tan(angle / 2) times as large, and
//                 every ray runs from the centre through it.
#include "camera/camera.h"

#include <limits>

#include "math/functions.h"

Camera::Camera(const Vec3d& center, const Vec3d& direction, const Vec3d& up)
    : center_(center),
      direction_(normalize(direction)),
      right_(normalize(cross(direction_, up))),
      up_(cross(right_, direction_)) {}

Ray OrthographicCamera::generateRay(const Vec2d& point) const {
  return {eye_ray::origin(center_, right_, up_, size_, point.x(), point.y()), direction_};
}

double OrthographicCamera::getTMin() const { return -std::numeric_limits<double>::infinity(); }

PerspectiveCamera::PerspectiveCamera(const Vec3d& center, const Vec3d& direction, const Vec3d& up,
                                     double angle)
    : Camera(center, direction, up), spread_(2 * math::tan(angle / 2)) {}

Ray PerspectiveCamera::generateRay(const Vec2d& point) const {
  return {center_, eye_ray::direction(direction_, right_, up_, spread_, point.x(), point.y())};
}
