// Every kind of mistake in a scene or mesh, as the user of the program meets it: exit status 3, one
// line that names the file and the line, the word that is wrong, and an old image that survives.
#include <algorithm>
#include <initializer_list>

#include "check.h"
#include "run_program.h"

namespace {

/// One mistake: `right`, a piece of check::smallScene(), is replaced by `wrong`. The message must
/// name `line` and contain all `parts`.
struct Mistake {
  const char* right;
  const char* wrong;
  int line;
  std::vector<std::string> parts;
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void checkMessage(const check::ProgramRun& run, const std::string& place,
                  const std::vector<std::string>& parts) {
  const std::string prefix = "raytracer: " + place;
  CHECK_EQUAL(run.status, 3);
  CHECK_EQUAL(run.output, "");
  check::report(run.errors.compare(0, prefix.size(), prefix) == 0, __FILE__, __LINE__,
                "'" + run.errors + "' begins '" + prefix + "'");
  for (const std::string& part : parts)
    check::report(contains(run.errors, part), __FILE__, __LINE__,
                  "'" + run.errors + "' contains '" + part + "'");
}

/// Renders the small scene with each mistake, to an image that is already there.
void checkMistakes(std::initializer_list<Mistake> mistakes) {
  const check::ScratchFolder folder;
  folder.write("out.tga", "old");
  for (const Mistake& mistake : mistakes) {
    std::string scene = check::smallScene();
    const std::size_t at = scene.find(mistake.right);
    CHECK(at != std::string::npos);
    scene.replace(at, std::string(mistake.right).size(), mistake.wrong);
    folder.write("scene.txt", scene);
    const auto run = check::runProgram("-input scene.txt -output out.tga", folder.path());
    checkMessage(run, "scene.txt:" + std::to_string(mistake.line) + ": ", mistake.parts);
  }
  CHECK_EQUAL(check::contentOf(folder.file("out.tga")), "old");
  CHECK_EQUAL(folder.fileCount(), std::size_t(2));
}

/// Renders a scene with the mesh `obj`, whose line `line` is at fault.
void checkMesh(const std::string& obj, int line, const std::vector<std::string>& parts) {
  const check::ScratchFolder folder;
  std::string scene = check::smallScene();
  scene.replace(scene.find("Sphere"), std::string::npos, "TriangleMesh { obj_file m.obj } }\n");
  folder.write("scene.txt", scene);
  folder.write("m.obj", obj);
  const auto run = check::runProgram("-input scene.txt -output out.tga", folder.path());
  CHECK_EQUAL(run.status, 3);
  CHECK(contains(run.errors, "m.obj:" + std::to_string(line) + ": "));
  for (const std::string& part : parts)
    check::report(contains(run.errors, part), __FILE__, __LINE__,
                  "'" + run.errors + "' contains '" + part + "'");
  CHECK_EQUAL(folder.fileCount(), std::size_t(2));
}

}  // namespace

TEST("a missing scene and a missing mesh are named, the mesh with the line that names it") {
  const check::ScratchFolder folder;
  checkMessage(check::runProgram("-input none.txt -output out.tga", folder.path()),
               "none.txt: ", {"No such file"});
  checkMistakes({{"Sphere { center 0 0 0 radius 1 }",
                  "TriangleMesh {\n obj_file none.obj }",
                  6,
                  {"none.obj"}}});
}

TEST("bad numbers and unknown words are shown") {
  checkMistakes({{"angle 40", "angle 4O", 1, {"number", "'4O'"}},
                 {"angle 40", "angle nan", 1, {"number", "'nan'"}},
                 {"angle 40", "angle 1e999", 1, {"'1e999'"}},
                 {"color 1 1 1", "color 1 1 }", 2, {"number", "'}'"}},
                 {"numObjects 1", "numObjects 1.5", 5, {"'1.5'"}},
                 {"diffuseColor", "diffuseColour", 4, {"'diffuseColour'", "did you mean"}},
                 {"Sphere", "Shpere", 5, {"'Shpere'", "did you mean 'Sphere'"}},
                 {"Background", "Backgroud", 3, {"'Backgroud'", "did you mean 'Background'"}}});
}

TEST("counts are checked both ways, and a huge one costs nothing") {
  checkMistakes({{"numObjects 1", "numObjects 2", 5, {"2", "1"}},
                 {"numObjects 1", "numObjects 0", 5, {"0"}},
                 {"numObjects 1", "numObjects -1", 5, {"-1"}},
                 {"numObjects 1", "numObjects 2000000000", 5, {"2000000000"}},
                 {"numLights 1", "numLights 2", 2, {"2"}},
                 {"numLights 1", "numLights 0", 2, {"0"}},
                 {"numMaterials 1", "numMaterials 2", 4, {"2"}},
                 {"numMaterials 1", "numMaterials 2000000000", 4, {"2000000000"}}});
}

TEST("material indices must be there and in range") {
  checkMistakes({{"MaterialIndex 0", "MaterialIndex 1", 5, {"'1'"}},
                 {"MaterialIndex 0", "MaterialIndex -1", 5, {"'-1'"}},
                 {"MaterialIndex 0", "", 5, {"MaterialIndex"}}});
}

TEST("values that make no shape or camera are mistakes") {
  checkMistakes(
      {{"radius 1", "radius 0", 5, {"radius", "'0'"}},
       {"radius 1", "radius -2", 5, {"radius", "'-2'"}},
       {"direction 0 0 -1", "direction 0 0 0", 1, {"direction"}},
       {"direction -1 -1 -1", "direction 0 0 0", 2, {"direction"}},
       {"up 0 1 0", "up 0 0 2", 1, {"up", "parallel"}},
       {"Sphere { center 0 0 0 radius 1 }", "Plane { normal 0 0 0 offset 1 }", 5, {"normal"}}});
}

TEST("a singular transform names the step") {
  const char* sphere = "Sphere { center 0 0 0 radius 1 }";
  checkMistakes({{sphere,
                  "Transform { Translate 1 0 0\nScale 1 0 1\nSphere { center 0 0 0 radius 1 } }",
                  6,
                  {"Scale"}},
                 {sphere,
                  "Transform { UniformScale 0 Sphere { center 0 0 0 radius 1 } }",
                  5,
                  {"UniformScale"}},
                 {sphere,
                  "Transform { Rotate { 0 0 0 30 } Sphere { center 0 0 0 radius 1 } }",
                  5,
                  {"Rotate"}},
                 {sphere,
                  "Transform { Matrix { 1 0 0 0 2 0 0 0 0 0 1 0 0 0 0 1 }\n"
                  "Sphere { center 0 0 0 radius 1 } }",
                  5,
                  {"Matrix"}}});
}

TEST("sections that are missing or given twice are mistakes") {
  const std::string camera =
      "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 40 }";
  const std::string twice = camera + "\n" + camera;
  checkMistakes({{camera.c_str(), twice.c_str(), 2, {"amera"}}});
  const check::ScratchFolder folder;
  folder.write("empty.txt", "");
  checkMessage(check::runProgram("-input empty.txt -output out.tga", folder.path()),
               "empty.txt:", {"amera"});
}

TEST("a mesh's face index that is 0 or out of range is named with the mesh's line") {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  checkMesh(corners + "f 1 2 0\n", 4, {"'0'"});
  checkMesh(corners + "f 1 2 4\n", 4, {"'4'"});
  checkMesh(corners + "f 1 2 -4\n", 4, {"'-4'"});
  checkMesh(corners + "f\n", 4, {});
  checkMesh(corners + "f 1 2 x\n", 4, {"'x'"});
  checkMesh("v 0 0\n", 1, {});
  checkMesh("v 0 0 1,5\n", 1, {"'1,5'"});
}

TEST("a beginning of a scene that leaves a brace open is a mistake with a line") {
  const check::ScratchFolder folder;
  const std::string scene = check::smallScene();
  int failed = 0;
  for (std::size_t size = 1; size < scene.size(); size += 5) {  // not all, for the time it takes
    const std::string part = scene.substr(0, size);
    folder.write("part.txt", part);
    const auto run = check::runProgram("-quiet -input part.txt -output out.tga", folder.path());
    const bool balanced =
        std::count(part.begin(), part.end(), '{') == std::count(part.begin(), part.end(), '}');
    if (run.status != 0 || !balanced) checkMessage(run, "part.txt:", {});
    failed += run.status == 3;
  }
  CHECK(failed > 50);  // the scene has some 340 characters, nearly all inside braces
}
