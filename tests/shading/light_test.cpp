// Lights: direction to the light, distance, colour and attenuation.
#include "shading/light.h"

#include <cmath>

#include "vectors.h"

namespace {

struct Illumination {
  Vec3d direction;
  Vec3f color;
  double distance = -1;

  Illumination(const Light& light, const Vec3d& point) {
    light.getIllumination(point, direction, color, distance);
  }
};

}  // namespace

TEST("a directional light comes from where its direction points away from, everywhere") {
  const DirectionalLight light({0, -5, 0}, {0.25f, 0.5f, 1});
  CHECK_EQUAL(light.getDirToLight(), Vec3d(0, 1, 0));
  CHECK_EQUAL(light.getColor(), Vec3f(0.25f, 0.5f, 1));
  for (const Vec3d& point : {Vec3d(0, 0, 0), Vec3d(1e6, -3, 2)}) {
    const Illumination here(light, point);
    CHECK_EQUAL(here.direction, Vec3d(0, 1, 0));
    CHECK_EQUAL(here.color, Vec3f(0.25f, 0.5f, 1));
    CHECK_EQUAL(here.distance, std::numeric_limits<double>::infinity());
  }
}

TEST("a slanted directional light is normalised") {
  const Illumination here(DirectionalLight({-2, -3, 6}, {1, 1, 1}), {0, 0, 0});
  CHECK_NEAR_VECTOR(here.direction, Vec3d(2, 3, -6) / 7.0, 1e-15);
}

TEST("a point light lies at its position") {
  const PointLight light({1, 2, 9}, {0.5f, 0.25f, 1}, {1, 0, 0});
  const Illumination here(light, {-1, -1, 3});  // (2, 3, 6) away: 7 units
  CHECK_NEAR_VECTOR(here.direction, Vec3d(2, 3, 6) / 7.0, 1e-15);
  CHECK_NEAR(here.distance, 7, 1e-15);
  CHECK_EQUAL(here.color, Vec3f(0.5f, 0.25f, 1));
  CHECK_EQUAL(light.getPosition(), Vec3d(1, 2, 9));
  CHECK_EQUAL(light.getAttenuation(), Vec3d(1, 0, 0));
}

TEST("a point light is dimmed by 1 / (a0 + a1 s + a2 s^2)") {
  // At s = 2: 1 / (0.5 + 0.25 x 2 + 0.75 x 4) = 1 / 4.
  const PointLight light({0, 2, 0}, {0.8f, 0.4f, 1}, {0.5, 0.25, 0.75});
  CHECK_NEAR_VECTOR(Illumination(light, {0, 0, 0}).color, Vec3d(0.2, 0.1, 0.25), 1e-8);
  // Each coefficient alone, at s = 4: 1 / 2, 1 / (4 x 0.5), 1 / (16 x 0.25).
  const Vec3f white(1, 1, 1);
  CHECK_EQUAL(Illumination(PointLight({0, 4, 0}, white, {2, 0, 0}), Vec3d()).color.r(), 0.5f);
  CHECK_EQUAL(Illumination(PointLight({0, 4, 0}, white, {0, 0.5, 0}), Vec3d()).color.r(), 0.5f);
  CHECK_EQUAL(Illumination(PointLight({0, 4, 0}, white, {0, 0, 0.25}), Vec3d()).color.r(), 0.25f);
}

TEST("at a point light's own position the direction is zero") {
  const Illumination here(PointLight({1, 2, 3}, {1, 1, 1}, {1, 0, 0}), {1, 2, 3});
  CHECK_EQUAL(here.direction, Vec3d());
  CHECK_EQUAL(here.distance, 0.0);
}

TEST("a light whose attenuation is not above 0 adds nothing, and none is more than a float holds") {
  const auto colorAt = [](const Vec3d& attenuation, double distance) {
    Vec3d direction;
    Vec3f color;
    double found = 0;
    PointLight({0, 0, 0}, {1, 0, 2}, attenuation)
        .getIllumination({distance, 0, 0}, direction, color, found);
    return color;
  };
  CHECK(colorAt({0, 0, 0}, 1) == Vec3f() && colorAt({-1, 0, 0}, 1) == Vec3f());
  CHECK(colorAt({0, 0, 1}, 0) == Vec3f());
  CHECK(colorAt({1, -1, 0}, 1) == Vec3f());
  CHECK(colorAt({1, -1, 0}, 0.5) == Vec3f(2, 0, 4));
  const Vec3f near = colorAt({0, 0, 1}, 1e-30);
  CHECK(std::isfinite(near.r()) && near.g() == 0 && std::isfinite(near.b()));
}
