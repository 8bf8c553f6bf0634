// Pictures of the compiled scene with adaptive epsilon: the same bytes at any power of two, and
// neither acne nor light leaking where surfaces touch.
#include <set>

#include "accel/compiled_scene.h"
#include "check.h"
#include "comparison.h"
#include "image/image.h"
#include "random.h"
#include "render/renderer.h"
#include "scene_text.h"

using scene_text::word;

namespace {

RenderOptions adaptive() {
  RenderOptions options;
  options.epsilon = {Epsilon::Kind::adaptive, 0};
  return options;
}

/// A cube of twelve triangles with its lower corner at `low`, in sizes of `s`.
std::string cube(const Vec3d& low, double side, double s) {
  std::string text;
  const int faces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                            {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  for (const auto& face : faces) {
    text += " Triangle {";
    for (int k = 0; k < 3; ++k) {
      const int c = face[k];
      const Vec3d corner(c & 1 ? side : 0, c & 2 ? side : 0, c & 4 ? side : 0);
      text += " vertex" + std::to_string(k) + word((low + corner) * s);
    }
    text += " }";
  }
  return text;
}

/// Mirrors, glass and cubes on a floor, everything multiplied by s.
std::string stillLife(double s) {
  std::string text =
      "PerspectiveCamera { center" + word(Vec3d(1, 3, 8) * s) +
      "direction -0.1 -0.3 -1 up 0 1 0 angle 40 }"
      "Lights { numLights 2 DirectionalLight { direction -1 -2 -1 color 0.5 0.5 0.5 } PointLight { "
      "position" +
      word(Vec3d(3, 5, 2) * s) +
      "color 0.5 0.5 0.5 } }"
      "Background { color 0.2 0.4 0.6 ambientLight 0.1 0.1 0.1 }"
      "Materials { numMaterials 3 PhongMaterial { diffuseColor 0.7 0.6 0.5 reflectiveColor 0.3 0.3 "
      "0.3 } PhongMaterial { diffuseColor 0.2 0.2 0.2 reflectiveColor 0.8 0.8 0.8 } PhongMaterial "
      "{ diffuseColor 0.1 0.1 0.1 transparentColor 0.9 0.9 0.8 indexOfRefraction 1.5 } }"
      "Group { numObjects 32 MaterialIndex 0 Plane { normal 0 1 0 offset 0 } MaterialIndex 1";
  Random random(51);
  for (int i = 0; i < 12; ++i) {
    const double radius = random.uniform(0.1, 0.6);
    const Vec3d center{random.uniform(-3, 3), radius, random.uniform(-3, 3)};
    text += std::string(i == 6 ? " MaterialIndex 2" : "") + " Sphere { center" + word(center * s) +
            "radius" + word(radius * s) + "}";
  }
  text += " MaterialIndex 0" + cube({-1, 0, 1}, 0.75, s) + " Transform { Translate" +
          word(Vec3d(1, 0, 2) * s) + "YRotate 30 Sphere { center 0 0 0 radius" + word(0.25 * s) +
          "} }";
  for (int i = 0; i < 6; ++i) {
    text +=
        " Sphere { center" + word(Vec3d(i - 3, 0.125, 4) * s) + "radius" + word(0.125 * s) + "}";
  }
  return text + " }";
}

/// All bytes of the picture, 64 pixels a side.
std::string picture(const SceneParser& scene, const Object3D& geometry) {
  Image image(64, 64);
  RenderTargets targets;
  targets.color = &image;
  render(RayTracer(scene, geometry, adaptive()), 2, targets);
  std::string bytes;
  for (int j = 0; j < 64; ++j) {
    for (int i = 0; i < 64; ++i) {
      const Rgb8 pixel = image.getPixel(i, j);
      for (const int byte : {int(pixel.r), int(pixel.g), int(pixel.b)}) bytes += char(byte);
    }
  }
  return bytes;
}

/// A floor, a lamp straight above, and `object`; the camera is not used.
SceneParser onFloor(const std::string& object, double s, const std::string& floorMaterial) {
  return scene_text::parse(
      "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 1 1 } }"
      "Background { color 0 0 1 ambientLight 0 0 0 }"
      "Materials { numMaterials 2 PhongMaterial { " +
      floorMaterial +
      " } PhongMaterial { diffuseColor 1 0 0 } }"
      "Group { numObjects 18 MaterialIndex 0 Plane { normal 0 1 0 offset" +
      word(0.3 * s) + "} MaterialIndex 1" + object +
      // Others, out of the way, so that there is a tree.
      cube({50, 50, 50}, 1, s) + " Sphere { center" + word(Vec3d(60, 9, 9) * s) + "radius" +
      word(s) + "} Sphere { center" + word(Vec3d(70, 9, 9) * s) + "radius" + word(s) +
      "} Sphere { center" + word(Vec3d(80, 9, 9) * s) + "radius" + word(s) + "} Sphere { center" +
      word(Vec3d(90, 9, 9) * s) + "radius" + word(s) + "} }");
}

Vec3f colorAt(const SceneParser& scene, const Object3D& geometry, const Vec3d& from,
              const Vec3d& to) {
  const RayTracer tracer(scene, geometry, adaptive());
  Ray ray(from, normalize(to - from));
  Hit hit;
  return tracer.traceRay(ray, 0, 0, 1, 1, hit);
}

}  // namespace

TEST("a scene times any power of two from -20 to 20 has the same picture with adaptive epsilon") {
  const SceneParser scene = scene_text::parseWhole(stillLife(1));
  const std::string expected = picture(scene, *scene.getGroup());
  CHECK(std::set<char>(expected.begin(), expected.end()).size() > 50);
  for (int k = -20; k <= 20; ++k) {
    const SceneParser scaled = scene_text::parseWhole(stillLife(std::ldexp(1.0, k)));
    for (const SimdLevel level : accel_test::levels()) {
      if (k % 5 != 0 && level != accel_test::levels().back()) continue;
      const CompiledScene compiled(*scaled.getGroup(), 2, level);
      CHECK(picture(scaled, compiled) == expected);
    }
  }
}

TEST("the shadow of a ball begins where it rests on the floor, and its mirror image there too") {
  for (const double s : {1e-6, 1.0, 1e6}) {
    // The ball of radius 1 touches the floor (y = 0.3) at x = 0, z = 0. Seen from the side, a
    // floor point at distance x < 1 lies below the ball: no light from above gets there.
    const std::string ball =
        " Sphere { center" + word(Vec3d(0, 1.3, 0) * s) + "radius" + word(s) + "}";
    const SceneParser dark = onFloor(ball, s, "diffuseColor 1 1 1");
    const CompiledScene compiled(*dark.getGroup(), 2);
    Random random(52);
    check::Cases cases;
    for (int i = 0; i < 2000; ++i) {
      // Nearer than 3e-4 the gap, x^2 / 2 high, is below what may be passed over.
      const double x = i % 2 ? random.uniform(0, 1) : random.logUniform(3e-4, 1);
      const double angle = random.uniform(0, 6.28);
      const Vec3d way(math::cos(angle), 0, math::sin(angle));
      const Vec3d to = (way * x + Vec3d(0, 0.3, 0)) * s, from = to + (way * 5 + Vec3d(0, x, 0)) * s;
      const Vec3f color = colorAt(dark, compiled, from, to);
      cases.expect(color == Vec3f(), [&] { return check::show(x) + ": " + check::show(color); });
      const Vec3d lit = to + way * ((1.001 - x + random.uniform(0, 3)) * s);
      const Vec3f light = colorAt(dark, compiled, lit + (way + Vec3d(0, 1, 0)) * s, lit);
      cases.expect(light == Vec3f(1, 1, 1), [&] { return "lit: " + check::show(light); });
    }
    CHECK_EQUAL(cases.firstFailure(), "");
  }
}

TEST("a cube that stands on the floor lets no light under it and none into it") {
  for (const double s : {1e-6, 1.0, 1e6}) {
    const std::string block = cube({-1, 0.3, -1}, 2, s);
    const SceneParser scene =
        onFloor(std::string(" Group { numObjects 12") + block + "}", s, "diffuseColor 1 1 1");
    const CompiledScene compiled(*scene.getGroup(), 2);
    Random random(53);
    check::Cases cases;
    for (int i = 0; i < 2000; ++i) {
      // Inside the cube, also at its diagonals and next to its walls, everything is black; the
      // walls, lit from outside, show their dark side.
      const double x = i % 3 ? random.uniform(-1, 1) : 1 - random.logUniform(1e-6, 1);
      const double z = i % 2 ? x : random.uniform(-1, 1);
      const Vec3d inside = Vec3d{random.uniform(-0.9, 0.9), 1, random.uniform(-0.9, 0.9)} * s;
      const Vec3f color = colorAt(scene, compiled, inside, Vec3d(x, 0.3, z) * s);
      cases.expect(color == Vec3f(), [&] { return check::show(color) + " inside"; });
      // The top is lit everywhere: red, without acne.
      const Vec3d top = Vec3d(x, 2.3, z) * s;
      const Vec3f lit = colorAt(scene, compiled, top + Vec3d(0.3, 3, 0.1) * s, top);
      cases.expect(lit == Vec3f(1, 0, 0), [&] { return check::show(lit) + " on top"; });
    }
    CHECK_EQUAL(cases.firstFailure(), "");
  }
}

TEST("a mirror floor shows the ball that rests on it right up to where they touch") {
  for (const double s : {1e-6, 1.0, 1e6}) {
    const std::string ball =
        " Sphere { center" + word(Vec3d(0, 1.3, 0) * s) + "radius" + word(s) + "}";
    const SceneParser scene = onFloor(ball, s, "diffuseColor 0 0 0 reflectiveColor 1 1 1");
    const CompiledScene compiled(*scene.getGroup(), 2);
    Random random(54);
    check::Cases cases;
    for (int i = 0; i < 1000; ++i) {
      // The ray goes towards the axis, so its mirror ray meets the lower side of the ball, which
      // no light reaches: black. Had it slipped through, it would show the blue background.
      const double x = random.logUniform(1e-3, 0.5);
      const Vec3d to = Vec3d(x, 0.3, 0) * s, from = to + Vec3d(1, x, 0) * s;
      const Vec3f color = colorAt(scene, compiled, from, to);
      if (compiled.occluded(Ray(from, normalize(to - from)), 0, length(to - from) * 0.999))
        continue;
      cases.expect(color == Vec3f(), [&] { return check::show(x) + ": " + check::show(color); });
    }
    CHECK(cases.tried() > 900);
    CHECK_EQUAL(cases.firstFailure(), "");
  }
}
