// Small pictures of a scene, which must be the same whichever way its objects are asked.
#pragma once
#include <string>

#include "accel/compiled_scene.h"
#include "fuzz.h"
#include "image/picture_file.h"
#include "render/renderer.h"
#include "scene/scene_parser.h"

namespace fuzz {

inline constexpr int kWidth = 8, kHeight = 6;

/// Options from the bits of one byte, in place of those of a course; the rarer ones go with
/// combinations of others.
inline RenderOptions optionsFrom(unsigned choice, RenderOptions options = {}) {
  options.transparentShadows = (choice & 1) != 0;
  options.shadeBack = (choice & 2) != 0;
  options.maxBounces = int(choice >> 2 & 3);
  options.shadows = (choice & 16) == 0;
  if ((choice & 32) != 0) options.epsilon.kind = Epsilon::Kind::fixed;
  if ((choice & 64) != 0) options.epsilon.kind = Epsilon::Kind::adaptive;
  if ((choice & 128) != 0) options.minWeight = 0;
  options.fresnel = (choice & 129) == 129;
  options.nestedDielectrics = (choice & 130) == 130;
  return options;
}

/// The colour, depth and normal images, one after the other.
inline Bytes pictures(const SceneParser& scene, const Object3D& geometry,
                      const RenderOptions& options) {
  Image color(kWidth, kHeight), depth(kWidth, kHeight), normals(kWidth, kHeight);
  RenderTargets targets;
  targets.color = &color;
  targets.depth = &depth;
  targets.normals = &normals;
  targets.depthMax = 10;
  render(RayTracer(scene, geometry, options), 1, targets);
  Bytes all;
  for (const Image* image : {&color, &depth, &normals}) {
    const Bytes bytes = encodePicture(*image, PictureFormat::tga);
    all.insert(all.end(), bytes.begin(), bytes.end());
  }
  return all;
}

/// Demands that the tree, with every instruction set, gives the bytes that the plain objects give.
inline void comparePictures(SceneParser& scene, const RenderOptions& options) {
  const bool asksMedia = options.transparentShadows || options.fresnel || options.nestedDielectrics;
  if (asksMedia) scene.findSolids();
  const Bytes plain = pictures(scene, *scene.getGroup(), options);
  for (const SimdLevel level : {SimdLevel::baseline, SimdLevel::avx2, SimdLevel::avx512}) {
    if (availableSimd(level) != level) continue;
    const CompiledScene compiled(*scene.getGroup(), 1, level);
    demand(pictures(scene, compiled, options) == plain,
           std::string("the picture by ") + nameOf(level) + " is that of the plain objects");
  }
}

}  // namespace fuzz
