// Solid textures in scene files: what is read, and every mistake with its line.
#include <algorithm>

#include "scene/scene_files.h"
#include "shading/solid_texture.h"

using scenes::mistakesIn;

namespace {

/// Materials 0, 1 and, from line 2 on, `texture` as number 2, on a ball.
std::string with(const std::string& texture, const std::string& objects = "MaterialIndex 2") {
  return "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 30 } "
         "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 1 1 } } "
         "Materials { numMaterials 3 PhongMaterial { } Material { diffuseColor 1 0 0 }\n" +
         texture + " }\nGroup { numObjects 1 " + objects + " Sphere { center 0 0 0 radius 1 } }\n";
}

/// The weight of material `index` of a scene in the texture `material` at a point.
double weightIn(const SceneParser& scene, const Material& material, int index, const Vec3d& point) {
  for (const WeightedMaterial& each : material.asTexture()->materialsAt(point)) {
    if (each.material == scene.getMaterial(index)) return each.weight;
  }
  return 0;
}

double weightOfRed(const std::string& texture, const Vec3d& point) {
  const auto scene = scenes::parse(with(texture));
  return weightIn(*scene, *scene->getMaterial(2), 1, point);
}

}  // namespace

TEST("the four textures are read, their fields in any order and in the older form") {
  CHECK_EQUAL(weightOfRed("Checkerboard { materialIndex 0 materialIndex 1 }", {1.5, 0, 0}), 1.0);
  CHECK_EQUAL(weightOfRed("Checkerboard { materialIndex 1 materialIndex 0 }", {1.5, 0, 0}), 0.0);
  CHECK_EQUAL(
      weightOfRed("Checkerboard { size 2.5 material_index 0 material_index 1 }", {1.5, 0, 0}), 0.0);
  CHECK_EQUAL(weightOfRed("Noise { octaves 3 materialIndex 0 materialIndex 1 }", {1, 2, 3}), 0.5);
  // sin(pi / 2) at x = 1, and at the radius 5.
  const std::string quarter = " frequency 1.5707963267948966 ";
  CHECK_NEAR(
      weightOfRed("Marble { materialIndex 0 amplitude 2 octaves 1 materialIndex 1" + quarter + "}",
                  {1, 7, 7}),
      1, 1e-15);
  CHECK_NEAR(
      weightOfRed("Wood { materialIndex 0 amplitude 2 octaves 1 materialIndex 1" + quarter + "}",
                  {3, 7, 4}),
      1, 1e-15);
}

TEST("the Transform of a texture takes points of the world to it, its first step last") {
  // x = 0.2 is scaled to 0.4 and moved to 1.4.
  const std::string steps = "Transform { Translate 1 0 0 UniformScale { 2 } }";
  CHECK_EQUAL(
      weightOfRed("Checkerboard { " + steps + " materialIndex 0 materialIndex 1 }", {0.2, 0, 0}),
      1.0);
  CHECK_EQUAL(
      weightOfRed("Checkerboard { materialIndex 0 " + steps + " materialIndex 1 }", {0.6, 0, 0}),
      0.0);
  // A singular one is no mistake: y is forgotten.
  const std::string flat =
      "Checkerboard { Transform { Scale 1 0 1 } "
      "materialIndex 0 materialIndex 1 }";
  CHECK_EQUAL(weightOfRed(flat, {1.5, -7.5, 0}), 1.0);
  CHECK_EQUAL(mistakesIn(with("Checkerboard { Transform { } materialIndex 0 materialIndex 1 }")),
              "");
}

TEST("a texture may be written inside a Group, of listed materials and listed textures") {
  const auto scene = scenes::parse(
      with("Checkerboard { materialIndex 0 materialIndex 1 }",
           "Noise { materialIndex 2 materialIndex 1 octaves 2 }\n"
           "Wood { materialIndex 0 materialIndex 2 octaves 1 frequency 1 amplitude 1 }"));
  CHECK_EQUAL(scene->getNumMaterials(), 5);
  // At a whole point the noise is a half; the cell of (2, 2, 2) is of material 0.
  CHECK_EQUAL(weightIn(*scene, *scene->getMaterial(3), 0, {2, 2, 2}), 0.5);
  CHECK_EQUAL(weightIn(*scene, *scene->getMaterial(3), 1, {2, 2, 2}), 0.5);
  // The one that was written last holds for the ball.
  Hit hit;
  CHECK(scene->getGroup()->intersect(Ray({0, 0, 5}, {0, 0, -1}), hit, 0));
  CHECK(hit.getMaterial() == scene->getMaterial(4));
}

TEST("indices of a texture must be of materials listed before it") {
  CHECK_MISTAKE(with("Checkerboard { materialIndex 0\nmaterialIndex 2 }"), 3,
                "materialIndex out of range: expected one of the 2 materials listed before this "
                "Checkerboard, counted from 0, found '2'");
  CHECK_MISTAKE(with("Noise { materialIndex 7 materialIndex 1 octaves 1 }"), 2, "found '7'");
  CHECK_MISTAKE(with("Noise { materialIndex -1 materialIndex 1 octaves 1 }"), 2, "found '-1'");
  CHECK_MISTAKE(with("Noise { materialIndex 0.5 materialIndex 1 octaves 1 }"), 2,
                "expected a whole number for materialIndex, found '0.5'");
  CHECK_MISTAKE(with("PhongMaterial { }",
                     "Wood { materialIndex 0 materialIndex 3 octaves 1 "
                     "frequency 1 amplitude 1 }"),
                3, "one of the 3 materials");
}

TEST("a texture is of exactly two materials") {
  CHECK_MISTAKE(with("Checkerboard\n{ materialIndex 0 }"), 3,
                "expected two materialIndex in Checkerboard, found only one");
  CHECK_MISTAKE(with("Checkerboard { materialIndex 0 materialIndex 1\nmaterialIndex 1 }"), 3,
                "expected two materialIndex in Checkerboard, found a third, '1'");
  CHECK_MISTAKE(with("Checkerboard { }"), 2, "expected materialIndex in Checkerboard");
}

TEST("the numbers of a texture are there and in range") {
  const std::string both = "materialIndex 0 materialIndex 1 ";
  for (const char* octaves : {"-1", "-3", "33", "2000000000"}) {
    CHECK_MISTAKE(with("Noise { " + both + "\noctaves " + octaves + " }"), 3,
                  std::string("expected octaves from 0 to 32, found '") + octaves + "'");
  }
  // Of all fields the last value holds.
  CHECK_EQUAL(scenes::mistakeIn(with("Noise { " + both + "octaves 99 octaves 3 }")), "none");
  CHECK_MISTAKE(with("Noise { " + both + "octaves 2.5 }"), 2,
                "expected a whole number for octaves");
  CHECK_MISTAKE(with("Noise { " + both + "}"), 2, "expected octaves in Noise");
  CHECK_MISTAKE(with("Marble { " + both + "octaves 1 amplitude 1 }"), 2,
                "expected frequency in Marble");
  CHECK_MISTAKE(with("Wood { " + both + "octaves 1 frequency 1 }"), 2,
                "expected amplitude in Wood");
  CHECK_MISTAKE(with("Wood { " + both + "octaves 1 amplitude 1 frequency x }"), 2,
                "expected a number for frequency, found 'x'");
  CHECK_MISTAKE(with("Checkerboard { " + both + "size 0 }"), 2, "expected size above 0, found '0'");
  CHECK_MISTAKE(with("Checkerboard { " + both + "size -1 }"), 2, "found '-1'");
  CHECK_MISTAKE(with("Checkerboard { " + both + "octaves 2 }"), 2,
                "unknown word 'octaves' in Checkerboard");
}

TEST("the Transform of a texture comes once and holds steps alone, of finite product") {
  const std::string both = "materialIndex 0 materialIndex 1 ";
  CHECK_MISTAKE(with("Checkerboard { Transform { Scale 1 1 1\nSphere { center 0 0 0 radius 1 } } " +
                     both + "}"),
                3, "expected only steps in the Transform of Checkerboard");
  CHECK_MISTAKE(with("Checkerboard { Transform { }\nTransform { } " + both + "}"), 3,
                "expected one Transform in Checkerboard, found a second");
  CHECK_MISTAKE(with("Checkerboard { Transform { Scael 1 1 1 } " + both + "}"), 2,
                "unknown word 'Scael' in Transform; did you mean 'Scale'?");
  CHECK_MISTAKE(with("Checkerboard { Transform { Rotate { 0 0 0 30 } } " + both + "}"), 2,
                "axis of Rotate");
  CHECK_MISTAKE(
      with("Checkerboard { Transform { UniformScale 1e200 UniformScale 1e200 } " + both + "}"), 2,
      "expected steps whose product is finite");
}

TEST("one slip in a texture gives one mistake, and what was meant") {
  const std::string both = "materialIndex 0 materialIndex 1 ";
  const struct {
    std::string text, message;
  } slips[] = {
      {"Chekerboard { " + both + "}", "did you mean 'Checkerboard'?"},
      {"Marbel { " + both + "octaves 1 frequency 1 amplitude 1 }", "did you mean 'Marble'?"},
      {"Wood { " + both + "octave 1 frequency 1 amplitude 1 }", "did you mean 'octaves'?"},
      {"Noise { materialIndex 0 MaterialIndex 1 octaves 1 }", "did you mean 'materialIndex'?"},
      {"Checkerboard { " + both + "Transform Scale 1 1 1 } }", "expected '{' after Transform"},
      {"Checkerboard { materialIndex 9 materialIndex 1 }", "found '9'"},
      {"Checkerboard { materialIndex 0 }", "found only one"},
      {"Noise { " + both + "octaves 33 }", "found '33'"},
      {"Checkerboard { " + both + "Transform { Plane { normal 0 1 0 offset 0 } } }",
       "expected only steps"}};
  for (const auto& slip : slips) {
    const std::string mistakes = mistakesIn(with(slip.text));
    check::report(mistakes.rfind("2: ", 0) == 0 && scenes::contains(mistakes, slip.message) &&
                      std::count(mistakes.begin(), mistakes.end(), '\n') == 1,
                  __FILE__, __LINE__, slip.text + " gives " + mistakes);
  }
}

TEST("after a mistake among the materials an index out of range is no news") {
  const std::string mistakes =
      mistakesIn(with("Phnogmaterial { } Checkerboard { materialIndex 2 materialIndex 0 }"));
  CHECK_EQUAL(mistakes.find("materialIndex"), std::string::npos);
  CHECK(scenes::contains(mistakes, "Phnogmaterial"));
}

TEST("every beginning of a texture is read or refused cleanly") {
  const std::string text = with(
      "Marble { Transform { Scale 1 2 3 Rotate { 0 1 0 45 } } materialIndex 0 "
      "materialIndex 1 octaves 3 frequency 2 amplitude 5 }");
  for (std::size_t size = 0; size < text.size(); ++size) {
    const std::string beginning = text.substr(0, size);
    CHECK_EQUAL(scenes::mistakeIn(beginning) == "none", mistakesIn(beginning).empty());
  }
  CHECK_EQUAL(mistakesIn(text), "");
}
