// Pictures with several samples in a pixel, and with filters.
#include "render/sampling.h"

#include <cmath>

using sampling::adaptive;
using sampling::FilterKind;
using sampling::grey;
using sampling::isSame;
using sampling::leftOf;
using sampling::parseWhole;
using sampling::Pattern;
using sampling::PlainSampling;
using sampling::renderColor;
using sampling::renderSamples;
using sampling::sampled;
using sampling::variedScene;
using sampling::whiteShapes;

TEST("an upright edge gives the part of the columns of uniform samples that it covers") {
  // Pixel 2 of 4 spans 0 to 1; its 4 columns of samples lie at 0.125, 0.375, 0.625 and 0.875.
  for (const auto& [edge, columns] : {std::pair(0.05, 0), {0.2, 1}, {0.5, 2}, {0.7, 3}, {0.9, 4}}) {
    const SceneParser scene = whiteShapes(4, 1, leftOf(edge));
    const Image image = renderColor(scene, 4, 4, sampled(Pattern::uniform, 16));
    for (int j = 0; j < 4; ++j) {
      CHECK_EQUAL(image.getPixel(1, j), grey(1));
      CHECK_EQUAL(image.getPixel(2, j), grey(columns / 4.0));
      CHECK_EQUAL(image.getPixel(3, j), grey(0));
    }
  }
}

TEST("a slanted edge gives the covered area, whatever the pattern") {
  // The line x = 0.2 + 0.5 y cuts the pixel [0, 1] x [0, 1] in a trapezoid of area 0.45. With
  // n x n cells only those on the line (at most 1.5 n + 1 of them) can be wrong; 4096 random
  // samples have a standard deviation of sqrt(0.45 x 0.55 / 4096) = 0.0078. A byte is 0.004.
  const SceneParser scene = whiteShapes(2, 1, leftOf(0.2, 0.5));
  for (const Pattern pattern : {Pattern::uniform, Pattern::jittered, Pattern::random}) {
    const Image image = renderColor(scene, 2, 2, sampled(pattern, 4096));
    const double tolerance = pattern == Pattern::random ? 0.04 : 1.5 / 64 + 0.006;
    CHECK_NEAR(image.getPixel(1, 1).r / 255.0, 0.45, tolerance);
  }
}

TEST("one uniform sample is the picture without samples") {
  const SceneParser scene = variedScene();
  const Image plain = renderColor(scene, 53, 37, RenderOptions());
  CHECK(isSame(plain, renderColor(scene, 53, 37, sampled(Pattern::uniform, 1))));
  CHECK(
      isSame(plain, renderColor(scene, 53, 37, sampled(Pattern::center, 1, FilterKind::tent, 1))));
}

TEST("central samples under a tent are weighted by the distance of their pixels") {
  // Only pixel (2, 2) is white. Radius 1.5: beside it 1 - 1 / 1.5 = 1/3, cornerwise
  // 1 - sqrt(2) / 1.5 = 0.0572; all weights together 1 + 4/3 + 4 x 0.0572.
  const SceneParser scene = whiteShapes(5, 1, "Sphere { center 0 0 0 radius 0.01 }");
  const Image image = renderColor(scene, 5, 5, sampled(Pattern::center, 1, FilterKind::tent, 1.5));
  const double corner = 1 - std::sqrt(2.0) / 1.5, all = 1 + 4 / 3.0 + 4 * corner;
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 5; ++i) {
      const int far = std::abs(i - 2), high = std::abs(j - 2);
      const double weight = far > 1 || high > 1     ? 0
                            : far == 1 && high == 1 ? corner
                            : far + high == 1       ? 1 / 3.0
                                                    : 1;
      CHECK_EQUAL(image.getPixel(i, j), grey(weight / all));
    }
  }
}

TEST("colours are averaged before they are clamped") {
  // Half of a pixel is 3 times as bright as white: the mean of 3 and 0 is shown as 1, not as 0.5.
  const SceneParser scene = parseWhole(
      "OrthographicCamera { center 0 0 9 direction 0 0 -1 up 0 1 0 size 1 }"
      "Background { color 0 0 0 ambientLight 1 1 1 } Lights { numLights 1 DirectionalLight {"
      "  direction 0 0 -1 color 2 2 2 } } Materials { numMaterials 1 PhongMaterial { } }"
      "Group { numObjects 1 MaterialIndex 0 " +
      leftOf(0) + "}");
  RenderOptions options = sampled(Pattern::uniform, 4);
  options.shadeBack = true;
  CHECK_EQUAL(renderColor(scene, 1, 1, options).getPixel(0, 0), grey(1));
}

TEST("a filter changes nothing where all is of one colour, up to the picture's border") {
  const SceneParser scene = parseWhole(
      "OrthographicCamera { center 0 0 9 direction 0 0 -1 up 0 1 0 size 1 }"
      "Background { color 0.2 0.4 0.6 } Materials { numMaterials 1 PhongMaterial { } }"
      "Group { numObjects 1 MaterialIndex 0 Sphere { center 99 0 0 radius 1 } }");
  const Image plain = renderColor(scene, 20, 17, RenderOptions());
  for (const Pattern pattern :
       {Pattern::center, Pattern::uniform, Pattern::random, Pattern::jittered})
    for (const FilterKind filter : {FilterKind::box, FilterKind::tent, FilterKind::gaussian})
      for (const double size : {0.1, 0.5, 0.9, 3.3})
        CHECK(isSame(plain, renderColor(scene, 20, 17, sampled(pattern, 9, filter, size))));
}

TEST("samples beyond the border count like any other") {
  // The edge lies 0.25 beyond the right border of 4 pixels: the box of radius 1 around the last
  // pixel's centre spans 2 of 8 columns of samples in it that are black, without them it were
  // white.
  const SceneParser scene = whiteShapes(4, 1, leftOf(2.25));
  const Image image = renderColor(scene, 4, 4, sampled(Pattern::uniform, 16, FilterKind::box, 1));
  CHECK_EQUAL(image.getPixel(3, 2), grey(7 / 8.0));
  CHECK_EQUAL(image.getPixel(2, 2), grey(1));
}

TEST("where the filter gives no sample any weight, a pixel is the mean of its own") {
  // Uniform samples lie 0.25 from the centre at the nearest.
  const SceneParser scene = variedScene();
  const Image mean = renderColor(scene, 40, 30, sampled(Pattern::uniform, 4));
  CHECK(
      isSame(mean, renderColor(scene, 40, 30, sampled(Pattern::uniform, 4, FilterKind::box, 0.2))));
  CHECK(isSame(mean,
               renderColor(scene, 40, 30, sampled(Pattern::uniform, 4, FilterKind::tent, 0.3))));
}

TEST("every pattern and filter gives the picture of its definition, for any number of threads") {
  const SceneParser scene = variedScene();
  const int width = 37, height = 21;  // no multiple of a tile; several tiles
  std::vector<RenderOptions> cases = {sampled(Pattern::random, 3, FilterKind::gaussian, 0.7),
                                      sampled(Pattern::jittered, 4, FilterKind::tent, 1.2),
                                      sampled(Pattern::uniform, 4, FilterKind::box, 0.8),
                                      sampled(Pattern::jittered, 4),
                                      adaptive(1, 16, 0.1),
                                      adaptive(4, 16, 0.05)};
  cases.back().sampling.filter = FilterKind::gaussian;
  for (const RenderOptions& options : cases) {
    const Image expected = PlainSampling(scene, options, width, height).picture();
    for (const int threads : {1, 3, 16})
      CHECK(isSame(expected, renderColor(scene, width, height, options, threads)));
  }
}

TEST("the picture of the samples has a dot of each sample's colour on a chessboard") {
  // Four samples at a quarter and three quarters of each pixel; the edge is the middle of pixel 1.
  const SceneParser scene = whiteShapes(2, 1, leftOf(0.5));
  const Image dots = renderSamples(scene, 2, 2, 8, sampled(Pattern::uniform, 4));
  CHECK_EQUAL(dots.Width(), 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const bool isDot = (x % 8 == 2 || x % 8 == 6) && (y % 8 == 2 || y % 8 == 6);
      const Rgb8 ground = (x / 8 + y / 8) % 2 == 0 ? Rgb8{51, 51, 51} : Rgb8();
      CHECK_EQUAL(dots.getPixel(x, y), isDot ? grey(x < 12 ? 1 : 0) : ground);
    }
  }
}

TEST("depth and normals are those of the centres, and all pictures come from one run") {
  const SceneParser scene = variedScene();
  const int width = 37, height = 29, zoom = 3;
  Image color(width, height), depth(width, height), normals(width, height);
  Image plainDepth(width, height), plainNormals(width, height), dots(width * zoom, height * zoom);
  RenderTargets targets;
  targets.depth = &plainDepth;
  targets.normals = &plainNormals;
  targets.depthMin = 4;
  targets.depthMax = 9;
  render(RayTracer(scene, *scene.getGroup(), RenderOptions()), 1, targets);
  targets.depth = &depth;
  targets.normals = &normals;
  targets.color = &color;
  targets.samples = &dots;
  targets.samplesZoom = zoom;
  const RenderOptions options = sampled(Pattern::random, 5, FilterKind::tent, 1);
  render(RayTracer(scene, *scene.getGroup(), options), 2, targets);
  CHECK(isSame(depth, plainDepth));
  CHECK(isSame(normals, plainNormals));
  CHECK(isSame(color, renderColor(scene, width, height, options)));
  CHECK(isSame(dots, renderSamples(scene, width, height, zoom, options)));
}

TEST("pixels come in the same order in every area that holds them, each once") {
  const PixelRectangle large = {-21, -5, 40, 37};
  std::vector<std::size_t> places(large.pixelCount(), 0);
  const std::vector<Pixel> all = pixelsInOrder(large);
  for (std::size_t k = 0; k < all.size(); ++k) {
    CHECK(large.contains(all[k]));
    places[large.index(all[k])] = k;
  }
  for (const PixelRectangle& area :
       {large, PixelRectangle{-1, -1, 2, 2}, {-20, 3, 39, 36}, {7, 7, 24, 24}, {16, 16, 32, 32}}) {
    const std::vector<Pixel> some = pixelsInOrder(area);
    CHECK_EQUAL(some.size(), area.pixelCount());
    for (std::size_t k = 1; k < some.size(); ++k)
      CHECK(places[large.index(some[k - 1])] < places[large.index(some[k])]);
  }
}

TEST("without samples beyond the border the weights that remain count alone") {
  // Two pixels, [-1, 0] and [0, 1]; white is what lies left of -1, so only beyond the picture.
  const SceneParser scene = whiteShapes(2, 1, leftOf(-1));
  RenderOptions options = sampled(Pattern::uniform, 4, FilterKind::box, 1);
  const Image bright = renderColor(scene, 2, 1, options);
  CHECK(bright.getPixel(0, 0).r > 0);
  options.sampling.hasBorderSamples = false;
  const Image dark = renderColor(scene, 2, 1, options);
  CHECK_EQUAL(dark.getPixel(0, 0), grey(0));
  // White to the left of 0: of the box of 2 x 2 pixels around the left one 2 of 3 columns of
  // samples within the picture are white; around the right one 1 of 3.
  const Image half = renderColor(whiteShapes(2, 1, leftOf(0)), 2, 1, options);
  CHECK_EQUAL(half.getPixel(0, 0), grey(2 / 3.0));
  CHECK_EQUAL(half.getPixel(1, 0), grey(1 / 3.0));
}
