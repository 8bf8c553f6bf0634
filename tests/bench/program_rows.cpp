// Whole runs on a mesh, a mirror floor and a glass ball: our program and the rival's, in turns.
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "child.h"
#include "image/picture_file.h"
#include "measure.h"
#include "mesh.h"
#include "process.h"
#include "program_scene.h"
#include "render/renderer.h"
#include "rows.h"
#include "system/worker_threads.h"

namespace bench {
namespace {

constexpr const char* kPhases[] = {"read", "build", "trace", "write"};

struct ProgramSamples {
  Samples seconds, peak, phases[4];

  void add(const Run& run) {
    seconds.add(run.seconds);
    peak.add(run.peakBytes / 1e6);
  }
  void addPhases(const std::string& line) {
    double values[4];
    if (std::sscanf(line.c_str(), "%lf %lf %lf %lf", values, values + 1, values + 2, values + 3) !=
        4) {
      throw std::runtime_error("expected four times, found: " + line);
    }
    for (int i = 0; i < 4; ++i) phases[i].add(values[i]);
  }
};

/// Where EMBREE_TRACER is not built, "".
std::string rivalProgram() {
#ifdef EMBREE_TRACER
  return EMBREE_TRACER;
#else
  return "";
#endif
}

std::string contentOf(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

class ProgramRows {
 public:
  ProgramRows(const BenchOptions& options, const Size& size) : options_(options), size_(size) {
    writeObj(displacedSphere(cutsForTriangles(size.triangles)), folder_.file("mesh.obj"));
    std::ofstream(folder_.file("scene.txt")) << programScene("mesh.obj");
  }

  void run() {
    for (int round = 0; round < options_.rounds; ++round) {
      runOurs();
      if (!rivalProgram().empty()) runTheirs();
    }
    print();
  }

 private:
  void runOurs() {
    const std::string side = std::to_string(options_.side);
    ours_.add(runFresh({RAYTRACER_PROGRAM, "-input", folder_.file("scene.txt"), "-output",
                        folder_.file("ours.tga"), "-size", side, side, "-bounces",
                        std::to_string(kBounces), "-weight", "0.01", "-quiet"}));
    ours_.addPhases(outputOf({ownProgram(), "_child", "phases", folder_.file("scene.txt"),
                              folder_.file("phases.tga"), side, nameOf(options_.simd)}));
  }
  void runTheirs() {
    const std::string output = folder_.file("phases");
    theirs_.add(runFresh({rivalProgram(), folder_.file("mesh.obj"), folder_.file("theirs.tga"),
                          std::to_string(options_.side)},
                         output));
    theirs_.addPhases(contentOf(output));
  }
  void print() const;
  void printDifference() const;

  const BenchOptions& options_;
  const Size& size_;
  const ScratchFolder folder_;
  ProgramSamples ours_, theirs_;
};

void ProgramRows::print() const {
  const std::string label = "program, " + size_.name;
  printRow(label, "s", ours_.seconds, "E1 tracer", theirs_.seconds,
           size_.name == "10m" ? Target{0.65, 0.55} : Target{0.72, 0.6});
  for (int i = 0; i < 4; ++i) {
    const bool isTracing = kPhases[i] == std::string("trace");
    printRow("  " + std::string(kPhases[i]), "s", ours_.phases[i], "E1 tracer", theirs_.phases[i],
             isTracing ? Target{0.7, 0.55} : Target{});
  }
  printRow("  peak memory", "MB", ours_.peak, "E1 tracer", theirs_.peak, {0.6, 0.5});
  if (!rivalProgram().empty()) printDifference();
}

/// Both programs must have drawn the same scene: float rounding moves a few edges.
void ProgramRows::printDifference() const {
  const Image ours = readImage(folder_.file("ours.tga")),
              theirs = readImage(folder_.file("theirs.tga"));
  int different = 0;
  for (int y = 0; y < ours.Height(); ++y) {
    for (int x = 0; x < ours.Width(); ++x) {
      const Rgb8 p = ours.getPixel(x, y), q = theirs.getPixel(x, y);
      const int most = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
      different += most > 8;
    }
  }
  std::printf("%36s%d of %d pixels differ by more than 8 of 255\n", "", different,
              ours.Width() * ours.Height());
}

}  // namespace

void runProgramRows(const BenchOptions& options) {
  printHeading("Whole program: mesh, mirror floor, glass ball, one light, 5 bounces");
  for (const Size& size : options.sizes) {
    ProgramRows rows(options, size);
    rows.run();
  }
}

void measurePhases(const std::string& scene, const std::string& image, int side, SimdLevel simd) {
  std::unique_ptr<SceneParser> parser;
  std::unique_ptr<CompiledScene> compiled;
  Image picture(side, side);
  const int threads = hardwareThreads();
  const double phases[] = {
      secondsOf(Clock::wall, 1, [&] { parser = std::make_unique<SceneParser>(scene.c_str()); }),
      secondsOf(
          Clock::wall, 1,
          [&] { compiled = std::make_unique<CompiledScene>(*parser->getGroup(), threads, simd); }),
      secondsOf(Clock::wall, 1,
                [&] {
                  RenderTargets targets;
                  targets.color = &picture;
                  render(RayTracer(*parser, *compiled, RenderOptions()), threads, targets);
                }),
      secondsOf(Clock::wall, 1, [&] { writePicture(picture, image); })};
  std::printf("%.6f %.6f %.6f %.6f\n", phases[0], phases[1], phases[2], phases[3]);
}

}  // namespace bench
