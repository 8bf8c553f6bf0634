// Colours that tell materials apart.
#include <set>

#include "check.h"
#include "render/false_colors.h"
#include "render/renderer.h"
#include "scene_text.h"
#include "shading/phong_material.h"

namespace {

unsigned packed(Rgb8 color) { return unsigned(color.r) << 16 | unsigned(color.g) << 8 | color.b; }

/// Balls of materials 1 and 0 beside each other before the camera; of number 2 there is none.
const char* const kTwoBalls =
    "Materials { numMaterials 3 PhongMaterial { } OrenNayarMaterial { } PhongMaterial { } }\n"
    "Group { numObjects 2 MaterialIndex 1 Sphere { center -0.5 0 0 radius 0.5 }\n"
    "                     MaterialIndex 0 Sphere { center 0.5 0 0 radius 0.5 } }\n";

}  // namespace

TEST("the first colours are the pure ones, in the order of counting in bits") {
  const unsigned expected[] = {0xff0000, 0x00ff00, 0xffff00, 0x0000ff,
                               0xff00ff, 0x00ffff, 0xffffff, 0x7f0000};
  for (int i = 0; i < 8; ++i) CHECK_EQUAL(packed(materialColor(i)), expected[i]);
}

TEST("no colour is black, and as many as there are others are all different") {
  constexpr int kAll = (1 << 24) - 1;
  std::vector<bool> isTaken(1 << 24);
  int taken = 0;
  for (int i = 0; i < kAll; ++i) {
    const unsigned color = packed(materialColor(i));
    taken += color != 0 && !isTaken[color];
    isTaken[color] = true;
  }
  CHECK_EQUAL(taken, kAll);
  CHECK_EQUAL(packed(materialColor(kAll)), 0xff0000u);
}

TEST("the picture shows each surface in its material's colour, and nothing in black") {
  const SceneParser scene = scene_text::parse(kTwoBalls);
  Image picture(30, 30);
  RenderTargets targets;
  targets.materials = &picture;
  render(RayTracer(scene, *scene.getGroup(), {}), 2, targets);
  // At distance 5 the picture is 2 * 5 * tan(15 degrees) = 2.7 wide: x = -0.5 is at
  // (0.5 - 0.5 / 2.7) * 30 = 9.4, x = 0.5 at 20.6.
  CHECK_EQUAL(packed(picture.getPixel(9, 15)), 0x00ff00u);
  CHECK_EQUAL(packed(picture.getPixel(20, 15)), 0xff0000u);
  CHECK_EQUAL(packed(picture.getPixel(0, 0)), 0u);
  // The samples of a pixel do not matter: it is what the ray through the centre meets.
  Image sampled(30, 30), color(30, 30);
  targets.materials = &sampled;
  targets.color = &color;
  RenderOptions options;
  options.sampling.pattern = SamplingOptions::Pattern::jittered;
  options.sampling.samples = 4;
  render(RayTracer(scene, *scene.getGroup(), options), 2, targets);
  for (int j = 0; j < 30; ++j) {
    for (int i = 0; i < 30; ++i) CHECK(sampled.getPixel(i, j) == picture.getPixel(i, j));
  }
}

TEST("the legend lists the materials that are seen, with their pixels") {
  const SceneParser scene = scene_text::parse(kTwoBalls);
  Image picture(2, 2);
  picture.setPixel(0, 0, Rgb8{0, 255, 0});
  picture.setPixel(1, 1, Rgb8{0, 255, 0});
  picture.setPixel(0, 1, Rgb8{255, 0, 0});
  CHECK_EQUAL(materialLegend(scene, picture),
              "material 0: 255 0 0, PhongMaterial, 1 pixel\n"
              "material 1: 0 255 0, OrenNayarMaterial, 2 pixels\n");
}

TEST("a material of no scene is grey") {
  const PhongMaterial material({}, {}, 1, {}, {}, 1);
  CHECK_EQUAL(packed(materialColor(material.getNumber())), 0x808080u);
}

TEST("each kind of material has the name that scene files write") {
  const char* const kinds[] = {"PhongMaterial",
                               "BlinnPhongMaterial",
                               "CookTorranceMaterial",
                               "WardMaterial",
                               "OrenNayarMaterial",
                               "Checkerboard",
                               "Noise",
                               "Marble",
                               "Wood"};
  const std::string parts = " { materialIndex 0 materialIndex 0 octaves 1";
  const SceneParser scene = scene_text::parse(
      "Materials { numMaterials 9 PhongMaterial { } BlinnPhongMaterial { } CookTorranceMaterial { "
      "} WardMaterial { } OrenNayarMaterial { } Checkerboard { materialIndex 0 materialIndex 0 }\n"
      "Noise" +
      parts + " } Marble" + parts + " frequency 1 amplitude 1 } Wood" + parts +
      " frequency 1 amplitude 1 } }\n");
  for (int i = 0; i < 9; ++i) CHECK_EQUAL(std::string(scene.getMaterial(i)->getKind()), kinds[i]);
}
