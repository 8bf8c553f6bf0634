// -nested_dielectrics and -fresnel, from the command line to the bytes of a picture.
#include "check.h"
#include "cli/request.h"
#include "run_program.h"

namespace {

/// A folder with a scene: through a closed cube, stretched to a depth of 4, a grey background and a
/// ball inside the cube are seen.
struct Desk : check::ScratchFolder {
  Desk() {
    std::string cube;
    for (int i = 0; i < 8; ++i) {
      cube += std::string("v ") + (i & 4 ? "1 " : "-1 ") + (i & 2 ? "1 " : "-1 ") +
              (i & 1 ? "1\n" : "-1\n");
    }
    write("cube.obj", cube + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n");
  }

  void writeScene(const std::string& glass, const std::string& ball) const {
    write("scene.txt",
          "OrthographicCamera { center 0.25 0 5 direction 0 0 -1 up 0 1 0 size 0.01 }"
          "Background { color 0.8 0.8 0.8 ambientLight 1 1 1 }"
          "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 0 0 0 } }"
          "Materials { numMaterials 2 Material { diffuseColor 0 0 0 " +
              glass +
              " }"
              "  Material { diffuseColor 0.4 0.4 0.4 transparentColor 0.1 0.1 0.1 } }"
              "Group { numObjects 2 MaterialIndex 0"
              "  Transform { Scale 1 1 2 TriangleMesh { obj_file cube.obj } }"
              "  MaterialIndex 1 " +
              ball + " }");
  }

  /// Blue, green and red of a picture of one pixel.
  std::string pixel(const std::string& options) const {
    const check::ProgramRun run =
        check::runProgram("-input scene.txt -output a.tga -size 1 1 " + options, path());
    CHECK_EQUAL(run.status, 0);
    CHECK_EQUAL(run.errors, "");
    std::string text;
    for (const char byte : check::contentOf(file("a.tga")).substr(18)) {
      text += std::to_string(int(static_cast<unsigned char>(byte))) + " ";
    }
    return text;
  }
};

}  // namespace

TEST("-fresnel dims a closed mesh by its depth, and no plain option does") {
  const Desk desk;
  desk.writeScene("transparentColor 0.5 0.25 1", "Sphere { center 9 0 0 radius 0.5 }");
  // 0.8 * 0.25 = 0.2 and 0.8 * 0.0625 = 0.05, once for each side; 0.8 * 0.5^4 = 0.05 and
  // 0.8 * 0.25^4 = 0.003 by depth.
  CHECK_EQUAL(desk.pixel(""), "204 12 51 ");
  CHECK_EQUAL(desk.pixel("-fresnel"), "204 0 12 ");
  CHECK_EQUAL(desk.pixel("-fresnel -nested_dielectrics -accel tree"), "204 0 12 ");
}

TEST("-nested_dielectrics looks past a ball in a closed mesh of higher priority") {
  const Desk desk;
  desk.writeScene("transparentColor 1 1 1 priority 1", "Sphere { center 0 0 0 radius 0.5 }");
  CHECK_EQUAL(desk.pixel("-nested_dielectrics"), "204 204 204 ");
  CHECK_EQUAL(desk.pixel("-nested_dielectrics -accel tree"), "204 204 204 ");
  // 0.4 + 0.1 * (0.4 + 0.1 * 0.8) = 0.448.
  CHECK_EQUAL(desk.pixel(""), "114 114 114 ");
  // Of the same priority the ball is in the cube, as a bubble is in glass.
  desk.writeScene("transparentColor 1 1 1", "Sphere { center 0 0 0 radius 0.5 }");
  CHECK_EQUAL(desk.pixel("-nested_dielectrics"), "114 114 114 ");
}

TEST("both are off unless given") {
  const auto parse = [](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"-input", "a", "-output", "b"};
    words.insert(words.end(), more.begin(), more.end());
    return parseRequest(words).render.picture.render;
  };
  CHECK(!parse({}).nestedDielectrics && !parse({}).fresnel);
  CHECK(parse({"-nested_dielectrics"}).nestedDielectrics &&
        !parse({"-nested_dielectrics"}).fresnel);
  CHECK(parse({"-fresnel"}).fresnel && !parse({"-fresnel"}).nestedDielectrics);
}
