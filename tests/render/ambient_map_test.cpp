// Ambient light on surfaces whose diffuse colour differs from place to place.
#include "render/shader.h"
#include "scene_text.h"
#include "shading/diffuse_map.h"
#include "shading/phong_material.h"
#include "vectors.h"

TEST("ambient light meets the colour of a map, unless the plain diffuse colour is asked for") {
  const SceneParser scene = scene_text::parse(
      "Background { ambientLight 0.5 0.25 1 }"
      "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 1 1 1 } }");
  // Without octaves and amplitude, half of each colour at x = 0.
  const NoiseMap map({1, 0, 0.5f}, {0, 1, 0.5f}, {0, 1, 0});
  PhongMaterial material({0.25f, 0.75f, 1}, {}, 1, {}, {}, 1);
  Hit hit;
  hit.record(1, &material, {0, 0, 1}, {0, 0, 0}, {});

  RenderOptions options;
  CHECK_EQUAL(Shader(scene, options).ambient(material, hit), Vec3d(0.125, 0.1875, 1));
  material.setDiffuseMap(&map);
  CHECK_EQUAL(Shader(scene, options).ambient(material, hit), Vec3d(0.25, 0.125, 0.5));
  options.isAmbientPlain = true;
  CHECK_EQUAL(Shader(scene, options).ambient(material, hit), Vec3d(0.125, 0.1875, 1));
}
