// Every scene in scenes/ looks the same through a grid.
#include <algorithm>
#include <filesystem>
#include <vector>

#include "accel/compiled_scene.h"
#include "accel/grid/grid.h"
#include "check.h"
#include "render/renderer.h"

namespace {

constexpr int kSide = 24;

std::vector<std::string> sceneFiles() {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(check::testsFolder() + "/../scenes")) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Colour, depth and normals.
std::vector<Image> picturesOf(const SceneParser& scene, const Object3D& geometry,
                              const RenderOptions& options) {
  std::vector<Image> images(3, Image(kSide, kSide));
  RenderTargets targets;
  targets.color = &images[0];
  targets.depth = &images[1];
  targets.normals = &images[2];
  targets.depthMax = 20;
  render(RayTracer(scene, geometry, options), 2, targets);
  return images;
}

int countDifferences(const std::vector<Image>& a, const std::vector<Image>& b) {
  int count = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (int i = 0; i < kSide * kSide; ++i) {
      count += !(a[k].getPixel(i % kSide, i / kSide) == b[k].getPixel(i % kSide, i / kSide));
    }
  }
  return count;
}

}  // namespace

TEST("through grids of several sizes each scene in scenes/ has the bytes of the compiled scene") {
  const std::vector<std::string> files = sceneFiles();
  CHECK(files.size() >= 20);
  for (const std::string& file : files) {
    SceneParser scene(file.c_str());
    scene.findSolids();
    const CompiledScene compiled(*scene.getGroup(), 2);
    RenderOptions options;
    options.maxBounces = 4;
    for (const GridSize& size : {GridSize{1, 1, 1}, GridSize{20, 20, 20}, GridSize{64, 3, 17}}) {
      const Grid grid(*scene.getGroup(), size);
      options.transparentShadows = !options.transparentShadows;
      options.epsilon.kind =
          options.transparentShadows ? Epsilon::Kind::adaptive : Epsilon::Kind::automatic;
      const int differences =
          countDifferences(picturesOf(scene, grid, options), picturesOf(scene, compiled, options));
      CHECK_EQUAL(differences == 0 ? "" : file + ", " + grid.describe(), "");
    }
  }
}
