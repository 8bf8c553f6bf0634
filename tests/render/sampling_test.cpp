// Pictures with several samples in a pixel, and with filters.
#include <algorithm>
#include <cmath>

#include "render/adaptive_sampling.h"
#include "render/film.h"
#include "render/renderer.h"
#include "scene_text.h"

static std::ostream& operator<<(std::ostream& out, Rgb8 value) {
  return out << int(value.r) << ' ' << int(value.g) << ' ' << int(value.b);
}

namespace {

using Pattern = SamplingOptions::Pattern;
using FilterKind = SamplingOptions::FilterKind;

/// A scene without the camera that scene_text::parse brings.
SceneParser parseWhole(const std::string& text) {
  const std::string path = scene_text::write(text, ".txt");
  struct Remover {
    const std::string& path;
    ~Remover() { std::remove(path.c_str()); }
  } remover{path};
  return SceneParser(path.c_str());
}

/// Shapes that are white all over, on black, as an orthographic camera sees `size` units of them.
SceneParser whiteShapes(double size, int count, const std::string& shapes) {
  return parseWhole("OrthographicCamera { center 0 0 9 direction 0 0 -1 up 0 1 0 size" +
                    scene_text::word(size) +
                    "} Background { color 0 0 0 } Materials { numMaterials 1 PhongMaterial { } }"
                    "Group { numObjects " +
                    std::to_string(count) + " MaterialIndex 0 " + shapes + "}");
}

/// Everything to the left of the line x = a + slope y, as far as 100 units.
std::string leftOf(double a, double slope = 0) {
  return "Triangle { vertex0" + scene_text::word(Vec3d(a - 100 * slope, -100, 0)) + "vertex1" +
         scene_text::word(Vec3d(a + 100 * slope, 100, 0)) + "vertex2 -300 0 0 }";
}

/// Balls, glass and a mirror with a point light, over a floor.
SceneParser variedScene() {
  return parseWhole(
      "PerspectiveCamera { center 0 1 6 direction 0 -0.1 -1 up 0 1 0 angle 40 }"
      "Lights { numLights 1 PointLight { position 3 5 4 color 1 1 1 } }"
      "Background { color 0.2 0.3 0.5 ambientLight 0.1 0.1 0.1 }"
      "Materials { numMaterials 2 PhongMaterial { reflectiveColor 0.5 0.5 0.5 }"
      "  PhongMaterial { transparentColor 0.8 0.8 0.8 indexOfRefraction 1.5 } }"
      "Group { numObjects 3 MaterialIndex 0 Plane { normal 0 1 0 offset -1 }"
      "  Sphere { center 1 0 0 radius 1 } MaterialIndex 1 Sphere { center -1 0 1 radius 1 } }");
}

RenderOptions sampled(Pattern pattern, int samples, FilterKind filter = FilterKind::box,
                      double size = 0.5) {
  RenderOptions options;
  options.sampling.pattern = pattern;
  options.sampling.samples = options.sampling.maxSamples = samples;
  options.sampling.filter = filter;
  options.sampling.filterSize = size;
  return options;
}

RenderOptions adaptive(int least, int most, double tolerance) {
  RenderOptions options = sampled(Pattern::adaptive, least);
  options.sampling.maxSamples = most;
  options.sampling.tolerance = tolerance;
  return options;
}

Image renderColor(const SceneParser& scene, int width, int height, const RenderOptions& options,
                  int threads = 1) {
  Image image(width, height);
  RenderTargets targets;
  targets.color = &image;
  render(scene, *scene.getGroup(), options, threads, targets);
  return image;
}

Image renderSamples(const SceneParser& scene, int width, int height, int zoom,
                    const RenderOptions& options) {
  Image image(width * zoom, height * zoom);
  RenderTargets targets;
  targets.samples = &image;
  targets.samplesZoom = zoom;
  render(scene, *scene.getGroup(), options, 1, targets);
  return image;
}

bool isSame(const Image& a, const Image& b) {
  if (a.Width() != b.Width() || a.Height() != b.Height()) return false;
  for (int y = 0; y < a.Height(); ++y)
    for (int x = 0; x < a.Width(); ++x)
      if (a.getPixel(x, y) != b.getPixel(x, y)) return false;
  return true;
}

Rgb8 grey(double value) {
  const auto byte = std::uint8_t(value * 255);
  return {byte, byte, byte};
}

/// The picture by the definition: every pixel on its own, every ray on its own.
class PlainSampling {
 public:
  PlainSampling(const SceneParser& scene, const RenderOptions& options, int width, int height)
      : scene_(scene),
        options_(options),
        tracer_(scene, *scene.getGroup(), options),
        sampler_(makeSampler(options.sampling)),
        filter_(makeFilter(options.sampling)),
        width_(width),
        height_(height) {}

  Image picture() const {
    Image image(width_, height_);
    for (int j = 0; j < height_; ++j)
      for (int i = 0; i < width_; ++i) image.setPixel(i, j, pixelColor(i, j));
    return image;
  }

  /// By the rule of adaptive sampling.
  int sampleCount(int i, int j) const {
    int count = sampler_->getNumFirst();
    ColorRange around, own;
    for (int v = j - 1; v <= j + 1; ++v)
      for (int u = i - 1; u <= i + 1; ++u)
        for (int n = 0; n < count; ++n) around.add(sampleColor(u, v, n));
    if (!(around.width() > options_.sampling.tolerance)) return count;
    for (int n = 0; count < sampler_->getNumSamples();) {
      count *= 4;
      for (; n < count; ++n) own.add(sampleColor(i, j, n));
      if (!(own.width() > options_.sampling.tolerance)) break;
    }
    return count;
  }

 private:
  Vec3f sampleColor(int i, int j, int n) const {
    const Vec2d offset = sampler_->getSamplePosition(i, j, n);
    const double longer = std::max(width_, height_);
    Ray ray = scene_.getCamera()->generateRay(
        {(i + offset.x() - width_ / 2.0) / longer, (j + offset.y() - height_ / 2.0) / longer});
    Hit hit;
    return tracer_.traceRay(ray, float(scene_.getCamera()->getTMin()), 0, 1, 1, hit);
  }

  Vec3f pixelColor(int i, int j) const {
    const int reach = filter_->getSupportRadius();
    Vec3d sum;
    double weights = 0;
    for (const Pixel at : pixelsInOrder({i - reach, j - reach, i + reach + 1, j + reach + 1})) {
      const int count = sampleCount(at.i, at.j);
      for (int n = 0; n < count; ++n) {
        const Vec2d offset = sampler_->getSamplePosition(at.i, at.j, n);
        const double weight =
            filter_->getWeight(at.i - i + (offset.x() - 0.5), at.j - j + (offset.y() - 0.5)) *
            (sampler_->getNumSamples() / double(count));
        sum += Vec3d(sampleColor(at.i, at.j, n)) * weight;
        weights += weight;
      }
    }
    return Vec3f(sum / weights);
  }

  const SceneParser& scene_;
  const RenderOptions options_;
  const RayTracer tracer_;
  const std::unique_ptr<const Sampler> sampler_;
  const std::unique_ptr<const Filter> filter_;
  const int width_, height_;
};

}  // namespace

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
  const int width = 45, height = 34;  // no multiple of a tile; several tiles
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

TEST("adaptive samples with a tolerance that nothing exceeds are the first ones alone") {
  const SceneParser scene = variedScene();
  CHECK(isSame(renderColor(scene, 60, 50, adaptive(4, 64, 1)),
               renderColor(scene, 60, 50, sampled(Pattern::jittered, 4))));
}

TEST("adaptive samples with a tolerance that all exceed are all of them") {
  const SceneParser scene = variedScene();
  const Image all = renderSamples(scene, 9, 9, 64, adaptive(4, 64, -1));
  const NestedSampler sampler(4, 64);
  int wrong = 0;
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 9; ++i) {
      for (int n = 0; n < 64; ++n) {
        const Vec2d p = sampler.getSamplePosition(i, j, n);
        const Rgb8 dot = all.getPixel(int((i + p.x()) * 64), int((j + p.y()) * 64));
        wrong += dot == grey(0) || dot == grey(0.2f);
      }
    }
  }
  CHECK_EQUAL(wrong, 0);
}

TEST("adaptive samples are many along an edge and few elsewhere") {
  // The edge runs through the pixels of column 4 of 9; those beside it differ from it.
  const SceneParser scene = whiteShapes(9, 1, leftOf(0.1));
  const RenderOptions options = adaptive(4, 256, 0.1);
  const PlainSampling plain(scene, options, 9, 9);
  const Image dots = renderSamples(scene, 9, 9, 512, options);
  for (int j = 2; j < 7; ++j) {
    for (int i = 0; i < 9; ++i) {
      const int expected = i == 4 ? 256 : i == 3 || i == 5 ? 16 : 4;
      CHECK_EQUAL(plain.sampleCount(i, j), expected);
      int found = 0;
      const Rgb8 ground = (i + j) % 2 == 0 ? grey(0.2f) : grey(0);
      const bool isBlack = ground == grey(0);
      if (i >= 4 && isBlack) continue;  // black dots on black
      for (int y = j * 512; y < (j + 1) * 512; ++y)
        for (int x = i * 512; x < (i + 1) * 512; ++x) found += dots.getPixel(x, y) != ground;
      CHECK_NEAR(found, expected, expected / 50);  // two in 256 may fall on the same dot
    }
  }
}

TEST("adaptive colours are close to those of as many samples everywhere") {
  const SceneParser scene = variedScene();
  const Image few = renderColor(scene, 60, 50, adaptive(4, 256, 0.02));
  const Image many = renderColor(scene, 60, 50, sampled(Pattern::jittered, 1024));
  double sum = 0;
  for (int j = 0; j < 50; ++j)
    for (int i = 0; i < 60; ++i) sum += std::abs(few.getPixel(i, j).g - many.getPixel(i, j).g);
  CHECK(sum / 3000 < 0.6);  // bytes; truncation alone makes a third of one
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
  render(scene, *scene.getGroup(), RenderOptions(), 1, targets);
  targets.depth = &depth;
  targets.normals = &normals;
  targets.color = &color;
  targets.samples = &dots;
  targets.samplesZoom = zoom;
  const RenderOptions options = sampled(Pattern::random, 5, FilterKind::tent, 1);
  render(scene, *scene.getGroup(), options, 2, targets);
  CHECK(isSame(depth, plainDepth));
  CHECK(isSame(normals, plainNormals));
  CHECK(isSame(color, renderColor(scene, width, height, options)));
  CHECK(isSame(dots, renderSamples(scene, width, height, zoom, options)));
}
