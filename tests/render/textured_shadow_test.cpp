// -transparent_shadows through solid textures: the colour is that of the place where light enters.
#include "scene_text.h"
#include "vectors.h"

namespace {

const Vec3d kBlue(0.5, 0.25, 1), kGreen(0.25, 1, 0.5);

/// White ground y = 0 under a white sun, or a white lamp where its height is given, and `objects`.
/// Materials: 0 the ground, 1 blue glass, 2 green glass, 3 opaque; 4 blue where x < 0 and green
/// elsewhere; 5 blue below y = 5, green above; 6 blue below, opaque above; 7 opaque below, blue
/// above; 8 noise of both glasses; 9 blue glass, written as noise.
std::string under(const std::string& objects, double lamp = 0) {
  const std::string light =
      lamp > 0 ? "PointLight { position 0 " + scene_text::word(lamp) + " 0 color 1 1 1 }"
               : "DirectionalLight { direction 0 -1 0 color 1 1 1 }";
  const auto halves = [](const char* steps, const char* first, const char* second) {
    return std::string(" Checkerboard { size 1000 Transform { ") + steps + " } materialIndex " +
           first + " materialIndex " + second + " }";
  };
  return "Lights { numLights 1 " + light +
         " } Background { color 0 0 0 ambientLight 0 0 0 } Materials { numMaterials 10"
         "  PhongMaterial { diffuseColor 1 1 1 }"
         "  PhongMaterial { transparentColor 0.5 0.25 1 }"
         "  PhongMaterial { transparentColor 0.25 1 0.5 } PhongMaterial { }" +
         halves("Scale 1 0 0", "2", "1") + halves("Scale 0 1 0 Translate 0 -5 0", "2", "1") +
         halves("Scale 0 1 0 Translate 0 -5 0", "3", "1") +
         halves("Scale 0 1 0 Translate 0 -5 0", "1", "3") +
         " Noise { materialIndex 1 materialIndex 2 octaves 3 }"
         " Noise { materialIndex 1 materialIndex 1 octaves 3 } }"
         "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 1 0 offset 0 }" +
         objects + "}";
}

std::string ball(int material) {
  return " MaterialIndex " + std::to_string(material) + " Sphere { center 0 5 0 radius 1 } ";
}

/// The light at (x, 0, 0), seen from close by, with no secondary rays.
Vec3f lightAt(const std::string& text, double x) {
  SceneParser scene = scene_text::parse(text);
  scene.findSolids();
  RenderOptions options = scene_text::bouncing(0);
  options.transparentShadows = true;
  return scene_text::colorTowards(scene, {x + 0.3, 0.4, 0.1}, {x, 0, 0}, options);
}

Vec3d through(const Vec3d& color, double length) {
  return {std::pow(color.x(), length), std::pow(color.y(), length), std::pow(color.z(), length)};
}

}  // namespace

TEST("light through a checkered ball has the colour of the cell it enters by") {
  // 0.6 from the middle the chord is 2 * 0.8.
  const std::string scene = under(ball(4));
  CHECK_NEAR_VECTOR(lightAt(scene, -0.6), through(kBlue, 1.6), 1e-6);
  CHECK_NEAR_VECTOR(lightAt(scene, 0.6), through(kGreen, 1.6), 1e-6);
  CHECK_NEAR_VECTOR(lightAt(scene, 1.1), Vec3d(1, 1, 1), 1e-6);
  // Green on top, blue below: light enters on top.
  CHECK_NEAR_VECTOR(lightAt(under(ball(5)), 0.6), through(kGreen, 1.6), 1e-6);
}

TEST("an opaque cell blocks the light on either side of the ball") {
  CHECK_EQUAL(lightAt(under(ball(6)), 0.6), Vec3f());
  CHECK_EQUAL(lightAt(under(ball(7)), 0.6), Vec3f());
}

TEST("a mixture of glasses dims by their mean colour") {
  // Half and half where the light enters, at (0, 6, 0).
  CHECK_NEAR_VECTOR(lightAt(under(ball(8)), 0), through((kBlue + kGreen) / 2, 2), 1e-6);
  CHECK_NEAR_VECTOR(lightAt(under(ball(9)), 0.6), through(kBlue, 1.6), 1e-6);
}

TEST("a lamp inside a ball takes the colour where its light leaves") {
  // One unit from the middle down to y = 4, which is blue; what stands above does not matter.
  CHECK_NEAR_VECTOR(lightAt(under(ball(5), 5), 0), through(kBlue, 1), 1e-6);
  CHECK_NEAR_VECTOR(lightAt(under(ball(6), 5), 0), through(kBlue, 1), 1e-6);
  CHECK_EQUAL(lightAt(under(ball(7), 5), 0), Vec3f());
}

TEST("where lamp and ground are in one ball the surface behind the lamp gives the colour") {
  const auto around = [](int material) {
    return " MaterialIndex " + std::to_string(material) + " Sphere { center 0 0 0 radius 20 } ";
  };
  CHECK_NEAR_VECTOR(lightAt(under(around(5), 3), 0), through(kGreen, 3), 1e-6);
  CHECK_NEAR_VECTOR(lightAt(under(around(7), 3), 0), through(kBlue, 3), 1e-6);
  // Opaque behind the lamp: a hollow ball, which dims nothing.
  CHECK_NEAR_VECTOR(lightAt(under(around(6), 3), 0), Vec3d(1, 1, 1), 1e-6);
}

TEST("an open pane tints once, each cell with its colour") {
  const std::string pane = " MaterialIndex 4 Plane { normal 0 1 0 offset 3 } ";
  CHECK_NEAR_VECTOR(lightAt(under(pane), -0.6), kBlue, 1e-6);
  CHECK_NEAR_VECTOR(lightAt(under(pane), 0.6), kGreen, 1e-6);
  const std::string dark = " MaterialIndex 7 Plane { normal 0 1 0 offset 3 } ";
  CHECK_EQUAL(lightAt(under(dark), 0.6), Vec3f());
}

TEST("a closed mesh of a texture counts each stretch with the colour where light enters it") {
  // Two slabs in one mesh, from y = 1 to 2 and from y = 6 to 8: green glass above 5, blue below.
  std::string text;
  for (const int y : {1, 2, 6, 8})
    for (const char* corner : {"-1 ", "1 "})
      for (const char* other : {" -1", " 1"})
        text += std::string("v ") + corner + std::to_string(y) + other + "\n";
  // Corners of a slab, from its lower four on: 1..4 below, 5..8 above.
  for (const int first : {0, 8}) {
    const int sides[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                             {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
    for (const auto& side : sides) {
      text += "f";
      for (const int corner : side) text += " " + std::to_string(first + corner);
      text += "\n";
    }
  }
  const std::string file = scene_text::write(text, ".obj");
  const std::string scene = under(" MaterialIndex 5 " + scene_text::mesh(file));
  CHECK_NEAR_VECTOR(lightAt(scene, 0.3), through(kGreen, 2) * through(kBlue, 1), 1e-6);
  std::remove(file.c_str());
}
