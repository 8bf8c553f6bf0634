// Numbers that stand plainly behind a name are read at a stretch: with the same results, and the
// same mistakes, as word by word.
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "random.h"
#include "scene/scene_files.h"

namespace {

/// Text behind a scene, so that all of it may be read at a stretch; on the Group's last line.
const std::string kBehind = " #" + std::string(100, '.');

/// All that can be said of the scene: its spheres and transforms, or its mistakes.
std::string described(const std::string& text) {
  const std::string path = scenes::write("plain.txt", text);
  std::string found;
  for (const InputError& mistake : SceneParser::check(path.c_str())) {
    found += mistake.what() + std::string("\n");
  }
  if (found.empty()) {
    const SceneParser scene(path.c_str());
    const auto& group = dynamic_cast<const Group&>(*scene.getGroup()->getObjects()[0]);
    for (const Object3D* object : group.getObjects()) {
      const auto* transform = dynamic_cast<const Transform*>(object);
      for (int i = 0; transform && i < 12; ++i) {
        found += check::show(transform->getMatrix().at(i / 4, i % 4)) + ' ';
      }
      BoundingBox box;
      object->addBounds(Matrix(), box);
      for (int axis = 0; axis < 3; ++axis) {
        found += check::show(box.low()[axis]) + ' ' + check::show(box.high()[axis]) + '\n';
      }
    }
  }
  std::remove(path.c_str());
  return found;
}

/// `words`, apart by `space` in place of every blank.
std::string spaced(const std::string& words, const std::string& space) {
  std::string text;
  for (const char c : words) {
    if (c == ' ') {
      text += space;
    } else {
      text += c;
    }
  }
  return text;
}

std::string randomNumber(Random& random) {
  static const char* const kForms[] = {"1",
                                       "-2.5",
                                       "+.75",
                                       "3.",
                                       "0.123456789012",
                                       "1e1",
                                       "2.5E-1",
                                       "-0",
                                       "1234567.25",
                                       "12345678.5",
                                       "0.1",
                                       "16777217.123456789",
                                       "7.000000",
                                       "0.30000000000000004441",
                                       "100"};
  return kForms[random.index(15)];
}

}  // namespace

TEST("numbers mean the same one blank apart and in any other layout") {
  Random random(51);
  for (int i = 0; i < 200; ++i) {
    std::string words = "Transform { Translate";
    for (int k = 0; k < 3; ++k) words += ' ' + randomNumber(random);
    words += " XRotate " + randomNumber(random) + " UniformScale 1.5 Sphere { center";
    for (int k = 0; k < 3; ++k) words += ' ' + randomNumber(random);
    words += " radius 0.1 } }";
    const std::string expected = described(scenes::around(spaced(words, "\n ")));
    CHECK(expected.find("expected") == std::string::npos);
    for (const char* space : {" ", "  ", "\t", " # 5\n"}) {
      const std::string found = described(scenes::around(spaced(words, space) + kBehind));
      if (found != expected) check::report(false, __FILE__, __LINE__, words + "\n" + found);
    }
  }
}

TEST("numbers mean the same with a brace, a line end or a carriage return behind them") {
  const std::string sphere = "Sphere { radius 0.25 center 1.5 2.5 3.5";
  const std::string expected = described(scenes::around(sphere + " }"));
  CHECK(expected.find("expected") == std::string::npos);
  for (const char* end : {"}", "\n}", "\r\n}", "\t}", " }"}) {
    CHECK_EQUAL(described(scenes::around(sphere + end + kBehind)), expected);
  }
}

TEST("a mistake among numbers is named alike, however much text stands behind it") {
  for (const char* object :
       {"Sphere { center 0 0 0 radius foo }",
        "Sphere { center 0 0 radius 1 }",
        "Sphere { center 0 0 0 0 radius 1 }",
        "Sphere { center 1 2 3x radius 1 }",
        "Sphere { center 1 2 3\nradius 1e }",
        "Sphere { center 1 1e999 3 radius 1 }",
        "Sphere { center 1 2 3 radius -1.5 }",
        "Sphere { center 1 2 3 radius 0 }",
        "Sphere { center 1,2,3 radius 1 }",
        "Sphere { center 1 2 . radius 1 }",
        "Sphere { center 1 2 3{ radius 1 }",
        "Sphere { center 1 2 3",
        "Sphere { radius 1 2 center 1 2 3 }",
        "Sphere { radius 1 }",
        "Transform { Translate 1 2 Sphere { center 0 0 0 radius 1 } }",
        "Transform { Scale 1 0 1 Sphere { center 0 0 0 radius 1 } }",
        "Transform { UniformScale 1e-200 Sphere { center 0 0 0 radius 1 } }",
        "Transform { XRotate Sphere { center 0 0 0 radius 1 } }",
        "Transform { Rotate 0 0 0 5 Sphere { center 0 0 0 radius 1 } }",
        "Transform { Matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1\nSphere { center 0 0 0 radius 1 } }",
        "Transform { Translate { 1 2 3 Sphere { center 0 0 0 radius 1 } } }"}) {
    // Behind tabs numbers are read one by one.
    const std::string start = scenes::kStart + "Group { numObjects 1 MaterialIndex 0 ";
    const std::string expected = described(start + spaced(object, "\t"));
    CHECK(expected.find("expected") != std::string::npos);
    const std::string text = start + object + kBehind;
    CHECK_EQUAL(described(text), expected);
  }
}

TEST("turns and moves of any size can be undone, so that no check of theirs is missed") {
  for (const char* step : {"Translate 1e308 -1e308 1e308", "XRotate 1e300", "YRotate -1e308",
                           "ZRotate 90", "Translate 1e-320 0 0", "XRotate 1e-320"}) {
    const std::string found = described(
        scenes::around("Transform { " + std::string(step) + " Sphere { center 0 0 0 radius 1 } }"));
    check::report(found.find("expected") == std::string::npos, __FILE__, __LINE__, found);
  }
}
