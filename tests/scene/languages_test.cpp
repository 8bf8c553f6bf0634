// The scene languages of the course's years: their words, what these mean, and what is said of a
// word of another year.
#include <cmath>

#include "check.h"
#include "scene/scene_files.h"
#include "scene/source_text.h"
#include "scene_text.h"
#include "shading/phong_material.h"
#include "vectors.h"

using scene_text::parse, scene_text::parseWhole, scenes::contains;

namespace {

const std::string kCamera = "PerspectiveCamera { center 0 0 5 direction 0 0 -2 up 0 3 0 angle 30 }";

SceneRules rulesOf(Language language) {
  SceneRules rules;
  rules.language = language;
  return rules;
}

std::string mistakeOf(const std::string& text, const SceneRules& rules = {}) {
  try {
    parseWhole(text, rules);
  } catch (const InputError& mistake) {
    const std::string message = mistake.what();
    return message.substr(message.find(".txt:") + 5);
  }
  return "";
}

const PhongMaterial& phong(const SceneParser& scene, int index) {
  return dynamic_cast<const PhongMaterial&>(*scene.getMaterial(index));
}

std::string materials(const std::string& fields) {
  return "Materials { numMaterials 1 PhongMaterial { " + fields + " } }";
}
std::string pointLight(const std::string& fields) {
  return "Lights { numLights 1 PointLight { " + fields + " position 0 0 0 color 1 1 1 } }";
}

/// What arrives at distance 2 of a white point light.
double lightAtTwo(const SceneParser& scene) {
  Vec3d direction;
  Vec3f color;
  double distance;
  scene.getLight(0)->getIllumination({0, 0, 2}, direction, color, distance);
  return double(color.x());
}

const std::string kNodes =
    "Background { color 0 0 1 ambient_light .1 .1 .1 }\n"
    "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 30 }\n"
    "Materials { Material { diffuse 1 0 0 specular .5 .5 .5 shininess 8 } Material { } }\n"
    "Scene {\n"
    "  Node { Transform { translate 0 0 -1 scale 2 2 2 }\n"
    "    Component<Light> { type point color 1 1 1 attenuation .25 }\n"
    "    Component<Material> { index 1 }\n"
    "    Node { Component<Material> { index 0 } Component<Object> { type sphere radius 1 } }\n"
    "    Node { Transform { x_rotate 90 } Component<Light> { type directional direction 0 0 -1 "
    "color 1 1 1 } }\n"
    "    Component<Object> { type plane normal 0 1 0 offset -3 }\n"
    "  }\n"
    "}\n";

}  // namespace

TEST("a word of other years is a mistake that names the courses that have it") {
  const std::string ours = "Group { numObjects 0 }";
  CHECK_EQUAL(
      mistakeOf(kCamera + materials("shininess 20") + ours),
      "1: unknown word 'shininess' in PhongMaterial; shininess is a word of 2012, 2016, 2020 "
      "and thu: add -course 2012 or -course 2016 or -course 2020 or -course thu");
  CHECK_EQUAL(
      mistakeOf(kCamera + materials("refractionIndex 2") + ours),
      "1: unknown word 'refractionIndex' in PhongMaterial; refractionIndex is a word of 2012: "
      "add -course 2012");
  CHECK_EQUAL(mistakeOf(kCamera + pointLight("falloff 2") + ours),
              "1: unknown word 'falloff' in PointLight; falloff is a word of 2012 and 2016: add "
              "-course 2012 or -course 2016");
  CHECK_EQUAL(mistakeOf(kNodes),
              "2: unknown word 'Camera' in the scene; Camera is a word of 2020: "
              "add -course 2020");
  CHECK_EQUAL(
      mistakeOf(kCamera + materials("exponent 20") + ours, rulesOf(Language::of2016)),
      "1: unknown word 'exponent' in PhongMaterial; exponent is a word of 2003: add -course "
      "2003");
  CHECK_EQUAL(
      mistakeOf(kCamera + ours, rulesOf(Language::of2020)),
      "1: unknown word 'PerspectiveCamera' in the scene; PerspectiveCamera is a word of 2003, "
      "2012, 2016 and thu: add -course 2003 or -course 2012 or -course 2016 or -course thu");
  CHECK_EQUAL(
      mistakeOf(kCamera + "Background { ambientLight 1 1 1 }" + ours, rulesOf(Language::ofThu)),
      "1: unknown word 'ambientLight' in Background; ambientLight is a word of 2003, 2012, "
      "2016 and 2020: add -course 2003 or -course 2012 or -course 2016 or -course 2020");
}

TEST("Noise in a material of another year, and 2003's words among nodes, name the course too") {
  const std::string noise = "Noise { color 1 1 1 color 0 0 0 octaves 1 frequency 1 amplitude 1 }";
  CHECK(
      contains(mistakeOf(kCamera + materials(noise)),
               "unknown word 'Noise' in PhongMaterial; Noise is a word of 2012: add -course 2012"));
  CHECK(contains(
      mistakeOf("Materials { Material { diffuseColor 1 1 1 } }", rulesOf(Language::of2020)),
      "diffuseColor is a word of 2003, 2012, 2016 and thu: add -course 2003"));
}

TEST("a slip of a word is still guessed, and a word in the wrong place not called another year's") {
  CHECK(contains(mistakeOf(kCamera + materials("exponnent 2")), "did you mean 'exponent'?"));
  CHECK(!contains(mistakeOf(kCamera + materials("Background")), "-course"));
}

TEST("shininess is the exponent, which is 0 where it is not given, and its brace may be glued on") {
  for (const Language language : {Language::of2012, Language::of2016, Language::ofThu}) {
    const SceneRules rules = rulesOf(language);
    const std::string glued = "Materials { numMaterials 1 Material { shininess 20} }";
    CHECK_EQUAL(phong(parse(glued, rules), 0).getExponent(), 20.0f);
    CHECK_EQUAL(phong(parse(materials("specularColor 1 1 1"), rules), 0).getExponent(), 0.0f);
  }
}

TEST("falloff dims by near + falloff s^2, where the language has it") {
  SceneRules rules = rulesOf(Language::of2012);
  CHECK_NEAR(lightAtTwo(parse(pointLight("falloff 0.5"), rules)), 1 / 3.0, 1e-7);
  CHECK_NEAR(lightAtTwo(parse(pointLight(""), rules)), 1, 0);
  rules = rulesOf(Language::of2016);
  rules.nearFalloff = 0;
  CHECK_NEAR(lightAtTwo(parse(pointLight("falloff 0.5"), rules)), 0.5, 1e-7);
  CHECK_EQUAL(mistakeOf(kCamera + pointLight(""), rules),
              "1: expected falloff in PointLight, found none before its '}'");
  CHECK_NEAR(lightAtTwo(parse(pointLight(""), rulesOf(Language::ofThu))), 1, 0);
}

TEST("a camera's up is turned, or kept as it is written, or made unit, or unscaled") {
  using Up = SceneRules::CameraUp;
  const auto upOf = [](Up up) {
    SceneRules rules;
    rules.cameraUp = up;
    const SceneParser scene =
        parseWhole("PerspectiveCamera { center 0 0 5 direction 0 0 -2 up 0 3 4 angle 30 }", rules);
    return std::pair(scene.getCamera()->getRight(), scene.getCamera()->getUp());
  };
  // d = (0, 0, -1), u = (0, 3, 4): d x u = (3, 0, 0), and (3, 0, 0) x d = (0, 3, 0).
  CHECK(upOf(Up::turned) == std::pair(Vec3d(1, 0, 0), Vec3d(0, 1, 0)));
  CHECK(upOf(Up::asWritten) == std::pair(Vec3d(1, 0, 0), Vec3d(0, 3, 4)));
  CHECK(upOf(Up::unscaled) == std::pair(Vec3d(3, 0, 0), Vec3d(0, 3, 0)));
  const auto unit = upOf(Up::unit);
  CHECK_NEAR(length(unit.second - Vec3d(0, 0.6, 0.8)), 0, 1e-15);
}

TEST("a specular colour long enough is that of a mirror, and of glass with a refractionIndex") {
  SceneRules rules = rulesOf(Language::of2012);
  rules.leastMirror = 0.001f;
  rules.haveHighlights = false;
  const auto material = [&](const std::string& fields) {
    const SceneParser scene = parse(materials(fields), rules);
    const PhongMaterial& read = phong(scene, 0);
    CHECK(read.getSpecularColor() == Vec3f());
    return std::tuple(read.getReflectiveColor(), read.getTransparentColor(),
                      read.getIndexOfRefraction());
  };
  const Vec3f grey(0.5f, 0.5f, 0.5f), black;
  CHECK(material("specularColor .5 .5 .5") == std::tuple(grey, black, 1.0f));
  CHECK(material("specularColor .5 .5 .5 refractionIndex 0") == std::tuple(grey, black, 1.0f));
  CHECK(material("specularColor .5 .5 .5 refractionIndex 2") == std::tuple(grey, grey, 2.0f));
  CHECK(material("specularColor .0005 .0005 .0005") == std::tuple(black, black, 1.0f));
  CHECK(material("specularColor .5 .5 .5 reflectiveColor 0 0 0") == std::tuple(black, black, 1.0f));
}

TEST("whether a scene of 2012 has glass is found out from its words") {
  const auto hasGlass = [](const std::string& text) {
    return SceneParser::hasGlass(SourceText("a.txt", text));
  };
  CHECK(hasGlass("Material { refractionIndex 1.5 }"));
  CHECK(hasGlass("Material { refraction_index 1.5 }"));  // as the older scenes write it
  CHECK(!hasGlass("Material { refractionIndex 0 } # refractionIndex 2"));
  CHECK(!hasGlass("Material { shininess 2 }") && !hasGlass("refractionIndex"));
}

TEST("Matrix4f is a step of 2012, 2016 and thu") {
  const std::string text =
      materials("") +
      " Group { numObjects 1 MaterialIndex 0 Transform { Matrix4f { 1 0 0 2 0 1 "
      "0 0 0 0 1 0 0 0 0 1 } Sphere { center 0 0 0 radius 1 } } }";
  BoundingBox box;
  parse(text, rulesOf(Language::of2012)).getGroup()->addBounds(Matrix(), box);
  CHECK(box.low() == Vec3d(1, -1, -1) && box.high() == Vec3d(3, 1, 1));
  CHECK(contains(mistakeOf(kCamera + text), "Matrix4f is a word of 2012, 2016 and thu"));
}

TEST("a camera of thu gives the picture's size") {
  const std::string camera =
      "PerspectiveCamera { width 20 center 0 0 5 direction 0 0 -1 up 0 1 0 height 30 angle 30 }";
  const SceneParser scene = parseWhole(camera, rulesOf(Language::ofThu));
  CHECK_EQUAL(scene.getPictureSize().width, 20);
  CHECK_EQUAL(scene.getPictureSize().height, 30);
  CHECK(contains(
      mistakeOf("PerspectiveCamera { width 0 center 0 0 5 direction 0 0 -1 up 0 1 0 angle 30 }",
                rulesOf(Language::ofThu)),
      "expected width from 1 to 65535, found '0'"));
  CHECK_EQUAL(parse("").getPictureSize().width, 0);
}

TEST("nodes of 2020: a Transform and a material hold for all in them, and a light is where it is") {
  SceneRules rules = rulesOf(Language::of2020);
  rules.nearFalloff = 0;
  rules.leastMirror = 0;
  const SceneParser scene = parseWhole(kNodes, rules);
  CHECK(scene.getAmbientLight() == Vec3f(0.1f, 0.1f, 0.1f));
  CHECK_EQUAL(scene.getNumMaterials(), 2);
  CHECK_EQUAL(phong(scene, 0).getExponent(), 8.0f);
  CHECK(phong(scene, 0).getReflectiveColor() == Vec3f(0.5f, 0.5f, 0.5f));
  // The light stands at (0, 0, -1): at (0, 0, 2) it is 1 / (.25 3^2).
  CHECK_NEAR(lightAtTwo(scene), 1 / 2.25, 1e-7);
  // -z turned by 90 degrees about x is +y: that light comes from below.
  Vec3d direction;
  Vec3f color;
  double distance;
  scene.getLight(1)->getIllumination({0, 0, 0}, direction, color, distance);
  CHECK_NEAR(length(direction - Vec3d(0, -1, 0)), 0, 1e-15);
  // The sphere reaches to z = -1 + 2 with material 0; the plane lies at y = 2 * -3 with material 1.
  Hit hit;
  CHECK(scene.getGroup()->intersect(Ray({0, 0, 5}, {0, 0, -1}), hit, 0));
  CHECK(hit.getMaterial() == scene.getMaterial(0));
  CHECK_NEAR(hit.getT(), 4, 1e-12);
  hit = Hit();
  CHECK(scene.getGroup()->intersect(Ray({9, 0, 5}, {0, -1, 0}), hit, 0));
  CHECK(hit.getMaterial() == scene.getMaterial(1));
  CHECK_NEAR(hit.getT(), 6, 1e-12);
}

TEST("a node's material holds for all in it, before it too") {
  const auto sphereAt = [](int x) {
    return " Node { Transform { translate " + std::to_string(x) +
           " 0 0 } Component<Object> { type sphere radius 1 } } ";
  };
  const auto index = [](int k) {
    return " Component<Material> { index " + std::to_string(k) + " } ";
  };
  // Each sphere is of the material whose number is its x, but for that at 10.
  const SceneParser scene = parseWhole(
      "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 30 }\n"
      "Materials { Material { } Material { } Material { } Material { } Material { } }\n"
      "Scene { " +
          sphereAt(0) + index(0) + " Node { Node {" + sphereAt(1) + "} " + index(1) + "}" +
          " Node {" + sphereAt(2) + index(2) + sphereAt(10) + index(3) + sphereAt(3) + "}" +
          " Node { Node {" + sphereAt(4) + index(4) + "} } }",
      rulesOf(Language::of2020));
  for (const int x : {0, 1, 2, 3, 4, 10}) {
    Hit hit;
    CHECK(scene.getGroup()->intersect(Ray({double(x), 0.9, 5}, {0, 0, -1}), hit, 0));
    CHECK_EQUAL(hit.getMaterial()->getNumber(), x == 10 ? 2 : x);
  }
}

TEST("after a mistake among the materials of nodes an index out of range is no news") {
  const std::string path = scenes::write(
      "scene.txt",
      "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 30 }\nMaterials { Matrial { } }\n"
      "Scene { Component<Material> { index 0 } Component<Object> { type sphere radius 1 } }\n");
  const auto mistakes = SceneParser::check(path.c_str(), nullptr, rulesOf(Language::of2020));
  std::remove(path.c_str());
  CHECK_EQUAL(mistakes.size(), std::size_t(1));
  CHECK_EQUAL(mistakes.at(0).getLine(), std::size_t(2));
}

TEST("mistakes in nodes have their line") {
  const SceneRules rules = rulesOf(Language::of2020);
  const std::string start =
      "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 30 }\n"
      "Materials { Material { } }\n";
  const auto mistake = [&](const std::string& scene) { return mistakeOf(start + scene, rules); };
  CHECK_EQUAL(mistake("Scene { Node { Component<Object> { type sphere radius 1 } } }"),
              "3: expected a Component<Material> in this Node or one around it, found "
              "'Component<Object>'");
  CHECK_EQUAL(mistake("Scene { Component<Object> { type sphere radius 1 }\n"
                      "  Component<Material> { index 1 } }"),
              "4: index out of range: expected one of 1 material, counted from 0, found '1'");
  CHECK_EQUAL(mistake("Scene { Component<Material> { index 1 } }"),
              "3: index out of range: expected one of 1 material, counted from 0, found '1'");
  CHECK_EQUAL(mistake("Scene { Component<Material> { index 0 } Component<Object> { type cube } }"),
              "3: expected sphere, plane, triangle or mesh for type, found 'cube'");
  CHECK_EQUAL(mistake("Scene { Component<Material> { index 0 } Component<Object> { radius 1 } }"),
              "3: expected type, found 'radius'");
  CHECK_EQUAL(mistake("Scene { Component<Material> { index 0 } Transform { scale 2 2 2 } }"),
              "3: Transform must come first in its Node");
  CHECK(contains(mistake("Scene { Node { Transform { Scale 2 2 2 } } }"),
                 "unknown word 'Scale' in Transform"));
  CHECK(contains(mistake("Scene { Group { } }"), "Group is a word of 2003"));
  std::string deep = "Scene { ";
  for (int i = 0; i < 1000; ++i) deep += "Node { ";
  CHECK(!contains(mistake(deep), "deep inside each other"));
  deep += "Node { ";
  CHECK(contains(mistake(deep), "expected Nodes at most 1000 deep inside each other"));
}
