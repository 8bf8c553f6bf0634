// How many rays each pixel takes.
#include <algorithm>
#include <numeric>

#include "accel/compiled_scene.h"
#include "check.h"
#include "render/false_colors.h"
#include "render/ray_counts.h"
#include "render/renderer.h"
#include "scene_text.h"

namespace {

using Pattern = SamplingOptions::Pattern;

/// The camera of scene_text at z = 5 between mirrors at z = -1 and z = 9 that face each other;
/// light falls along -z.
const char* const kFacingMirrors =
    "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 1 1 1 } }\n"
    "Materials { numMaterials 1 PhongMaterial { reflectiveColor 0.5 0.5 0.5 } }\n"
    "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 0 1 offset -1 }\n"
    "                                     Plane { normal 0 0 -1 offset -9 } }\n";

/// A glass ball over a mirror, beside the background.
const char* const kGlassAndMirror =
    "Lights { numLights 2 DirectionalLight { direction -1 -1 -1 color 1 1 1 }\n"
    "                     PointLight { position 3 3 3 color 1 1 1 } }\n"
    "Materials { numMaterials 2 PhongMaterial { reflectiveColor 0.2 0.2 0.2 transparentColor 0.8 "
    "0.8 0.8 indexOfRefraction 1.5 } PhongMaterial { reflectiveColor 0.5 0.5 0.5 } }\n"
    "Group { numObjects 2 MaterialIndex 0 Sphere { center 0 0 0 radius 0.7 }\n"
    "                     MaterialIndex 1 Sphere { center 0 -10.7 0 radius 10 } }\n";

RenderOptions sampledBy(Pattern pattern) {
  RenderOptions options;
  options.sampling.pattern = pattern;
  options.sampling.samples = 4;
  options.sampling.maxSamples = 16;
  options.sampling.tolerance = 0.1;
  return options;
}

}  // namespace

TEST("every ray of a pixel counts, shadow rays too") {
  // Three rays, to the first mirror, to the second, to the first; only that one faces the lamp, and
  // is asked for twice: 5 rays.
  const SceneParser scene = scene_text::parse(kFacingMirrors);
  const auto counts =
      countRays(RayTracer(scene, *scene.getGroup(), scene_text::bouncing(2)), 1, 3, 2);
  CHECK_EQUAL(counts.size(), std::size_t(6));
  for (const std::uint32_t count : counts) CHECK_EQUAL(count, 5u);
  RenderOptions dark = scene_text::bouncing(2);
  dark.shadows = false;
  for (const std::uint32_t count : countRays(RayTracer(scene, *scene.getGroup(), dark), 1, 3, 2))
    CHECK_EQUAL(count, 3u);
  // Four samples, each like that; a filter that looks at the neighbours changes nothing.
  RenderOptions sampled = sampledBy(Pattern::jittered);
  sampled.maxBounces = 2;
  sampled.sampling.filterSize = 3;
  for (const std::uint32_t count : countRays(RayTracer(scene, *scene.getGroup(), sampled), 1, 3, 2))
    CHECK_EQUAL(count, 20u);
}

TEST("the counts are the same for any number of threads, compiled or not") {
  const SceneParser scene = scene_text::parse(kGlassAndMirror);
  const CompiledScene compiled(*scene.getGroup(), 1);
  for (const Pattern pattern : {Pattern::center, Pattern::random, Pattern::adaptive}) {
    const RenderOptions options = sampledBy(pattern);
    const auto counts = countRays(RayTracer(scene, *scene.getGroup(), options), 1, 50, 40);
    CHECK(counts == countRays(RayTracer(scene, compiled, options), 3, 50, 40));
    CHECK(*std::max_element(counts.begin(), counts.end()) > 20);
  }
}

TEST("all pixels together take as many rays as are counted for the picture") {
  const SceneParser scene = scene_text::parse(kGlassAndMirror);
  for (const Pattern pattern : {Pattern::center, Pattern::jittered}) {
    const RenderOptions options = sampledBy(pattern);
    const RayTracer tracer(scene, *scene.getGroup(), options);
    const auto counts = countRays(tracer, 2, 50, 40);
    Image image(50, 40);
    RenderTargets targets;
    targets.color = &image;
    RayCounts rays;
    render(tracer, 1, targets, &rays);
    CHECK_EQUAL(std::accumulate(counts.begin(), counts.end(), std::uint64_t(0)), rays.total());
  }
}

TEST("pixels whose colours differ take more rays under adaptive samples") {
  const SceneParser scene = scene_text::parse(
      "Materials { numMaterials 1 PhongMaterial { } }\n"
      "Group { numObjects 1 MaterialIndex 0 Sphere { center 0 0 0 radius 0.7 } }\n");
  const RayTracer tracer(scene, *scene.getGroup(), sampledBy(Pattern::adaptive));
  const auto counts = countRays(tracer, 2, 40, 40);
  // White without a lamp: one ray for each sample, 4 where all is alike, 16 at the edge.
  CHECK_EQUAL(counts[0], 4u);
  CHECK_EQUAL(counts[20 * 40 + 20], 4u);
  CHECK_EQUAL(*std::max_element(counts.begin(), counts.end()), 16u);
}

TEST("the scale runs from black over blue, green and yellow to red at the most") {
  // Of 8: 0, 1/4, 1/2, 3/4, 1, and 1/8, halfway between black and blue.
  Image picture(3, 2);
  CHECK_EQUAL(drawHeatmap({0, 2, 4, 6, 8, 1}, picture),
              "heatmap: 0 to 8 rays in a pixel, 3.5 on average\n"
              "heatmap: black 0, blue 2, green 4, yellow 6, red 8\n");
  const Rgb8 expected[] = {{0, 0, 0},     {0, 0, 255}, {0, 255, 0},
                           {255, 255, 0}, {255, 0, 0}, {0, 0, 127}};
  for (int k = 0; k < 6; ++k) CHECK(picture.getPixel(k % 3, k / 3) == expected[k]);
}
