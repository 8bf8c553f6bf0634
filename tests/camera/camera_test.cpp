// Cameras: frames, rays through known image points, and where they begin to see.
#include "camera/camera.h"

#include "math/functions.h"
#include "random.h"
#include "vectors.h"

TEST("a perspective camera's middle ray runs along its direction from its centre") {
  const PerspectiveCamera camera({1, 2, 3}, {0, 0, -5}, {0, 1, 0}, 1);
  const Ray ray = camera.generateRay({0, 0});
  CHECK_EQUAL(ray.getOrigin(), Vec3d(1, 2, 3));
  CHECK_EQUAL(ray.getDirection(), Vec3d(0, 0, -1));
  CHECK_EQUAL(camera.getTMin(), 0.0);
  CHECK_EQUAL(camera.getCenter(), Vec3d(1, 2, 3));
}

TEST("with 90 degrees the image's right edge lies at 45 degrees, x to the right and y up") {
  // 2 tan 45 x 0.5 = 1: direction (1, 0, -1) before normalising.
  const PerspectiveCamera camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, math::kPi / 2);
  const double h = std::sqrt(0.5), third = 1 / std::sqrt(3.0);
  CHECK_NEAR_VECTOR(camera.generateRay({0.5, 0}).getDirection(), Vec3d(h, 0, -h), 1e-15);
  CHECK_NEAR_VECTOR(camera.generateRay({0, 0.5}).getDirection(), Vec3d(0, h, -h), 1e-15);
  CHECK_NEAR_VECTOR(camera.generateRay({-0.5, -0.5}).getDirection(), Vec3d(-third, -third, -third),
                    1e-15);
}

TEST("the image's half side is the tangent of half the angle") {
  for (double degrees : {1.0, 30.0, 60.0, 120.0, 179.0}) {
    const double angle = degrees * 3.141592653589793 / 180;
    const PerspectiveCamera camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, angle);
    const Vec3d direction = camera.generateRay({0.5, 0}).getDirection();
    CHECK_NEAR(direction.x() / -direction.z() / std::tan(angle / 2), 1, 1e-13);
  }
}

TEST("up need not be perpendicular to the direction, nor either a unit vector") {
  // Direction (0, -3, -4) / 5: right = (1, 0, 0), true up = (0, 4, -3) / 5.
  const PerspectiveCamera camera({0, 0, 0}, {0, -3, -4}, {0, 7, 0}, math::kPi / 2);
  const double h = std::sqrt(0.5);
  CHECK_NEAR_VECTOR(camera.generateRay({0, 0.5}).getDirection(),
                    Vec3d(0, -0.6 + 0.8, -0.8 - 0.6) * h, 1e-15);
  CHECK_NEAR_VECTOR(camera.generateRay({0.5, 0}).getDirection(), Vec3d(1, -0.6, -0.8) * h, 1e-15);
}

TEST("an orthographic camera's rays are parallel and start size apart") {
  const OrthographicCamera camera({1, 2, 3}, {0, 0, -2}, {0, 3, 0}, 8);
  const Ray middle = camera.generateRay({0, 0}), corner = camera.generateRay({0.5, -0.25});
  CHECK_EQUAL(middle.getOrigin(), Vec3d(1, 2, 3));
  CHECK_EQUAL(middle.getDirection(), Vec3d(0, 0, -1));
  CHECK_EQUAL(corner.getOrigin(), Vec3d(1 + 4, 2 - 2, 3));
  CHECK_EQUAL(corner.getDirection(), Vec3d(0, 0, -1));
}

TEST("an orthographic camera sees behind its centre") {
  const OrthographicCamera camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1);
  CHECK_EQUAL(camera.getTMin(), -std::numeric_limits<double>::infinity());
}

TEST("an orthographic camera that looks down has its right side at d x up") {
  // d = -y, up = -z: right = d x up = (-y) x (-z) = x, true up = x x (-y) = -z.
  const OrthographicCamera camera({0, 9, 0}, {0, -1, 0}, {0, 0, -1}, 2);
  CHECK_EQUAL(camera.generateRay({0.5, 0}).getOrigin(), Vec3d(1, 9, 0));
  CHECK_EQUAL(camera.generateRay({0, 0.5}).getOrigin(), Vec3d(0, 9, -1));
}

TEST("every ray of random cameras has a unit direction and starts from nowhere") {
  Random random(81);
  check::Cases cases;
  for (int i = 0; i < 20000; ++i) {
    const PerspectiveCamera camera{random.inCube(-9, 9), random.inCube(-9, 9), random.inCube(-9, 9),
                                   random.uniform(0.01, 3.1)};
    const Ray ray = camera.generateRay({random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)});
    const bool ok = std::fabs(length(ray.getDirection()) - 1) < 4e-16 && ray.getSource() == nullptr;
    cases.expect(ok, [&] { return check::show(ray.getDirection()); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}
