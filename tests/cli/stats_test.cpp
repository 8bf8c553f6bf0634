// What -stats prints, and that it changes nothing.
#include <sstream>

#include "accel/compiled_scene.h"
#include "check.h"
#include "desk.h"

using check::contains;
using check::Desk;
using check::startsWith;

namespace {

/// The value in the line `name: value` of what -stats printed; "" where there is none.
std::string statsValue(const std::string& output, const std::string& name) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (startsWith(line, name + ": ")) return line.substr(name.size() + 2);
  }
  return "";
}

}  // namespace

TEST("every -simd gives the same bytes, and -stats tells which one was used") {
  const Desk desk;
  CHECK_EQUAL(desk.run("-input scene.txt -output tree.tga -accel tree").status, 0);
  for (const SimdLevel level :
       {SimdLevel::automatic, SimdLevel::baseline, SimdLevel::avx2, SimdLevel::avx512}) {
    const std::string name = nameOf(level), used = nameOf(availableSimd(level));
    const auto run = desk.run("-input scene.txt -output fast.tga -stats -simd " + name);
    CHECK_EQUAL(run.status, 0);
    CHECK_EQUAL(statsValue(run.output, "instruction set"), used);
    CHECK(contains(statsValue(run.output, "tree"), used));
    const bool lacking = level != SimdLevel::automatic && used != name;
    CHECK_EQUAL(run.errors, lacking
                                ? "raytracer: warning: -simd " + name +
                                      ": this processor does not have it; " + used + " is used\n"
                                : "");
    CHECK_EQUAL(desk.run("-input scene.txt -output x.tga -quiet -simd " + name).errors, "");
    CHECK(check::contentOf(desk.file("fast.tga")) == check::contentOf(desk.file("tree.tga")));
  }
}

TEST("-stats needs no image, and prints lines of names and values alone") {
  const Desk desk;
  const auto run = desk.run("-input scene.txt -stats -accel tree -threads 2");
  CHECK_EQUAL(run.status, 0);
  CHECK_EQUAL(run.errors, "");
  CHECK_EQUAL(statsValue(run.output, "instruction set"), "none");
  CHECK_EQUAL(statsValue(run.output, "tree"), "plain object tree");
  CHECK_EQUAL(statsValue(run.output, "threads"), "2");
  for (const char* name : {"reading", "building", "tracing", "writing"}) {
    const std::string value = statsValue(run.output, std::string("seconds ") + name);
    CHECK(!value.empty() && std::stod("0" + value) >= 0 && std::stod("0" + value) < 60);
  }
  std::istringstream lines(run.output);
  for (std::string line; std::getline(lines, line);) CHECK(contains(line, ": "));
  CHECK_EQUAL(desk.fileCount(), 1u);
}

TEST("-stats counts what the trees of a compiled scene test") {
  const Desk desk;
  // Four triangles fill a square, and so one leaf below one node. Every eye ray meets its box, that
  // of parallel rays, which go alone, and of those through one point, which go together. Every
  // shadow ray leaves it.
  desk.write("square.obj",
             "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 0 0\n"
             "f 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 5\n");
  const std::string rest =
      "center 2 5 3 direction -2 -5 -3 up 0 0 1 }\n"
      "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 1 1 } }\n"
      "Materials { numMaterials 1 PhongMaterial { } }\n"
      "Group { numObjects 1 MaterialIndex 0 TriangleMesh { obj_file square.obj } }\n";
  desk.write("parallel.txt", "OrthographicCamera { size 1 " + rest);
  desk.write("point.txt", "PerspectiveCamera { angle 10 " + rest);
  for (const char* input : {"-input parallel.txt", "-input point.txt"}) {
    for (const char* how : {"", " -simd baseline", " -threads 3"}) {
      const std::string output = desk.run(input + std::string(" -stats -size 10 10") + how).output;
      CHECK_EQUAL(statsValue(output, "primitives tested for hits"), "400");
      CHECK_EQUAL(statsValue(output, "shadow rays"), "100");
      CHECK_EQUAL(statsValue(output, "primitives tested for shadows"), "0");
    }
  }
}

TEST("-stats counts rays by kind, by pixel and by bounce, and tests") {
  const Desk desk;
  // A floor that mirrors, seen straight down by parallel rays: 10 x 10 eye rays, as many mirror
  // rays, which meet nothing, and as many shadow rays, of which nothing blocks any.
  desk.write("mirror.txt",
             "OrthographicCamera { center 0 5 0 direction 0 -1 0 up 0 0 1 size 2 }\n"
             "Lights { numLights 1 DirectionalLight { direction 1 -1 0 color 1 1 1 } }\n"
             "Materials { numMaterials 1 PhongMaterial { reflectiveColor 1 1 1 } }\n"
             "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 0 offset 0 } }\n");
  const std::string in = "-input mirror.txt -stats -size 10 10 ";
  for (const char* how : {"-accel fast", "-accel tree -threads 3", "-grid 4 4 4"}) {
    const std::string output = desk.run(in + how).output;
    CHECK_EQUAL(statsValue(output, "rays"), "300");
    for (const char* kind : {"eye rays", "mirror rays", "shadow rays", "rays to the background",
                             "rays after 0 bounces", "rays after 1 bounces"}) {
      CHECK_EQUAL(statsValue(output, kind), "100");
    }
    for (const char* kind : {"refracted rays", "shadow rays blocked", "branches ended by weight"}) {
      CHECK_EQUAL(statsValue(output, kind), "0");
    }
    CHECK_EQUAL(statsValue(output, "rays after 2 bounces"), "");
    CHECK_EQUAL(statsValue(output, "rays per pixel"), "3.000");
    CHECK(std::stod("0" + statsValue(output, "rays per second")) > 0);
    CHECK_EQUAL(statsValue(output, "primitives tested for hits"), "200");
    CHECK_EQUAL(statsValue(output, "primitives tested per ray for shadows"), "1.000");
    CHECK_EQUAL(statsValue(output, "intersection tests"), "");
  }
  CHECK_EQUAL(desk.run(in + "-output a.tga").status, 0);
  CHECK_EQUAL(desk.run("-input mirror.txt -size 10 10 -output b.tga").status, 0);
  CHECK(check::contentOf(desk.file("a.tga")) == check::contentOf(desk.file("b.tga")));
}

TEST("-stats that cannot be printed is a failed output, and so is its image") {
  const Desk desk;
  CHECK_EQUAL(desk.run("-input scene.txt -stats >/dev/full").status, 1);
  const auto run = desk.run("-input scene.txt -stats -output missing/out.tga");
  CHECK_EQUAL(run.status, 1);
  CHECK_EQUAL(run.output, "");
}
