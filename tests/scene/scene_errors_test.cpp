// Mistakes in scene files: the line, what was expected and what was found; and that reading on
// after a mistake finds the others and no nonsense.
#include <algorithm>
#include <random>

#include "scene/scene_files.h"

using scenes::around;
using scenes::kStart;
using scenes::mistakeIn;
using scenes::mistakesIn;

namespace {

const std::string kSphere = "Sphere { center 0 0 0 radius 1 }\n";
const std::string kCamera =
    "OrthographicCamera { center 0 0 0 direction 0 0 -1 up 0 1 0 size 2 }\n";

/// One of everything.
const std::string kEverything =
    kCamera +
    "Background { color 0 0 0 ambientLight .1 .1 .1 } # comment\n"
    "Lights { numLights 2 DirectionalLight { direction 0 -1 0 color 1 1 1 }\n"
    "PointLight { position 1 2 3 color 1 1 1 attenuation 1 0 0.5 } }\n"
    "Materials { numMaterials 4 PhongMaterial { exponent 5 } Material { diffuseColor 1 0 0 }\n"
    "CookTorranceMaterial { roughness .3 distribution GGX index 1.5 }\n"
    "WardMaterial { roughnessX .3 tangent 0 0 1 } }\n"
    "Group { numObjects 4 MaterialIndex 1 Sphere { center 0 0 0 radius 1.5 }\n"
    "Transform { Translate { 1 0 0 } Scale 1 2 3 Rotate { 0 1 0 45 } XRotate 5\n"
    "Matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 Group { numObjects 1 Material { } " +
    kSphere +
    "} } Plane { normal 0 1 0 offset -1 }\n"
    "Triangle { vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0 } } // end\n";

/// Checks that check() and the constructor agree on whether `text` is good, and that the mistake
/// thrown is one of those collected. Returns whether it is good.
bool isGoodBothWays(const std::string& text, int line) {
  const std::string thrown = mistakeIn(text), collected = mistakesIn(text);
  const bool agree = thrown == "none" ? collected.empty()
                                      : scenes::contains("\n" + collected, "\n" + thrown + "\n");
  if (!agree) {
    check::report(false, __FILE__, line,
                  "thrown: " + thrown + "\ncollected: " + collected + "in:\n" + text);
  }
  return thrown == "none";
}

std::size_t countLines(const std::string& text) {
  return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

}  // namespace

TEST("a missing scene file, or a folder in its place, is said to be so") {
  const auto reasonOf = [](const std::string& path) {
    const std::vector<InputError> mistakes = SceneParser::check(path.c_str());
    CHECK_EQUAL(mistakes.size(), 1u);
    CHECK_THROWS(SceneParser(path.c_str()), InputError);
    return mistakes.empty() ? std::string() : std::string(mistakes[0].what());
  };
  const std::string missing = check::temporaryFolder() + "/no_such_scene.txt";
  CHECK_EQUAL(reasonOf(missing), missing + ": cannot be read: No such file or directory");
  CHECK(scenes::contains(reasonOf(check::temporaryFolder()), "folder"));
  CHECK(scenes::contains(reasonOf("/dev/zero"), "64 MB"));
  CHECK(scenes::contains(reasonOf("/dev/null"), "Camera"));
}

TEST("bad numbers are named with their field") {
  CHECK_MISTAKE(around("Sphere {\ncenter 0 0 0\nradius foo }"), 7,
                "expected a number for radius, found 'foo'");
  for (const char* word : {"5x", "nan", "inf", "0x5", "1e", "--1", "\xff"}) {
    CHECK_MISTAKE(around("Sphere { center 0 0 0 radius " + std::string(word) + " }"), 5,
                  word[0] == '\xff' ? "'\\xff'" : word);
  }
  CHECK_MISTAKE(around("Sphere { center 0 1e999 0 radius 1 }"), 5, "within range for center");
  CHECK_MISTAKE(around("Material { diffuseColor 0 1e39 0 }" + kSphere), 5, "'1e39'");
  CHECK_MISTAKE(around("Sphere { center 0 0 radius 1 }"), 5,
                "expected a number for center, found 'radius'");
  CHECK_MISTAKE(around("Sphere { center 0 0 0 0 radius 1 }"), 5,
                "a number too many in Sphere: expected a word or '}', found '0'");
  CHECK_MISTAKE(around("Sphere { center 0 0 0 radius " + std::string(1'000'000, '9') + "x }"), 5,
                "'" + std::string(40, '9') + "...'");
}

TEST("unknown words are named, with the word that was meant") {
  CHECK_MISTAKE(around("Sphear { center 0 0 0 radius 1 }"), 5,
                "unknown word 'Sphear' in Group; did you mean 'Sphere'?");
  CHECK_MISTAKE(around("Sphere { centre 0 0 0 radius 1 }"), 5, "did you mean 'center'?");
  CHECK_MISTAKE(around("Cube { }"), 5, "expected Group, Transform, Sphere");
  CHECK_MISTAKE(around("Transform { Rotat 1 0 0 5 " + kSphere + "}"), 5, "'Rotate'");
  CHECK_MISTAKE(kStart + "group { }", 4, "did you mean 'Group'?");
  CHECK_MISTAKE(kStart + "Background { colour 0 0 0 }", 4, "did you mean 'color'?");
  CHECK_MISTAKE(kCamera + "Lights { numLights 1 SpotLight { } }", 2, "'SpotLight'");
  CHECK_MISTAKE(kCamera + "Materials { numMaterials 1 PongMaterial { } }", 2, "'PhongMaterial'");
  CHECK_MISTAKE(kCamera + "Materials { numMaterials 1 Material { shininess 1 } }", 2,
                "'shininess'");
}

TEST("counts are checked both ways, where the list ends or goes on") {
  CHECK_MISTAKE(around(kSphere + kSphere + "\n", 3), 9,
                "numObjects says 3, but Group ends after 2: expected 1 more, found '}'");
  CHECK_MISTAKE(around(kSphere + kSphere, 1), 6,
                "numObjects says 1, but Group goes on: expected '}', found 'Sphere'");
  CHECK_MISTAKE(around(kSphere, 0), 5, "numObjects says 0");
  CHECK_MISTAKE(around(kSphere, 2147483647), 7, "numObjects says 2147483647");
  CHECK_MISTAKE(kStart + "Group { numObjects 2147483648 }", 4, "'2147483648'");
  CHECK_MISTAKE(kStart + "Group { numObjects -1 }", 4, "at least 0 for numObjects, found '-1'");
  CHECK_MISTAKE(kStart + "Group { numObjects 1.0 }", 4, "'1.0'");
  CHECK_MISTAKE(kStart + "Group { }", 4, "expected numObjects at the start of Group, found '}'");
  CHECK_MISTAKE(kCamera + "Lights { numLights 1 }", 2, "numLights says 1, but Lights ends after 0");
  CHECK_MISTAKE(kCamera + "Materials { numMaterials 1 Material { } Material { } }", 2,
                "numMaterials says 1");
  CHECK_EQUAL(mistakeIn(around("", 0)), "none");
}

TEST("a MaterialIndex must be there before the first object, and in range") {
  CHECK_MISTAKE(kStart + "Group { numObjects 1\n" + kSphere + "}", 5,
                "expected a MaterialIndex before the first object, found 'Sphere'");
  for (const char* word : {"2", "-1", "2147483647"}) {
    CHECK_MISTAKE(around("MaterialIndex " + std::string(word) + "\n" + kSphere), 5,
                  "out of range: expected one of 2 materials, counted from 0, found '" +
                      std::string(word) + "'");
  }
  CHECK_MISTAKE(around("MaterialIndex 0.5 " + kSphere), 5, "'0.5'");
  CHECK_MISTAKE(kCamera + "Group { numObjects 1 MaterialIndex 0 " + kSphere + "}", 2,
                "one of 0 materials");
  // Materials written inside a Group have no number.
  CHECK_MISTAKE(around("Material { } MaterialIndex 2 " + kSphere), 5, "out of range");
}

TEST("values out of their range are named") {
  CHECK_MISTAKE(around("Sphere { center 0 0 0 radius 0 }"), 5,
                "expected radius above 0, found '0'");
  CHECK_MISTAKE(around("Sphere { center 0 0 0\nradius -2 }"), 6, "'-2'");
  CHECK_MISTAKE(around("Sphere { center 0 0 0 radius 1e-400 }"), 5, "'1e-400'");
  CHECK_MISTAKE(around("Plane { normal 0 0 -0 offset 1 }"), 5, "normal that is not zero");
  CHECK_MISTAKE(around("Material { exponent -1 }"), 5, "exponent of at least 0, found '-1'");
  CHECK_MISTAKE(around("Material { indexOfRefraction 0 }"), 5, "indexOfRefraction above 0");
  CHECK_MISTAKE(kCamera + "Lights { numLights 1 DirectionalLight { direction 0 0 0 color 1 1 1 } }",
                2, "direction that is not zero");
  CHECK_EQUAL(mistakeIn(around("Material { exponent 0 } " + kSphere)), "none");
  CHECK_MISTAKE(around("Material { priority 1.5 }"), 5,
                "expected a whole number for priority, found '1.5'");
  CHECK_MISTAKE(around("Material { priority 2147483648 }"), 5, "'2147483648'");
  CHECK_MISTAKE(around("Material { prioritty 1 }"), 5, "'priority'");
}

TEST("cameras are checked") {
  const auto camera = [](const std::string& kind, const std::string& direction,
                         const std::string& up, const std::string& rest) {
    return kind + "Camera { center 0 0 0\ndirection " + direction + "\nup " + up + "\n" + rest +
           " }";
  };
  CHECK_MISTAKE(camera("Perspective", "0 0 0", "0 1 0", "angle 5"), 2,
                "direction that is not zero");
  CHECK_MISTAKE(camera("Perspective", "0 0 1", "0 0 0", "angle 5"), 3, "up that is not zero");
  CHECK_MISTAKE(camera("Perspective", ".1 .2 .3", "-.3 -.6 -.9", "angle 5"), 3, "parallel");
  CHECK_MISTAKE(camera("Orthographic", "0 1e-200 0", "0 1e200 0", "size 5"), 3, "parallel");
  CHECK_MISTAKE(camera("Perspective", "0 0 1", "0 1 0", "angle 180"), 4, "'180'");
  CHECK_MISTAKE(camera("Perspective", "0 0 1", "0 1 0", "angle 0"), 4, "angle above 0");
  CHECK_MISTAKE(camera("Orthographic", "0 0 1", "0 1 0", "size -1"), 4, "size above 0");
  CHECK_MISTAKE(camera("Orthographic", "0 0 1", "0 1 0", "angle 1"), 4, "'angle'");
  CHECK_MISTAKE(camera("Orthographic", "0 0 1", "0 1 0", ""), 1, "expected size");
  CHECK_EQUAL(mistakeIn(camera("Perspective", "0 0 1", "0 1e-9 1", "angle 179.9")), "none");
}

TEST("one camera is required, and sections may not stand twice") {
  CHECK_MISTAKE("", 1, "Camera");
  CHECK_MISTAKE("Background { }\n\n", 1, "Camera");
  CHECK_MISTAKE(kStart + kCamera, 4, "a second camera");
  CHECK_MISTAKE(kStart + "Lights { numLights 0 }", 4, "a second Lights");
  CHECK_MISTAKE(kStart + "Materials { numMaterials 0 }", 4, "a second Materials");
  CHECK_MISTAKE(kStart + "Background { }\nBackground { }", 5, "a second Background");
  CHECK_MISTAKE(kCamera + "Group { numObjects 0 }\nMaterials { numMaterials 0 }", 3,
                "Materials must come before the first Group");
}

TEST("singular transforms name the step") {
  const auto transform = [](const std::string& steps) {
    return around("Transform {\nTranslate 1 2 3\n" + steps + "\n" + kSphere + "}");
  };
  CHECK_MISTAKE(transform("Scale { 1 0 1 }"), 7, "Scale 1 0 1");
  CHECK_MISTAKE(transform("UniformScale 0"), 7, "UniformScale 0");
  CHECK_MISTAKE(transform("Rotate { 0 0 0 45 }"), 7, "axis of Rotate");
  CHECK_MISTAKE(transform("Matrix 1 2 3 0 4 5 6 0 7 8 9 0 0 0 0 1"), 7, "Matrix 1 2 3 0");
  // In binary the determinant of these rows is not 0 but some 1e-18.
  CHECK_MISTAKE(transform("Matrix .1 .2 .3 0 .4 .5 .6 0 .7 .8 .9 0 0 0 0 1"), 7, "singular");
  CHECK_MISTAKE(transform("Matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2"), 7, "found 0 0 0 2");
  CHECK_MISTAKE(transform("Matrix { 1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1 }"), 7, "last row");
  CHECK_MISTAKE(transform("UniformScale 1e-320"), 7, "UniformScale");
  CHECK_MISTAKE(transform("UniformScale 1e300"), 7, "UniformScale");
  CHECK_MISTAKE(transform("UniformScale 1e-60 UniformScale 1e-60"), 5, "multiplied");
  CHECK_EQUAL(mistakeIn(transform("Scale 1e-8 1 1e8 XRotate 30")), "none");
}

TEST("transforms hold their numbers and one object") {
  CHECK_MISTAKE(around("Transform { Translate 1 2 " + kSphere + "}"), 5,
                "expected a number for Translate, found 'Sphere'");
  CHECK_MISTAKE(around("Transform { Translate { 1 2 } " + kSphere + "}"), 5, "found '}'");
  CHECK_MISTAKE(around("Transform { Translate { 1 2 3 4 } " + kSphere + "}"), 5, "'4'");
  CHECK_MISTAKE(around("Transform { Translate 1 2 3 4 " + kSphere + "}"), 5, "'4'");
  CHECK_MISTAKE(around("Transform { Translate 1 2 3 }"), 5, "expected an object in Transform");
  CHECK_MISTAKE(around("Transform {\n" + kSphere + kSphere + "}"), 7, "one object");
  CHECK_MISTAKE(around("Transform { " + kSphere + "\nScale 1 1 1 }"), 7, "'Scale'");
}

TEST("braces must match, and sections stand outside") {
  CHECK_MISTAKE(around("Sphere center 0 0 0 radius 1"), 5, "expected '{' after Sphere");
  CHECK_MISTAKE(around("Sphere { center 0 0 0 radius 1\nPlane { normal 0 1 0 offset 1 }", 2), 6,
                "expected '}' at the end of Sphere, found 'Plane'");
  CHECK_MISTAKE(around(kSphere) + "}", 8, "'}'");
  CHECK_MISTAKE(kStart + kSphere, 4, "inside a Group");
  CHECK_MISTAKE(around(kSphere + "Background { }"), 6, "'Background'");
  CHECK_MISTAKE(around("Sphere { center 0 0 0 radius 1"), 6, "the end of the file");
  CHECK_MISTAKE(kStart + "\nGroup {\n\n\n", 5, "the end of the file");
}

TEST("nesting beyond 1000 levels is refused with its line, at any depth") {
  const std::string groups = kStart + repeated("Group { numObjects 1\n", 100'000);
  CHECK_MISTAKE(groups, 1004, "expected Groups and Transforms at most 1000 deep");
  CHECK(countLines(mistakesIn(groups)) == 2);  // and the file ends inside
  const std::string transforms =
      around(repeated("Transform { Scale 2 2 2\n", 100'000) + kSphere + repeated("}", 100'000));
  CHECK_MISTAKE(transforms, 1004, "expected Groups and Transforms at most 1000 deep");
  CHECK_EQUAL(countLines(mistakesIn(transforms)), 1u);
}

TEST("all mistakes are collected in file order without nonsense after them") {
  const std::string text =
      "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 0 1 angle 30 }\n"
      "Materials { numMaterials 2 Material { exponent x }\n"
      "Materiel { color 1 } }\n"
      "Group { numObjects 5 MaterialIndex 9\n"
      "Sphear { center 0 0 0 radius 1 }\n"
      "Sphere { Center 0 0 0 radius 1x }\n"
      "Transform { Scale 0 1 1 Sphere { center 0 0 0 radius -1 } }\n"
      "TriangleMesh { obj_file gone.obj }\n"
      "Plane { normal 0 0 0 offset }\n"
      "}\n"
      "Ligths { numLights 1 PointLight { position 0 0 0 color 1 1 1 } }\n";
  std::string lines;
  const std::string path = scenes::write("many.txt", text);
  for (const InputError& mistake : SceneParser::check(path.c_str())) {
    lines += std::to_string(mistake.getLine()) + " ";
  }
  CHECK_EQUAL(lines, "1 2 3 5 6 6 7 7 8 9 9 11 ");
}

TEST("mistakes found out of turn are told in file order") {
  // The radius can only be judged at the end of its block.
  const std::string mistakes = mistakesIn(around("Sphere {\nradius -1\ncenter x 0 0 }"));
  CHECK_EQUAL(mistakes.find("6: expected radius"), 0u);
  CHECK_EQUAL(countLines(mistakes), 2u);
}

TEST("one slip gives one mistake") {
  for (const std::string& text :
       {around("Sphear { center 0 0 0 radius 1 }"), around("Sphere { center 0 0 0 radius 1"),
        around("Sphere { center 0 0 0 radius 1\n" + kSphere, 2),
        around("Transform { Scale 1 1 1 Sphear { } }"), around("Sphere { center a b c radius 1 }"),
        around("Sphere { center 0 0 0 radius }"), kStart + "Groop { " + kSphere + kSphere + "}",
        std::string("OrtographicCamera { center 0 0 0 direction 0 0 1 up 0 1 0 size 1 }"),
        around("Transform { Foo { 1 2 3 } " + kSphere + "}"),
        around("Transform { Translate { 1 x 3 } " + kSphere + "}"),
        kStart + kSphere + kSphere + kSphere + "}",
        kStart + "Group { numObjects x " + kSphere + "}"}) {
    const std::string mistakes = mistakesIn(text);
    const std::size_t expected = scenes::contains(text, "a b c")          ? 3
                                 : scenes::contains(text, "numObjects x") ? 2  // no material
                                                                          : 1;
    check::report(countLines(mistakes) == expected, __FILE__, __LINE__, mistakes + text);
  }
}

TEST("at most a hundred mistakes are collected, and quickly") {
  CHECK_EQUAL(countLines(mistakesIn(around(repeated("Sphere { radius x }\n", 100'000)))), 100u);
}

TEST("every prefix of a scene is read or refused cleanly, by the constructor and by check") {
  int good = 0;
  for (std::size_t size = 0; size <= kEverything.size(); ++size) {
    good += isGoodBothWays(kEverything.substr(0, size), __LINE__);
  }
  // Cut in or behind a camera, a section or the comment at the end.
  CHECK(good > 10 && good < 200);
  CHECK(isGoodBothWays(kEverything, __LINE__));
}

TEST("words left out, doubled, exchanged or spoilt are read or refused cleanly") {
  std::mt19937 random(22);
  const char* const kWords[] = {"{",      "}",         "",           "0",
                                "-1",     "1e999",     "x",          "Group",
                                "Sphere", "Transform", "Scale",      "MaterialIndex",
                                "radius", "Lights",    "Materials",  "#",
                                "{ {",    "} }",       "numObjects", "\xff"};
  int good = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = kEverything;
    for (auto edits = 1 + random() % 3; edits > 0; --edits) {
      const std::size_t start = text.find_last_of(" \n", random() % text.size()) + 1;
      const std::size_t length = std::min(text.find_first_of(" \n", start), text.size()) - start;
      const std::string word = kWords[random() % std::size(kWords)];
      const std::size_t replaced = random() % 2 ? length : 0;
      text.replace(start, replaced, word + (random() % 2 ? " " : ""));
    }
    good += isGoodBothWays(text, __LINE__);
  }
  CHECK(good > 20 && good < 2000);
}

TEST("random bytes are read or refused cleanly") {
  std::mt19937 random(23);
  int bad = 0;
  for (int i = 0; i < 300; ++i) {
    std::string text = kStart;
    for (auto size = random() % 200; size > 0; --size) text += char(random() % 256);
    bad += !isGoodBothWays(text, __LINE__);
  }
  CHECK(bad > 100);
  CHECK(!isGoodBothWays(std::string(1'000'000, '\0'), __LINE__));
  CHECK(!isGoodBothWays(std::string(1'000'000, '{'), __LINE__));
  CHECK(!isGoodBothWays(std::string(1'000'000, '}'), __LINE__));
}
