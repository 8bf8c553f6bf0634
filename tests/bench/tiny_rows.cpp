// The mirror-ball scene from start to end, against a process that only writes the picture's file.
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "measure.h"
#include "process.h"
#include "rows.h"

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

}  // namespace

void runTinyRows(const BenchOptions& options) {
  printHeading("A tiny scene, whole runs");
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
  printRow("mirror balls, 400 x 400", "ms", seconds[0].scaled(1e3), "write only",
           seconds[1].scaled(1e3), {15, 6});
}

}  // namespace bench
