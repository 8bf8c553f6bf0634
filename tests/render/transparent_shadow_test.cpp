// -transparent_shadows: light is multiplied by transparentColor^length inside each transparent
// object on its way, and once by the colour of an open one.
#include "accel/compiled_scene.h"
#include "scene_text.h"
#include "vectors.h"

using scene_text::parse;

namespace {

/// White ground y = 0 under a white sun, or a white lamp where its height is given, and glass. The
/// materials: 0 the ground, 1 glass (0.5, 0.25, 1), 2 glass (0.25, 1, 0.5), 3 opaque black.
std::string underGlass(int count, const std::string& objects, double lamp = 0) {
  const std::string light =
      lamp > 0 ? "PointLight { position 0 " + scene_text::word(lamp) + " 0 color 1 1 1 }"
               : "DirectionalLight { direction 0 -1 0 color 1 1 1 }";
  return "Lights { numLights 1 " + light +
         " }"
         "Background { color 0 0 0 ambientLight 0 0 0 }"
         "Materials { numMaterials 4 PhongMaterial { diffuseColor 1 1 1 }"
         "  PhongMaterial { diffuseColor 1 1 1 transparentColor 0.5 0.25 1 indexOfRefraction 3 }"
         "  PhongMaterial { diffuseColor 0 0 0 transparentColor 0.25 1 0.5 }"
         "  PhongMaterial { diffuseColor 0 0 0 } }"
         "Group { numObjects " +
         std::to_string(count + 1) +
         "  MaterialIndex 0 Plane { normal 0 1 0 offset 0 } MaterialIndex 1 " + objects + "}";
}

/// A cube of side 2 as an OBJ file, closed, faces outwards; `faces` of its six sides.
std::string cubeFile(int faces) {
  const char* const sides[] = {"1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"};
  std::string text;
  for (int x : {-1, 1})
    for (int y : {-1, 1})
      for (int z : {-1, 1})
        text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  for (int i = 0; i < faces; ++i) text += std::string("f ") + sides[i] + "\n";
  return scene_text::write(text, ".obj");
}

const Epsilon kCourse{Epsilon::Kind::fixed, Epsilon::kCourse},
    kAdaptive{Epsilon::Kind::adaptive, 0};

/// The light at (x, 0, 0), seen from close by, with no secondary rays.
Vec3f lightAt(const SceneParser& scene, double x, const Epsilon& epsilon, bool tint = true) {
  RenderOptions options = scene_text::bouncing(0);
  options.transparentShadows = tint;
  options.epsilon = epsilon;
  return scene_text::colorTowards(scene, {x + 0.3, 0.4, 0.1}, {x, 0, 0}, options);
}

/// Checks the light at (x, 0, 0) for both kinds of epsilon, and through the compiled scene.
void checkLight(const std::string& text, double x, const Vec3d& expected) {
  SceneParser scene = parse(text);
  scene.findSolids();
  CHECK_NEAR_VECTOR(lightAt(scene, x, kCourse), expected, 1e-6);
  CHECK_NEAR_VECTOR(lightAt(scene, x, kAdaptive), expected, 1e-6);
  RenderOptions options = scene_text::bouncing(0);
  options.transparentShadows = true;
  const CompiledScene compiled(*scene.getGroup(), 1);
  Ray ray(Vec3d(x + 0.3, 0.4, 0.1), normalize(Vec3d(-0.3, -0.4, -0.1)));
  Hit hit;
  const Vec3f fast = RayTracer(scene, compiled, options).traceRay(ray, 0, 0, 1, 1, hit);
  CHECK_NEAR_VECTOR(fast, expected, 1e-6);
}

Vec3d glass(double length) { return {std::pow(0.5, length), std::pow(0.25, length), 1}; }
Vec3d otherGlass(double length) { return {std::pow(0.25, length), 1, std::pow(0.5, length)}; }

const char* const kBall = "Sphere { center 0 5 0 radius 1 }";

}  // namespace

TEST("a glass ball dims the light by its colour to the power of the chord") {
  checkLight(underGlass(1, kBall), 0, glass(2));
  checkLight(underGlass(1, kBall), 0.6, glass(1.6));    // half chord sqrt(1 - 0.36)
  checkLight(underGlass(1, kBall), 0.96, glass(0.56));  // sqrt(1 - 0.9216) = 0.28
  checkLight(underGlass(1, kBall), 1.01, {1, 1, 1});
}

TEST("without the option glass blocks the light") {
  const SceneParser scene = parse(underGlass(1, kBall));
  CHECK_EQUAL(lightAt(scene, 0, kCourse, false), Vec3f());
  CHECK_EQUAL(lightAt(scene, 0, kAdaptive, false), Vec3f());
  CHECK_EQUAL(lightAt(scene, 1.01, kCourse, false), Vec3f(1, 1, 1));
}

TEST("an opaque object still blocks, before, behind and inside glass") {
  for (const char* center : {"0 2 0", "0 5 0", "0 9 0"}) {
    const std::string opaque =
        std::string("MaterialIndex 3 Sphere { center ") + center + " radius 0.5 }";
    checkLight(underGlass(2, kBall + opaque), 0, {0, 0, 0});
    checkLight(underGlass(2, kBall + opaque), 0.6, glass(1.6));
  }
}

TEST("nested objects multiply each on its own") {
  const std::string inner = "MaterialIndex 2 Sphere { center 0 5 0 radius 0.5 }";
  checkLight(underGlass(2, kBall + inner), 0, glass(2) * otherGlass(1));
}

TEST("overlapping objects multiply each on its own") {
  const std::string other = "MaterialIndex 2 Sphere { center 0 6 0 radius 1 }";
  checkLight(underGlass(2, kBall + other), 0, glass(2) * otherGlass(2));
}

TEST("each of 200 sheets of a mesh in one place multiplies once") {
  // Clear glass, as a colour and as a texture of it.
  std::string sheets = "v -9 5 -9\nv 9 5 -9\nv 0 5 9\n";
  for (int i = 0; i < 200; ++i) sheets += "f 1 2 3\n";
  std::string text =
      underGlass(1, "TriangleMesh { obj_file " + scene_text::write(sheets, ".obj") + " }");
  const std::string color = "0.5 0.25 1";
  text.replace(text.find(color), color.size(), "0.99 0.98 1");
  const Vec3d left(std::pow(0.99, 200), std::pow(0.98, 200), 1);
  checkLight(text, 0.1, left);
  const std::string opaque = "PhongMaterial { diffuseColor 0 0 0 } }";
  text.replace(text.find(opaque), opaque.size(),
               "Noise { materialIndex 1 materialIndex 1 octaves 3 } }");
  text.replace(text.find("MaterialIndex 1 Tri"), 15, "MaterialIndex 3");
  checkLight(text, 0.1, left);
}

TEST("two balls of the same glass at the same place multiply twice") {
  checkLight(underGlass(2, std::string(kBall) + kBall), 0, glass(4));
}

TEST("a ball in Transforms counts its length in world units") {
  checkLight(underGlass(1,
                        "Transform { Translate 0 9 0 Scale 2 3 2 ZRotate 90"
                        "  Sphere { center 0 0 0 radius 1 } }"),
             0, glass(6));
  checkLight(underGlass(1,
                        "Transform { Translate 0 9 0 Scale 1 -2 1"
                        "  Sphere { center 0 0 0 radius 1 } }"),
             0.6, glass(3.2));
}

TEST("lengths inside are in world units under Transforms within Transforms") {
  const auto inside = [](const std::string& object) {
    return underGlass(
        1, "Transform { Translate 0 9 0 Scale 1 3 1 Transform { ZRotate 45 " + object + " } }");
  };
  // An ellipse of half axes 2 and 1, cut at 45 degrees to both: t^2 (1/8 + 1/2) = 1 on either side
  // of its centre, and the vertical is tripled.
  const std::string ball = "Transform { Scale 2 1 1 Sphere { center 0 0 0 radius 1 } }";
  checkLight(inside(ball), 0, glass(6 * std::sqrt(1.6)));
  // A square of side 2 from corner to corner.
  const std::string mesh = scene_text::mesh(cubeFile(6));
  checkLight(inside(mesh), 0, glass(6 * std::sqrt(2.0)));
  checkLight(inside("Transform { Scale 1 1 5 Group { numObjects 1 " + mesh + " } }"), 0.25,
             glass(3 * (2 * std::sqrt(2.0) - 0.5)));  // |x| + |y| = sqrt(2) around the corner
}

TEST("a ball inside a closed mesh that overlaps another ball: each multiplies on its own") {
  const std::string mesh = scene_text::mesh(cubeFile(6));
  const std::string objects = "Transform { Translate 0 5 0 Scale 1 2 1 " + mesh +
                              " } MaterialIndex 2 Sphere { center 0 4.5 0 radius 0.5 }"
                              "  Sphere { center 0 7 0 radius 1 }";
  checkLight(underGlass(3, objects), 0, glass(4) * otherGlass(1) * otherGlass(2));
}

TEST("a closed mesh dims by length, also where the light goes through its edges") {
  const std::string mesh = scene_text::mesh(cubeFile(6));
  const std::string raised = "Transform { Translate 0 5 0 " + mesh + " }";
  checkLight(underGlass(1, raised), 0, glass(2));  // through the diagonals of both sides
  checkLight(underGlass(1, raised), 0.3, glass(2));
  checkLight(underGlass(1, raised), 1.01, {1, 1, 1});
  // On its corner: the light runs from corner to corner, sqrt(12) long.
  checkLight(underGlass(1, "Transform { Translate 0 5 0 ZRotate 54.735610317245346 YRotate 45 " +
                               mesh + " }"),
             0, glass(std::sqrt(12.0)));
}

TEST("a mesh that is not closed multiplies once for every face that the light crosses") {
  const std::string mesh = scene_text::mesh(cubeFile(5));
  const std::string raised = "Transform { Translate 0 5 0 " + mesh + " }";
  checkLight(underGlass(1, raised), 0.3, glass(2));  // two faces, by chance as for a length of 2
  checkLight(underGlass(1, "Transform { Translate 0 5 0 Scale 1 3 1 " + mesh + " }"), 0.3,
             glass(2));
}

TEST("an open triangle and a plane multiply once") {
  const std::string triangle = "Triangle { vertex0 -5 3 -5 vertex1 5 3 -5 vertex2 0 3 9 }";
  checkLight(underGlass(1, triangle), 0, glass(1));
  checkLight(underGlass(2, triangle + "MaterialIndex 2 Plane { normal 1 1 0 offset 8 }"), 0,
             glass(1) * otherGlass(1));
}

TEST("a lamp inside a glass ball shines through what lies before it") {
  checkLight(underGlass(1, kBall, 5), 0, glass(1));
  checkLight(underGlass(1, kBall, 5.5), 0, glass(1.5));
  checkLight(underGlass(1, kBall, 3.9), 0, {1, 1, 1});
  checkLight(underGlass(1, kBall, 6.1), 0, glass(2));
  const std::string mesh = scene_text::mesh(cubeFile(6));
  checkLight(underGlass(1, "Transform { Translate 0 5 0 " + mesh + " }", 5.25), 0, glass(1.25));
}

TEST("ground inside a glass ball has the stretch up to its surface") {
  checkLight(underGlass(1, "Sphere { center 0 0 0 radius 2 }"), 0, glass(2));
  checkLight(underGlass(1, "Sphere { center 0 0 0 radius 2 }"), 1.2, glass(1.6));
}

TEST("the glass's own surface is lit without any stretch on its outside") {
  SceneParser scene = parse(underGlass(1, kBall));
  RenderOptions options = scene_text::bouncing(0);
  options.transparentShadows = true;
  for (const Epsilon& epsilon : {kCourse, kAdaptive}) {
    options.epsilon = epsilon;
    const Vec3f top = scene_text::colorTowards(scene, {0, 9, 0}, {0, 5, 0}, options);
    CHECK_NEAR_VECTOR(top, Vec3d(1, 1, 1), 1e-6);
    // At normal (0.6, 0.8, 0), seen along it.
    const Vec3f slope = scene_text::colorTowards(scene, {3, 9, 0}, {0, 5, 0}, options);
    CHECK_NEAR_VECTOR(slope, Vec3d(0.8, 0.8, 0.8), 1e-6);
  }
}

TEST("glass that lets nothing of a colour through is lit in that colour on its outside") {
  // Rounding puts the surface that a shadow ray leaves before or behind its start: no power of a
  // length of 1e-17 may darken it, with one material or a texture of two.
  for (const char* index : {"0", "1"}) {
    const SceneParser scene = parse(
        "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 1 1 } }"
        "Background { color 0 0 0 ambientLight 0 0 0 }"
        "Materials { numMaterials 2 PhongMaterial { transparentColor 1 0 0 }"
        "  Checkerboard { materialIndex 0 materialIndex 0 } }"
        "Group { numObjects 1 MaterialIndex " +
        std::string(index) + "  Sphere { center 0.1 0.2 0.3 radius 1.1 } }");
    RenderOptions options = scene_text::bouncing(0);
    options.transparentShadows = true;
    for (int k = 0; k < 200; ++k) {
      options.epsilon = k % 2 == 0 ? kCourse : kAdaptive;
      const Vec3d normal = normalize(Vec3d(std::cos(k), 0.1 + k % 7, std::sin(k)));
      const Vec3d middle(0.1, 0.2, 0.3);
      const Vec3f found = scene_text::colorTowards(scene, middle + normal * 4, middle, options);
      CHECK_NEAR_VECTOR(found, Vec3d(1, 1, 1) * normal.y(), 1e-6);
    }
  }
}

TEST("the glass's own inside is lit through the stretch above it") {
  SceneParser scene = parse(underGlass(1, kBall));
  RenderOptions options = scene_text::bouncing(0);
  options.transparentShadows = options.shadeBack = true;
  for (const Epsilon& epsilon : {kCourse, kAdaptive}) {
    options.epsilon = epsilon;
    const Vec3f bottom = scene_text::colorTowards(scene, {0, 5, 0}, {0, 4, 0}, options);
    CHECK_NEAR_VECTOR(bottom, glass(2), 1e-6);
    // At (0.6, 4.2, 0): the normal turned inwards is (-0.6, 0.8, 0), the chord above it 1.6.
    const Vec3f slope = scene_text::colorTowards(scene, {0, 5, 0}, {0.6, 4.2, 0}, options);
    CHECK_NEAR_VECTOR(slope, glass(1.6) * 0.8, 1e-6);
  }
}

TEST("only opaque objects before the lamp block it, whatever stands behind") {
  const std::string far = "MaterialIndex 3 Sphere { center 0 9 0 radius 0.5 }";
  const std::string near = "MaterialIndex 3 Sphere { center 0 2 0 radius 0.5 }";
  checkLight(underGlass(2, kBall + far, 7), 0, glass(2));
  checkLight(underGlass(3, kBall + near + far, 7), 0, {0, 0, 0});
  checkLight(underGlass(3, kBall + far + near, 7), 0, {0, 0, 0});
}

TEST("an opaque object nearer than epsilon does not block") {
  const SceneParser scene =
      parse(underGlass(1, "MaterialIndex 3 Plane { normal 0 1 0 offset 0.0005 }"));
  RenderOptions options;
  options.transparentShadows = true;
  for (double epsilon : {0.001, 0.0001}) {
    options.epsilon = {Epsilon::Kind::fixed, epsilon};
    const Vec3f found = scene_text::colorTowards(scene, {0, 0.0003, 0}, {0, 0, 0}, options);
    CHECK_EQUAL(found, epsilon > 0.0005 ? Vec3f(1, 1, 1) : Vec3f());
  }
}

TEST("a closed mesh that is inside out dims as one that is not") {
  const std::string inverted = scene_text::write(
      "v 0 -1 -1\nv 1 -1 1\nv -1 -1 1\nv 0 1 0\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", ".obj");
  const std::string upright = scene_text::write(
      "v 0 -1 -1\nv 1 -1 1\nv -1 -1 1\nv 0 1 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n", ".obj");
  for (const std::string& file : {inverted, upright}) {
    checkLight(underGlass(1, "Transform { Translate 0 5 0" + scene_text::mesh(file) + "}"), 0,
               glass(2));  // from the apex straight down to the base
  }
}
