// Camera: the frame that both kinds share, and their rays.
//
// The frame is three unit vectors at right angles: where the camera looks, right, and true up. The
// image is a rectangle that lies across the direction, 1 along the side that is its unit:
//   orthographic  it stands at the centre, `size` times as large, and every ray starts on it and
//                 runs along the direction;
//   perspective   it stands at distance 1 before the centre, 2 tan(angle / 2) times as large, and
//                 every ray runs from the centre through it.
#include "camera/camera.h"

#include <limits>

#include "math/functions.h"

CameraFrame CameraFrame::turned(const Vec3d& direction, const Vec3d& up) {
  const Vec3d ahead = normalize(direction), right = normalize(cross(ahead, up));
  return {ahead, right, cross(right, ahead)};
}

Ray OrthographicCamera::generateRay(const Vec2d& point) const {
  return {eye_ray::origin(center_, frame_.right, frame_.up, size_, point.x(), point.y()),
          frame_.direction};
}

double OrthographicCamera::getTMin() const { return -std::numeric_limits<double>::infinity(); }

PerspectiveCamera::PerspectiveCamera(const Vec3d& center, const CameraFrame& frame, double angle)
    : Camera(center, frame), spread_(2 * math::tan(angle / 2)) {}

Ray PerspectiveCamera::generateRay(const Vec2d& point) const {
  return {center_, eye_ray::direction(frame_.direction, frame_.right, frame_.up, spread_, point.x(),
                                      point.y())};
}
