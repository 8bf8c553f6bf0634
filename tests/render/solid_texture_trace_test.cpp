// Surfaces of solid textures as the ray tracer sees them: at every point the mean, by weight, of
// the same scene in each plain material.
#include <cmath>

#include "random.h"
#include "scene_text.h"
#include "shading/solid_texture.h"
#include "vectors.h"

using scene_text::parse;

namespace {

/// A wall z = 0 of material `index` with a ball before it and one behind it. Materials: 0 matt, 1 a
/// mirror, 2 glass, 3 a checkerboard of 1 and 2, 4 noise of 0 and 1, 5 noise of 4 and 2, 6 marble
/// of 3 and 5, 7 wood of 6 and 1.
SceneParser wallOf(int index) {
  return parse(R"(
    Background { color 0.2 0.3 0.4 ambientLight 0.3 0.2 0.1 }
    Lights { numLights 2
      PointLight { position 3 5 4 color 0.9 0.8 0.7 attenuation 1 0.1 0 }
      DirectionalLight { direction -1 -2 -1 color 0.3 0.4 0.5 } }
    Materials { numMaterials 8
      Material { diffuseColor 0.9 0.2 0.1 specularColor 1 1 1 exponent 9 }
      Material { diffuseColor 0.1 0.1 0.3 reflectiveColor 0.8 0.7 0.6 }
      Material { diffuseColor 0.0 0.1 0.0 transparentColor 0.7 0.8 0.9 indexOfRefraction 1.4 }
      Checkerboard { Transform { Translate 0 0 0.5 UniformScale 3 }
                     materialIndex 1 materialIndex 2 }
      Noise { Transform { UniformScale 2 } materialIndex 0 materialIndex 1 octaves 3 }
      Noise { materialIndex 4 materialIndex 2 octaves 2 }
      Marble { materialIndex 3 materialIndex 5 octaves 4 frequency 5 amplitude 3 }
      Wood { materialIndex 6 materialIndex 1 octaves 2 frequency 9 amplitude 1 } }
    Group { numObjects 3
      MaterialIndex )" +
               std::to_string(index) + R"( Transform { Translate 0 0 -1 XRotate 10
        Translate 0 0 1 Plane { normal 0 0 1 offset 0 } }
      MaterialIndex 0 Sphere { center 0 0 2 radius 0.3 } Sphere { center 0 0 -3 radius 1 } })");
}

/// The options that need all rays, however faint.
RenderOptions withoutLimit() {
  RenderOptions options = scene_text::bouncing(3);
  options.minWeight = 0;
  return options;
}

/// A wall of two plain materials, half of each at the origin, under a lamp beside the eye.
SceneParser halfAndHalf(const std::string& first, const std::string& second) {
  return parse(
      "Background { color 1 1 1 ambientLight 0.5 0.5 0.5 }"
      "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 1 1 1 } }"
      "Materials { numMaterials 3 Material { " +
      first + " } Material { " + second +
      " } Noise { materialIndex 0 materialIndex 1 octaves 4 } }"
      "Group { numObjects 1 MaterialIndex 2 Plane { normal 0 0 1 offset 0 } }");
}

/// What an eye at (0, 0, 5) sees at the origin.
Vec3f colorAtOrigin(const SceneParser& scene, const RenderOptions& options) {
  return scene_text::colorTowards(scene, {0, 0, 5}, {0, 0, 0}, options);
}

}  // namespace

TEST("a texture's colour is the mean of the colours in each plain material, by weight") {
  Random random(921);
  check::Cases cases;
  int mixed = 0, three = 0;
  const SceneParser plain[] = {wallOf(0), wallOf(1), wallOf(2)};
  for (int index = 3; index < 8; ++index) {
    const SceneParser textured = wallOf(index);
    for (int i = 0; i < 200; ++i) {
      const Vec3d eye(0, 0.2, 5), target = random.inCube(-1.2, 1.2);
      Hit hit;
      const Ray ray(eye, normalize(target - eye));
      if (!textured.getGroup()->intersect(ray, hit, 0) || !hit.getMaterial()->asTexture()) continue;
      Vec3d expected;
      const auto parts = hit.getMaterial()->asTexture()->materialsAt(hit.getIntersectionPoint());
      for (const WeightedMaterial& part : parts) {
        int kind = 0;
        while (textured.getMaterial(kind) != part.material) ++kind;
        expected +=
            part.weight * Vec3d(scene_text::colorTowards(plain[kind], eye, target, withoutLimit()));
      }
      mixed += parts.size() > 1;
      three += parts.size() > 2;
      const Vec3f found = scene_text::colorTowards(textured, eye, target, withoutLimit());
      cases.expect(maxAbs(Vec3d(found) - expected) < 1e-6, [&] {
        return check::show(index) + " at " + check::show(target) + ": " + check::show(found) +
               " and " + check::show(expected);
      });
    }
  }
  CHECK_EQUAL(cases.firstFailure(), "");
  CHECK(cases.tried() > 700 && mixed > 400 && three > 100);
}

TEST("a checkerboard's cell has the very bits of its material") {
  Random random(922);
  const SceneParser board = wallOf(3), mirror = wallOf(1), glass = wallOf(2);
  int count[2] = {0, 0};
  for (int i = 0; i < 300; ++i) {
    const Vec3d eye(0, 0.2, 5), target = random.inCube(-1, 1);
    Hit hit;
    board.getGroup()->intersect(Ray(eye, normalize(target - eye)), hit, 0);
    if (hit.getMaterial() != board.getMaterial(3)) continue;
    const auto parts = hit.getMaterial()->asTexture()->materialsAt(hit.getIntersectionPoint());
    const bool isGlass = parts[0].material == board.getMaterial(2);
    ++count[isGlass];
    const RenderOptions options = scene_text::bouncing(3);
    CHECK_EQUAL(scene_text::colorTowards(board, eye, target, options),
                scene_text::colorTowards(isGlass ? glass : mirror, eye, target, options));
  }
  CHECK(count[0] > 50 && count[1] > 50);
}

TEST("ambient light meets each part's own diffuse colour, and so do lamps") {
  // Half of (1, 0.5, 0) and half of (0, 0.25, 1), times ambient 0.5 and the lamp's 1 head-on.
  const SceneParser scene = halfAndHalf("diffuseColor 1 0.5 0", "diffuseColor 0 0.25 1");
  CHECK_NEAR_VECTOR(colorAtOrigin(scene, {}), Vec3d(0.5, 0.375, 0.5) * 1.5, 1e-6);
}

TEST("each part's mirror ray counts by its weight, which -weight looks at") {
  // A mirror of (0.5, 0.5, 0.5) has length 0.866; half of it weighs 0.433. It shows the white sky.
  const SceneParser scene =
      halfAndHalf("diffuseColor 0 0 0 reflectiveColor 0.5 0.5 0.5", "diffuseColor 0 0 0");
  RenderOptions options = scene_text::bouncing(1);
  options.minWeight = 0.43f;
  CHECK_NEAR_VECTOR(colorAtOrigin(scene, options), Vec3d(0.25, 0.25, 0.25), 1e-6);
  options.minWeight = 0.44f;
  CHECK_NEAR_VECTOR(colorAtOrigin(scene, options), Vec3d(), 0);
}

TEST("textures lie still in the world, however their object was moved there") {
  const SceneParser scene = parse(
      "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 1 1 1 } }"
      "Materials { numMaterials 3 Material { } Material { diffuseColor 0 0 0 }"
      "Checkerboard { materialIndex 0 materialIndex 1 } }"
      "Group { numObjects 1 MaterialIndex 2 Transform { Translate 0.75 0.5 0.5 ZRotate 30 "
      "UniformScale 3 Plane { normal 0 0 1 offset 0 } } }");
  for (int x = -4; x < 4; ++x) {
    const float expected = x % 2 == 0 ? 1 : 0;
    const Vec3d target(x + 0.1, 0.5, 0.5);
    CHECK_EQUAL(scene_text::colorTowards(scene, {0, 0.5, 5}, target).r(), expected);
  }
}

TEST("facing mirrors of textures end with the bounces, deep down as well") {
  const SceneParser scene = parse(
      "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 0 0 0 } }"
      "Background { color 0 0 0 ambientLight 1 1 1 }"
      "Materials { numMaterials 2 Material { diffuseColor 0.125 0 0 reflectiveColor 1 1 1 }"
      "Noise { materialIndex 0 materialIndex 0 octaves 1 } }"
      "Group { numObjects 2 MaterialIndex 1 Plane { normal 0 0 1 offset -1 }"
      "Plane { normal 0 0 -1 offset -9 } }");
  // Every mirror adds its 0.125, 8 bounces and the first surface.
  CHECK_EQUAL(colorAtOrigin(scene, scene_text::bouncing(8)).r(), 9 * 0.125f);
  CHECK_EQUAL(colorAtOrigin(scene, scene_text::bouncing(1000)).r(), 1001 * 0.125f);
}
