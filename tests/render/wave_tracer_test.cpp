// WaveTracer against RayTracer, ray by ray.
#include "render/wave_tracer.h"

#include "accel/compiled_scene.h"
#include "check.h"
#include "eye_rays.h"
#include "glasses.h"
#include "random.h"
#include "scene_text.h"

namespace {

/// Mirrors, glass that overlaps, lamps of both kinds, a moved ball inside glass.
SceneParser hallOfMirrors(const SceneRules& rules = {}) {
  return scene_text::parse(R"(
    Background { color 0.2 0.3 0.4 ambientLight 0.1 0.1 0.1 }
    Lights { numLights 2
      PointLight { position 3 5 4 color 0.9 0.8 0.7 attenuation 1 0.1 0 }
      DirectionalLight { direction -1 -2 -1 color 0.3 0.4 0.5 } }
    Materials { numMaterials 4
      Material { diffuseColor 0.5 0.4 0.3 reflectiveColor 0.4 0.5 0.6 }
      Material { diffuseColor 0.1 0.1 0.1 transparentColor 0.8 0.7 0.9 indexOfRefraction 1.4
                 reflectiveColor 0.2 0.2 0.2 specularColor 1 1 1 exponent 9 }
      Material { diffuseColor 0.9 0.2 0.2 }
      Material { diffuseColor 0.1 0.1 0.2 transparentColor 0.6 0.9 0.8 indexOfRefraction 1.2
                 priority -1 } }
    Group { numObjects 8
      MaterialIndex 0 Plane { normal 0 1 0 offset -1 } Plane { normal 0 0 1 offset -4 }
      MaterialIndex 1 Sphere { center 0 0 0 radius 0.9 }
      Triangle { vertex0 -2 -1 1 vertex1 -1 -1 1 vertex2 -1.5 1 0.5 }
      MaterialIndex 2 Transform { Translate 0.3 0 0 Scale 1 0.5 1 Sphere { center 0 0 0 radius 0.3 } }
      Sphere { center 1.5 -0.4 1 radius 0.5 }
      MaterialIndex 3 Sphere { center 0.6 0.3 0 radius 0.7 }
      Transform { Translate -0.8 0.4 0 Scale 1 0.7 1.2 Sphere { center 0 0 0 radius 0.6 } } })",
                           rules);
}

/// The same with solid textures: one of plain materials, one of up to four of them, and glass whose
/// cells differ.
SceneParser hallOfTextures(const SceneRules& rules = {}) {
  return scene_text::parse(R"(
    Background { color 0.2 0.3 0.4 ambientLight 0.1 0.1 0.1 }
    Lights { numLights 2
      PointLight { position 3 5 4 color 0.9 0.8 0.7 attenuation 1 0.1 0 }
      DirectionalLight { direction -1 -2 -1 color 0.3 0.4 0.5 } }
    Materials { numMaterials 9
      Material { diffuseColor 0.5 0.4 0.3 reflectiveColor 0.4 0.5 0.6 }
      Material { diffuseColor 0.1 0.1 0.1 transparentColor 0.8 0.7 0.9 indexOfRefraction 1.4
                 reflectiveColor 0.2 0.2 0.2 specularColor 1 1 1 exponent 9 }
      Material { diffuseColor 0.9 0.2 0.2 }
      Material { diffuseColor 0 0.1 0 transparentColor 0.3 0.9 0.4 indexOfRefraction 1.2 }
      Checkerboard { size 0.7 materialIndex 0 materialIndex 2 }
      Checkerboard { Transform { UniformScale 4 } materialIndex 1 materialIndex 3 }
      Noise { materialIndex 0 materialIndex 3 octaves 3 }
      Marble { materialIndex 4 materialIndex 6 octaves 2 frequency 3 amplitude 2 }
      Wood { materialIndex 1 materialIndex 7 octaves 2 frequency 9 amplitude 2 } }
    Group { numObjects 7
      MaterialIndex 4 Plane { normal 0 1 0 offset -1 }
      MaterialIndex 8 Plane { normal 0 0 1 offset -4 }
      MaterialIndex 5 Sphere { center 0 0 0 radius 0.9 }
      MaterialIndex 7 Triangle { vertex0 -2 -1 1 vertex1 -1 -1 1 vertex2 -1.5 1 0.5 }
      MaterialIndex 2 Transform { Translate 0.3 0 0 Scale 1 0.5 1 Sphere { center 0 0 0 radius 0.3 } }
      MaterialIndex 6 Sphere { center 1.5 -0.4 1 radius 0.5 }
      MaterialIndex 0 Sphere { center -1.5 1.5 0 radius 0.5 } })",
                           rules);
}

Ray eyeRay(int i, int size) {
  const int side = 16;
  const Vec3d target((i % side - 7.5) * 3 / size, (i / side - 7.5) * 3 / size, 0);
  const Vec3d eye(0, 0.2, 5);
  return {eye, normalize(target - eye)};
}

std::vector<Ray> eyeRays(int count) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) rays.push_back(eyeRay(i, 16));
  return rays;
}

/// Compares `count` rays of a batch that starts after `bounces`.
void compare(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
             int count, int bounces) {
  const RayTracer tracer(scene, geometry, options);
  WaveTracer waves(tracer);
  const std::vector<Ray> batch = eyeRays(count);
  WaveRays rays = eye_rays::tableOf(batch, waves.arena());
  HitTable hits(waves.arena(), count);
  std::vector<Vec3f> colors(batch.size());
  waves.trace(rays, bounces, hits, colors.data());
  for (int i = 0; i < count; ++i) {
    Ray ray = batch[std::size_t(i)];
    Hit hit;
    const Vec3f expected = tracer.traceRay(ray, 0, bounces, 1, 1, hit);
    CHECK(colors[std::size_t(i)] == expected);
    CHECK_EQUAL(rays.tmax[i], hit.getT());
    CHECK_EQUAL(hits.isFound(i), hit.getMaterial() != nullptr);
    if (!hits.isFound(i)) continue;
    CHECK(hits.object[i] == hit.getObject());
    CHECK(hits.material[i] == hit.getMaterial());
  }
}

}  // namespace

TEST("a batch of any size has the colours of its rays traced one by one") {
  const SceneParser scene = hallOfMirrors();
  const CompiledScene compiled(*scene.getGroup(), 1);
  for (const int count : {0, 1, 3, 4, 63, 64, 65, 511, 512, 513, RayTable::kMost}) {
    compare(scene, compiled, scene_text::bouncing(6), count, 0);
    compare(scene, *scene.getGroup(), scene_text::bouncing(6), count, 2);
  }
}

TEST("a batch obeys every option that changes a colour") {
  const SceneParser scene = hallOfMirrors();
  const CompiledScene compiled(*scene.getGroup(), 1);
  for (int choice = 0; choice < 64; ++choice) {
    RenderOptions options = scene_text::bouncing(choice % 5);
    options.shadows = (choice & 1) == 0;
    options.transparentShadows = (choice & 2) != 0;
    options.shadeBack = (choice & 4) != 0;
    options.minWeight = (choice & 8) != 0 ? 0.3f : 0.0f;
    options.nestedDielectrics = (choice & 16) != 0;
    options.fresnel = (choice & 32) != 0;
    if (choice % 3 == 0) options.epsilon.kind = Epsilon::Kind::adaptive;
    compare(scene, compiled, options, 256, 0);
  }
}

TEST("a batch obeys the rules of courses that leave backs dark and dim highlights") {
  SceneRules rules;
  rules.isWoodGrained = true;
  rules.noiseSlope = rules.marbleHeight = -1;
  for (int choice = 0; choice < 16; ++choice) {
    rules.areHighlightsEverywhere = (choice & 1) != 0;
    rules.isHighlightHalfway = rules.areHighlightsDimmed = !rules.areHighlightsEverywhere;
    const SceneParser scene = (choice & 2) != 0 ? hallOfTextures(rules) : hallOfMirrors(rules);
    const CompiledScene compiled(*scene.getGroup(), 1);
    RenderOptions options = scene_text::bouncing(5);
    options.backs =
        (choice & 4) != 0 ? RenderOptions::Backs::nothing : RenderOptions::Backs::ambient;
    options.shadeBack = (choice & 8) != 0;
    compare(scene, compiled, options, 256, 0);
  }
}

TEST("a batch finds the surfaces behind those that change nothing") {
  const SceneParser scene = scene_text::parse(R"(
    Materials { numMaterials 2 Material { transparentColor 1 1 1 indexOfRefraction 1.2 priority 1 }
      Material { transparentColor 1 1 1 indexOfRefraction 2 } }
    Group { numObjects 3 MaterialIndex 0 Sphere { center 0 0 0 radius 20 }
      MaterialIndex 1 Sphere { center 0.3 0 0 radius 0.8 } Sphere { center -0.3 0 1 radius 0.8 } })");
  RenderOptions options;
  options.nestedDielectrics = true;
  const RayTracer tracer(scene, *scene.getGroup(), options);
  WaveTracer waves(tracer);
  const std::vector<Ray> batch = eyeRays(256);
  WaveRays rays = eye_rays::tableOf(batch, waves.arena());
  WaveRays coloredRays = eye_rays::tableOf(batch, waves.arena());
  HitTable hits(waves.arena(), 256), coloredHits(waves.arena(), 256);
  std::vector<Vec3f> colors(256);
  waves.intersect(rays, hits);
  waves.trace(coloredRays, 0, coloredHits, colors.data());
  int passedOver = 0;
  for (int i = 0; i < 256; ++i) {
    Hit first;
    scene.getGroup()->intersect(batch[std::size_t(i)], first, 0);
    passedOver += first.getT() < 10;
    CHECK(hits.isFound(i) && rays.tmax[i] > 20);  // the far side of the outer ball
    CHECK_EQUAL(coloredRays.tmax[i], rays.tmax[i]);
  }
  CHECK(passedOver > 100);
}

TEST("a batch has the colours of its rays where balls of glass overlap at random") {
  // Weak and strong ones, of which the strong hide some surfaces of the weak, inside of a cube of
  // glass with open panes and something opaque.
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    std::string balls;
    for (int i = 0; i < 8; ++i) {
      balls += "MaterialIndex " + std::to_string(i % 4) +
               glasses::ball(random.inCube(-1, 1), random.uniform(0.3, 0.9));
    }
    const SceneParser scene = scene_text::parse(R"(
      Background { color 0.2 0.3 0.4 ambientLight 0.1 0.1 0.1 }
      Lights { numLights 2 DirectionalLight { direction -1 -2 -1 color 0.3 0.4 0.5 }
        PointLight { position 0.1 0.2 0.1 color 0.9 0.8 0.7 } }
      Materials { numMaterials 5
        Material { transparentColor 0.8 0.7 0.9 indexOfRefraction 1.4 diffuseColor 0.1 0.1 0.1 }
        Material { transparentColor 0.9 0.5 0.7 indexOfRefraction 1.2 priority 1 }
        Material { transparentColor 0.6 0.9 0.8 indexOfRefraction 1.3 priority -1 }
        Material { transparentColor 0.9 0.9 0.6 indexOfRefraction 1.6 diffuseColor 0.1 0 0 }
        Material { diffuseColor 0.5 0.4 0.3 } }
      Group { numObjects 11 )" + balls + R"(
        MaterialIndex 4 Plane { normal 0 1 0 offset -1.5 } Sphere { center 0.5 0 0 radius 0.2 }
        MaterialIndex 0 Triangle { vertex0 -2 -1 1 vertex1 1 -1 1 vertex2 -1.5 1 0.5 } })");
    const CompiledScene compiled(*scene.getGroup(), 1);
    for (const bool isFresnel : {false, true}) {
      RenderOptions options = scene_text::bouncing(4);
      options.fresnel = isFresnel;
      options.nestedDielectrics = !isFresnel || round % 2 == 0;
      options.transparentShadows = true;
      compare(scene, compiled, options, 256, 0);
    }
  }
}

TEST("the compiled scene and the plain tree give the same colours with every kind of glass") {
  const SceneParser scene = hallOfMirrors();
  const CompiledScene compiled(*scene.getGroup(), 1);
  RenderOptions options = scene_text::bouncing(6);
  options.nestedDielectrics = options.fresnel = true;
  const RayTracer fast(scene, compiled, options), tree(scene, *scene.getGroup(), options);
  for (int i = 0; i < 256; ++i) {
    Hit a, b;
    Ray ray = eyeRay(i, 16);
    CHECK(fast.traceRay(ray, 0, 0, 1, 1, a) == tree.traceRay(ray, 0, 0, 1, 1, b));
  }
}

TEST("a batch with textures has the colours of its rays traced one by one") {
  const SceneParser scene = hallOfTextures();
  const CompiledScene compiled(*scene.getGroup(), 1);
  for (const int count : {1, 4, 63, 255, 256, RayTable::kMost}) {
    compare(scene, compiled, scene_text::bouncing(4), count, 0);
    compare(scene, *scene.getGroup(), scene_text::bouncing(4), count, 2);
  }
  for (int choice = 0; choice < 32; ++choice) {
    RenderOptions options = scene_text::bouncing(choice % 4);
    options.transparentShadows = (choice & 1) != 0;
    options.shadeBack = (choice & 2) != 0;
    options.nestedDielectrics = (choice & 8) != 0;
    options.fresnel = (choice & 16) != 0;
    options.minWeight = (choice & 4) != 0 ? 0.3f : 0.0f;
    compare(scene, compiled, options, 256, 0);
  }
}

TEST("a batch goes on alone where the generations end") {
  const SceneParser scene = scene_text::parse(R"(
    Materials { numMaterials 1 Material { diffuseColor 0.1 0.2 0.3 reflectiveColor 1 1 1 } }
    Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 1 1 1 } }
    Group { numObjects 2 MaterialIndex 0
      Plane { normal 0 0 1 offset -1 } Plane { normal 0 0 -1 offset -9 } })");
  compare(scene, *scene.getGroup(), scene_text::bouncing(200), 256, 0);
}
