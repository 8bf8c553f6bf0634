// Warnings of what is legal and probably a mistake: each kind where it is due, and nowhere else.
#include <algorithm>
#include <cmath>

#include "check.h"
#include "random.h"
#include "run_program.h"
#include "scene_text.h"

namespace {

const char* const kFloor =
    "Materials { numMaterials 1 Material { } }\n"
    "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 0 offset -1 } }\n";

const char* const kSun =
    "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 1 1 } }\n";

/// A closed cube of side 2 about the origin, its faces seen from outside counter-clockwise.
const char* const kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";

/// The warnings for a scene, one a line: the line of the file, ':' and the text. The scene has a
/// camera at (0, 0, 5) that looks along -z in its first line, then `text`.
std::string warningsOf(const std::string& text, const std::string& camera = "PerspectiveCamera") {
  const check::ScratchFolder folder;
  folder.write("cube.obj", kCube);
  std::string open = kCube;
  open.resize(open.rfind("f "));
  folder.write("open.obj", open);
  const std::string extent = camera == "PerspectiveCamera" ? " angle 30 }\n" : " size 4 }\n";
  const std::string file =
      folder.write("s", camera + " { center 0 0 5 direction 0 0 -1 up 0 1 0" + extent + text);
  const SceneParser scene(file.c_str());
  std::string lines;
  for (const std::string& warning : scene.getWarnings()) {
    CHECK_EQUAL(warning.substr(0, file.size() + 1), file + ":");
    lines += warning.substr(file.size() + 1) + "\n";
  }
  return lines;
}

/// A scene of one opaque, white object or more.
std::string objects(const std::string& text, int count = 1,
                    const std::string& material = "Material { }") {
  return kSun + ("Materials { numMaterials 1 " + material + " }\n") + "Group { numObjects " +
         std::to_string(count) + " MaterialIndex 0\n" + text + "\n}\n";
}

/// The same with a lamp at (0, 0, 0), in line 2, in place of the sun.
std::string lampScene(const std::string& text, const std::string& material = "Material { }") {
  std::string scene = objects(text, 1, material);
  scene.erase(0, scene.find("Materials"));
  return "Lights { numLights 1 PointLight { position 0 0 0 color 3 3 3 } }\n" + scene;
}

bool contains(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

}  // namespace

TEST("what lies wholly behind a perspective camera is named with its line") {
  // The plane through the eye is z = 5.
  CHECK_EQUAL(warningsOf(objects("\nSphere { center 0 0 6.5 radius 1 }")),
              "6: the Sphere is wholly behind the camera, and there is no mirror to show it\n");
  CHECK(contains(warningsOf(objects("Triangle { vertex0 0 0 6 vertex1 1 0 6 vertex2 0 1 5 }")),
                 "5: the Triangle is wholly behind"));
  CHECK(contains(warningsOf(objects("Transform { Translate 0 0 6.1\n"
                                    "TriangleMesh { obj_file cube.obj } }")),
                 "6: the TriangleMesh is wholly behind"));
}

TEST("what reaches in front of the camera is not said to be behind it") {
  for (const char* text : {"Sphere { center 0 0 5.5 radius 1 }", "Sphere { center 9 0 0 radius 1 }",
                           "Triangle { vertex0 0 0 6 vertex1 1 0 6 vertex2 0 1 4 }",
                           "Transform { Translate 0 0 5.9 TriangleMesh { obj_file cube.obj } }",
                           "Plane { normal 0 0 1 offset 7 }"}) {
    CHECK_EQUAL(warningsOf(objects(text)), "");
  }
}

TEST("behind the camera is told of spheres in Transforms as the ellipsoids that they are") {
  // A unit sphere scaled by (1, 1, 3) and moved to z = 5 + d reaches down to z = 5 + d - 3. Turned
  // by 90 degrees about y first, its long side lies along x and it reaches down to 5 + d - 1.
  const auto isBehind = [](const char* steps) {
    const std::string sphere = " Sphere { center 0 0 0 radius 1 } }";
    return warningsOf(objects("Transform { " + std::string(steps) + sphere)) != "";
  };
  CHECK(isBehind("Translate 0 0 8.01 Scale 1 1 3"));
  CHECK(!isBehind("Translate 0 0 7.99 Scale 1 1 3"));
  CHECK(isBehind("Translate 0 0 6.01 YRotate 90 Scale 1 1 3"));
  CHECK(!isBehind("Translate 0 0 5.99 YRotate 90 Scale 1 1 3"));
}

TEST("an orthographic camera sees behind its centre, and mirrors behind any camera") {
  const std::string sphere = "Sphere { center 0 0 9 radius 1 }";
  CHECK_EQUAL(warningsOf(objects(sphere), "OrthographicCamera"), "");
  CHECK_EQUAL(warningsOf(objects(sphere, 1, "Material { reflectiveColor 0 0 0.1 }")), "");
  CHECK(warningsOf(objects(sphere, 1, "Material { transparentColor 1 1 1 }")) != "");
}

TEST("a point light inside a closed object is named with its line") {
  const std::string text = ": with shadows it lights nothing outside\n";
  CHECK_EQUAL(warningsOf(lampScene("\nSphere { center 0 0 0.5 radius 1 }")),
              "2: the light is inside the Sphere of line 6" + text);
  CHECK_EQUAL(warningsOf(lampScene("TriangleMesh { obj_file cube.obj }")),
              "2: the light is inside the TriangleMesh of line 5" + text);
  CHECK(contains(warningsOf(lampScene("Transform { ZRotate 45 Translate 3 0 0 Scale 4 1 1\n"
                                      "TriangleMesh { obj_file cube.obj } }")),
                 "of line 6"));
}

TEST("a light that gets out, or whose inside the camera sees, is not said to be enclosed") {
  for (const char* text : {"Sphere { center 0 0 1.1 radius 1 }", "Sphere { center 0 0 0 radius 6 }",
                           "TriangleMesh { obj_file open.obj }",
                           "Transform { Translate 1.1 0 0 "
                           "TriangleMesh { obj_file cube.obj } }",
                           "Transform { UniformScale 6 TriangleMesh { obj_file cube.obj } }",
                           "Plane { normal 0 1 0 offset -1 }"}) {
    CHECK_EQUAL(warningsOf(lampScene(text)), "");
  }
  const std::string glass = "Material { transparentColor 1 1 1 }";
  CHECK_EQUAL(warningsOf(lampScene("Sphere { center 0 0 0 radius 1 }", glass)), "");
}

TEST("lights inside random ellipsoids are found as by the quadratic form") {
  // (x / a)^2 + (y / b)^2 + (z / c)^2 < 1 for the light at the origin of a moved ellipsoid; the
  // camera is 5 away, farther than any of them reaches.
  Random random(11);
  int inside = 0;
  for (int i = 0; i < 200; ++i) {
    double half[3], at[3], form = 0;
    std::string move = "Transform { Translate", scale = " Scale";
    for (int axis = 0; axis < 3; ++axis) {
      half[axis] = random.uniform(0.2, 2);
      at[axis] = random.uniform(-1, 1);
      form += (at[axis] / half[axis]) * (at[axis] / half[axis]);
      move += scene_text::word(at[axis]);
      scale += scene_text::word(half[axis]);
    }
    const std::string scene = move + scale + " Sphere { center 0 0 0 radius 1 } }";
    CHECK_EQUAL(warningsOf(lampScene(scene)) != "", form < 1);
    inside += form < 1;
  }
  CHECK(inside > 20 && inside < 180);
}

TEST("an exponent below 1 with a highlight, and colours above 1") {
  const auto of = [](const char* fields) {
    return warningsOf(objects("Sphere { center 0 0 0 radius 1 }", 1,
                              "\nPhongMaterial { " + std::string(fields) + " }"));
  };
  CHECK_EQUAL(of("specularColor 0 0 0.5\nexponent 0.5"),
              "5: exponent '0.5' is below 1: its highlight fills the lit side\n");
  CHECK_EQUAL(of("exponent 0.5"), "");
  CHECK_EQUAL(of("specularColor 1 1 1"), "");
  CHECK_EQUAL(of("specularColor 1 1 1 exponent 1"), "");
  CHECK_EQUAL(of("diffuseColor 1 1 1.5"), "4: diffuseColor is above 1 in a component\n");
  CHECK_EQUAL(of("transparentColor 0 2 0"), "4: transparentColor is above 1 in a component\n");
  CHECK_EQUAL(of("reflectiveColor 2 0 0"), "4: reflectiveColor is above 1 in a component\n");
  CHECK_EQUAL(of("specularColor 255 255 255"), "4: specularColor is above 1 in a component\n");
  CHECK_EQUAL(warningsOf(std::string(kSun) + kFloor +
                         "Background { color 0 0 1.1\n"
                         "ambientLight 1.1 0 0 }"),
              "5: color is above 1 in a component\n6: ambientLight is above 1 in a component\n");
}

TEST("materials that no object has are named, those in textures in use are not") {
  const std::string list =
      "Materials { numMaterials 5\nMaterial { }\nMaterial { }\n"
      "Checkerboard { materialIndex 0 materialIndex 1 }\nMaterial { }\n"
      "Noise { materialIndex 3 materialIndex 2 octaves 1 }\n}\n";
  const std::string group = "Group { numObjects 1 MaterialIndex ";
  const std::string sphere = " Sphere { center 0 0 0 radius 1 } }";
  CHECK_EQUAL(warningsOf(kSun + list + group + "4" + sphere), "");
  CHECK_EQUAL(warningsOf(kSun + list + group + "2" + sphere),
              "7: material 3 is not used by any object\n8: material 4 is not used by any object\n");
  CHECK_EQUAL(warningsOf(kSun + list + group + "2 MaterialIndex 4" + sphere), "");
  CHECK_EQUAL(warningsOf(kSun + list + "Group { numObjects 0 }"), "");
  const std::string inlined =
      std::string(kSun) + "Group { numObjects 2\nMaterial { }\nMaterial { }";
  CHECK_EQUAL(warningsOf(inlined + " Sphere { center 0 0 0 radius 1 }" + sphere),
              "4: the material is not used by any object\n");
}

TEST("of many of one kind five are named and the rest counted, in time that grows with them") {
  std::string spheres;
  for (int i = 0; i < 100000; ++i) spheres += "Sphere { center 0 0 9 radius 1 }\n";
  const std::string warnings = warningsOf(objects(spheres, 100000));
  CHECK_EQUAL(std::count(warnings.begin(), warnings.end(), '\n'), 6);
  CHECK(contains(warnings, "10: and 99995 more objects behind the camera\n"));
}

TEST("a scene with a mistake has no such warnings, and -check tells those of a good one") {
  const check::ScratchFolder folder;
  folder.write("s.txt", "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 30 }\n" +
                            objects("Sphere { center 0 0 9 radius 1 }"));
  const check::ProgramRun run = check::runProgram("-input s.txt -check", folder.path());
  CHECK_EQUAL(run.status, 0);
  CHECK_EQUAL(run.output, "s.txt: no mistakes found\n");
  CHECK(contains(run.errors, "raytracer: warning: s.txt:5: the Sphere is wholly behind"));
  CHECK_EQUAL(check::runProgram("-quiet -input s.txt -check", folder.path()).errors, "");
  CHECK_EQUAL(check::runProgram("-quiet -input s.txt -output o.tga", folder.path()).errors, "");
}

TEST("none of the scenes that come with the program gives a warning") {
  const std::string folder = check::testsFolder() + "/../scenes";
  for (const auto& each : std::filesystem::directory_iterator(folder)) {
    if (each.path().extension() != ".txt") continue;
    const SceneParser scene(each.path().c_str());
    CHECK_EQUAL(scene.getWarnings().empty() ? "" : scene.getWarnings()[0], "");
  }
}
