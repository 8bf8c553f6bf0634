// Meshes far from 0 look as they do at 0, by every way to ask them.
#include <iomanip>

#include "accel/compiled_scene.h"
#include "accel/grid/grid.h"
#include "image_difference.h"
#include "random.h"
#include "render/renderer.h"
#include "scene_text.h"

namespace {

constexpr int kSide = 48;

/// A bumpy sheet of 200 faces, 1 wide, around `offset`, and a camera that looks down on it.
struct Sheet {
  std::string path;
  SceneParser scene;

  explicit Sheet(const Vec3d& offset) : path(write(offset)), scene(parse(path, offset)) {}
  ~Sheet() { std::remove(path.c_str()); }

 private:
  static std::string write(const Vec3d& offset) {
    Random random(4);
    std::ostringstream obj;
    obj << std::setprecision(17);
    for (int k = 0; k < 121; ++k) {
      const Vec3d v(k % 11 * 0.1 - 0.5, k / 11 * 0.1 - 0.5, random.uniform(0, 0.06));
      const Vec3d moved = v + offset;
      obj << "v " << moved.x() << ' ' << moved.y() << ' ' << moved.z() << '\n';
    }
    for (int k = 0; k < 100; ++k) {
      const int a = k / 10 * 11 + k % 10 + 1;
      obj << "f " << a << ' ' << a + 1 << ' ' << a + 12 << ' ' << a + 11 << '\n';
    }
    return scene_text::write(obj.str(), ".obj");
  }
  static SceneParser parse(const std::string& path, const Vec3d& offset) {
    return scene_text::parseWhole(
        "PerspectiveCamera { center" + scene_text::word(offset + Vec3d(0, 0.6, 2)) +
        "direction 0 -0.3 -1 up 0 1 0 angle 30 } Lights { numLights 1 DirectionalLight { direction "
        "-0.5 -0.2 -1 color 1 1 1 } } Materials { numMaterials 1 PhongMaterial { } } Group { "
        "numObjects 1 MaterialIndex 0" +
        scene_text::mesh(path) + "}");
  }
};

/// Colours, and normals.
std::vector<Image> picturesOf(const SceneParser& scene, const Object3D& geometry) {
  std::vector<Image> images(2, Image(kSide, kSide));
  RenderTargets targets;
  targets.color = &images[0];
  targets.normals = &images[1];
  RenderOptions options;
  options.shadows = true;
  render(RayTracer(scene, geometry, options), 1, targets);
  return images;
}

std::size_t countDifferences(const std::vector<Image>& a, const std::vector<Image>& b, int most) {
  return compareImages(a[0], b[0]).pixelsOver(most) + compareImages(a[1], b[1]).pixelsOver(most);
}

}  // namespace

TEST("a bumpy mesh looks the same at any offset, with the camera moved as far") {
  const Sheet near({0, 0, 0});
  const std::vector<Image> expected = picturesOf(near.scene, *near.scene.getGroup());
  for (const Vec3d& offset : {Vec3d(5e5, 0, 0), Vec3d(5e5, 5e6, 300), Vec3d(1e9, -1e9, 1e9)}) {
    const Sheet sheet(offset);
    const Group& plain = *sheet.scene.getGroup();
    const std::vector<Image> found = picturesOf(sheet.scene, plain);
    // Double tells places at 1e9 to 1e-7: a ray in 1000 or so meets another face.
    CHECK(countDifferences(found, expected, 1) <= std::size_t(2 * kSide * kSide / 500));
    for (const SimdLevel level : {SimdLevel::baseline, SimdLevel::avx2, SimdLevel::avx512}) {
      if (availableSimd(level) != level) continue;
      const CompiledScene compiled(plain, 1, level);
      CHECK_EQUAL(countDifferences(picturesOf(sheet.scene, compiled), found, 0), 0u);
    }
    const Grid grid(plain, {7, 7, 3});
    CHECK_EQUAL(countDifferences(picturesOf(sheet.scene, grid), found, 0), 0u);
  }
}
