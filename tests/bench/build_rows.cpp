// Building: time, scaling, and memory. Every memory figure comes from a process of its own.
#include <cstdio>
#include <stdexcept>

#include "child.h"
#include "geometry/triangle_mesh.h"
#include "measure.h"
#include "mesh.h"
#include "process.h"
#include "rivals/embree_scene.h"
#include "rows.h"
#include "shading/phong_material.h"
#include "system/worker_threads.h"

namespace bench {
namespace {

/// What a build keeps and takes at its height, in bytes; `resident` is the growth of the process.
struct BuildMemory {
  double kept = 0, peak = 0, resident = 0;
};

const PhongMaterial& anyMaterial() {
  static const PhongMaterial material({1, 1, 1}, {0, 0, 0}, 1, {0, 0, 0}, {0, 0, 0}, 1);
  return material;
}

BuildMemory memoryInChild(const std::string& side, const Size& size, const BenchOptions& options) {
  const std::string line =
      outputOf({ownProgram(), "_child", "build", side, size.name, nameOf(options.simd)});
  BuildMemory memory;
  if (std::sscanf(line.c_str(), "%lf %lf %lf", &memory.kept, &memory.peak, &memory.resident) != 3) {
    throw std::runtime_error("the child that builds said: " + line);
  }
  return memory;
}

double secondsToBuild(const BenchOptions& options, const TriangleMesh& mesh, int threads) {
  std::unique_ptr<CompiledScene> scene;
  return secondsOf(options.clock, threads,
                   [&] { scene = std::make_unique<CompiledScene>(mesh, threads, options.simd); });
}

double secondsToBuildEmbree(const BenchOptions& options, const MeshGeometry& mesh, int threads) {
  EmbreeScene scene(mesh, threads);
  return secondsOf(options.clock, threads, [&] { scene.build(); });
}

void printTimes(const BenchOptions& options, const Size& size, const TriangleMesh& mesh) {
  const MeshGeometry& geometry = mesh.getGeometry();
  std::vector<int> threadCounts = {1};
  if (hardwareThreads() > 1) threadCounts.push_back(hardwareThreads());
  std::vector<std::function<double()>> contenders;
  for (const int threads : threadCounts) {
    contenders.push_back([&, threads] { return secondsToBuild(options, mesh, threads); });
    if (!EmbreeScene::isAvailable()) continue;
    contenders.push_back([&, threads] { return secondsToBuildEmbree(options, geometry, threads); });
  }
  const std::vector<Samples> seconds = inTurns(options.rounds, contenders);
  const std::size_t perCount = contenders.size() / threadCounts.size();
  const double millions = double(geometry.faceCount()) / 1e6;
  for (std::size_t i = 0; i < threadCounts.size(); ++i) {
    const Samples& ours = seconds[i * perCount];
    const Samples theirs = perCount > 1 ? seconds[i * perCount + 1] : Samples();
    const std::string label = "build " + size.name + ", " + std::to_string(threadCounts[i]) +
                              (threadCounts[i] == 1 ? " thread" : " threads");
    printRow(label, "ms", ours.scaled(1e3), "Embree", theirs.scaled(1e3), {0.6, 0});
    printRow(label, "Mtri/s", ours.inverted(millions), "Embree", theirs.inverted(millions));
  }
  if (threadCounts.size() > 1 && options.clock == Clock::wall) {
    std::printf("%-34s %d threads are %.2f times one (must 1.85)\n", "build", threadCounts[1],
                seconds[0].median() / seconds[perCount].median());
  }
}

void printMemory(const BenchOptions& options, const Size& size, double triangles) {
  const BuildMemory ours = memoryInChild("ours", size, options);
  const BuildMemory theirs =
      EmbreeScene::isAvailable() ? memoryInChild("embree", size, options) : BuildMemory();
  const auto row = [&](const char* name, double mine, double rival, Target target) {
    Samples a, b;
    a.add(mine / triangles);
    if (EmbreeScene::isAvailable()) b.add(rival / triangles);
    printRow(std::string(name) + size.name, "B/tri", a, "Embree", b, target);
  };
  row("bytes kept, ", ours.kept, theirs.kept, {1.0, 0.7});
  row("bytes at peak, ", ours.peak, theirs.peak, {1.0, 0.7});
  row("(growth of the process), ", ours.resident, theirs.resident, {});
}

}  // namespace

void runBuildRows(const BenchOptions& options) {
  printHeading("Building");
  for (const Size& size : options.sizes) {
    const MeshGeometry geometry = displacedSphere(cutsForTriangles(size.triangles));
    const TriangleMesh mesh(&geometry, &anyMaterial());
    printTimes(options, size, mesh);
    printMemory(options, size, double(geometry.faceCount()));
  }
}

void measureBuildMemory(const std::string& side, double triangles, SimdLevel simd) {
  const MeshGeometry geometry = displacedSphere(cutsForTriangles(triangles));
  if (side == "ours") {
    const TriangleMesh mesh(&geometry, &anyMaterial());
    const double before = startPeakMemory();
    const CompiledScene scene(mesh, hardwareThreads(), simd);
    const double grown = peakMemory() - before;
    std::printf("%.0f %.0f %.0f\n", double(scene.treeBytes()), grown, grown);
  } else {
    EmbreeScene scene(geometry, hardwareThreads());
    const double before = startPeakMemory();
    scene.build();
    const double grown = peakMemory() - before;
    std::printf("%.0f %.0f %.0f\n", double(scene.keptBytes()), double(scene.peakBytes()), grown);
  }
}

}  // namespace bench
