// Tiny scenes. The mirror-ball scene runs from start to end, against a process that only writes the
// picture's file; of the project's own scenes the seconds tracing count, on one thread, as their
// own commands ask for, against another build of the program where there is one.
#include <fstream>

#include "measure.h"
#include "process.h"
#include "rows.h"
#include "scene_runs.h"

namespace bench {
namespace {

/// Two mirror balls on a plane under one directional light.
constexpr const char* kScene = R"(
PerspectiveCamera { center 0 0.5 5  direction 0 -0.1 -1  up 0 1 0  angle 30 }
Lights { numLights 1 DirectionalLight { direction 0.5 -1 0 color 0.8 0.8 0.8 } }
Background { color 0.2 0.1 0.6 ambientLight 0.2 0.2 0.2 }
Materials {
  numMaterials 3
  PhongMaterial { diffuseColor 0.1 0.1 0.1 specularColor 1 1 1 exponent 50
                  reflectiveColor 0.9 0.9 0.9 }
  PhongMaterial { diffuseColor 1 0.1 0.1 specularColor 1 1 1 exponent 50
                  reflectiveColor 0.9 0.1 0.1 }
  PhongMaterial { diffuseColor 1 1 1 }
}
Group {
  numObjects 3
  MaterialIndex 0 Sphere { center 0.3 0 -1 radius 1 }
  MaterialIndex 1 Sphere { center -0.5 -0.6 0.2 radius 0.4 }
  MaterialIndex 2 Plane { normal 0 1 0 offset -1 }
}
)";

struct TinyScene {
  const char* name;
  Target target;
};
constexpr TinyScene kScenes[] = {
    {"06_mirror_balls", {0.6, 0.4}},         {"09_glass_balls", {0.6, 0.4}},
    {"10_rose_window", {0.6, 0.4}},          {"11_nested_transforms", {0.6, 0.4}},
    {"20_still_life", {0.6, 0.4}},           {"24_marble_wood_noise", {0.6, 0.4}},
    {"25_textures_in_textures", {0.6, 0.4}}, {"27_wine_glass", {0.5, 0.3}},
};

void runMirrorBalls(const BenchOptions& options) {
  const ScratchFolder folder;
  const std::string scene = folder.file("balls.txt");
  std::ofstream(scene) << kScene;
  const std::vector<std::string> ours = {
      RAYTRACER_PROGRAM, "-input", scene, "-output",  folder.file("balls.tga"),
      "-size",           "400",    "400", "-bounces", "5",
      "-weight",         "0.01"};
  const std::vector<std::string> theirs = {WRITE_ONLY_PROGRAM, folder.file("plain.tga"), "400"};
  const std::vector<Samples> seconds = inTurns(
      20 * options.rounds,
      {[&] { return runProcess(ours).seconds; }, [&] { return runProcess(theirs).seconds; }});
  printRow("mirror balls, 400 x 400, whole", "ms", seconds[0].scaled(1e3), "write only",
           seconds[1].scaled(1e3), {4, 3});
}

}  // namespace

void runTinyRows(const BenchOptions& options) {
  printHeading("Tiny scenes");
  runMirrorBalls(options);
  for (const TinyScene& tiny : kScenes) {
    const ScratchFolder folder;
    const std::vector<std::string> arguments =
        ownCommand(tiny.name, folder.file("out.tga"), {"-threads", "1"});
    const std::vector<Samples> seconds =
        statsInTurns(options, options.rounds, arguments, "seconds tracing: ");
    printRow(std::string(tiny.name) + ", tracing", "ms", seconds[0].scaled(1e3), "-against",
             seconds[1].scaled(1e3), tiny.target);
  }
}

}  // namespace bench
