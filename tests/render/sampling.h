// Scenes and pictures for the tests of samples and filters.
#pragma once
#include <algorithm>

#include "render/film.h"
#include "render/renderer.h"
#include "render/sample_tracing.h"
#include "scene_text.h"

inline std::ostream& operator<<(std::ostream& out, Rgb8 value) {
  return out << int(value.r) << ' ' << int(value.g) << ' ' << int(value.b);
}

namespace sampling {

using Pattern = SamplingOptions::Pattern;
using FilterKind = SamplingOptions::FilterKind;

inline Sampler samplerOf(Pattern pattern, int samples, int most = 1) {
  SamplingOptions options;
  options.pattern = pattern;
  options.samples = samples;
  options.maxSamples = most;
  return Sampler(options);
}

/// A scene without the camera that scene_text::parse brings.
inline SceneParser parseWhole(const std::string& text) {
  const std::string path = scene_text::write(text, ".txt");
  struct Remover {
    const std::string& path;
    ~Remover() { std::remove(path.c_str()); }
  } remover{path};
  return SceneParser(path.c_str());
}

/// Shapes that are white all over, on black, as an orthographic camera sees `size` units of them.
inline SceneParser whiteShapes(double size, int count, const std::string& shapes) {
  return parseWhole("OrthographicCamera { center 0 0 9 direction 0 0 -1 up 0 1 0 size" +
                    scene_text::word(size) +
                    "} Background { color 0 0 0 } Materials { numMaterials 1 PhongMaterial { } }"
                    "Group { numObjects " +
                    std::to_string(count) + " MaterialIndex 0 " + shapes + "}");
}

/// Everything to the left of the line x = a + slope y, as far as 100 units.
inline std::string leftOf(double a, double slope = 0) {
  return "Triangle { vertex0" + scene_text::word(Vec3d(a - 100 * slope, -100, 0)) + "vertex1" +
         scene_text::word(Vec3d(a + 100 * slope, 100, 0)) + "vertex2 -300 0 0 }";
}

/// Balls, glass and a mirror with a point light, over a floor.
inline SceneParser variedScene() {
  return parseWhole(
      "PerspectiveCamera { center 0 1 6 direction 0 -0.1 -1 up 0 1 0 angle 40 }"
      "Lights { numLights 1 PointLight { position 3 5 4 color 1 1 1 } }"
      "Background { color 0.2 0.3 0.5 ambientLight 0.1 0.1 0.1 }"
      "Materials { numMaterials 2 PhongMaterial { reflectiveColor 0.5 0.5 0.5 }"
      "  PhongMaterial { transparentColor 0.8 0.8 0.8 indexOfRefraction 1.5 } }"
      "Group { numObjects 3 MaterialIndex 0 Plane { normal 0 1 0 offset -1 }"
      "  Sphere { center 1 0 0 radius 1 } MaterialIndex 1 Sphere { center -1 0 1 radius 1 } }");
}

inline RenderOptions sampled(Pattern pattern, int samples, FilterKind filter = FilterKind::box,
                             double size = 0.5) {
  RenderOptions options;
  options.sampling.pattern = pattern;
  options.sampling.samples = options.sampling.maxSamples = samples;
  options.sampling.filter = filter;
  options.sampling.filterSize = size;
  return options;
}

inline RenderOptions adaptive(int least, int most, double tolerance) {
  RenderOptions options = sampled(Pattern::adaptive, least);
  options.sampling.maxSamples = most;
  options.sampling.tolerance = tolerance;
  return options;
}

inline Image renderColor(const SceneParser& scene, int width, int height,
                         const RenderOptions& options, int threads = 1) {
  Image image(width, height);
  RenderTargets targets;
  targets.color = &image;
  render(RayTracer(scene, *scene.getGroup(), options), threads, targets);
  return image;
}

inline Image renderSamples(const SceneParser& scene, int width, int height, int zoom,
                           const RenderOptions& options) {
  Image image(width * zoom, height * zoom);
  RenderTargets targets;
  targets.samples = &image;
  targets.samplesZoom = zoom;
  render(RayTracer(scene, *scene.getGroup(), options), 1, targets);
  return image;
}

inline bool isSame(const Image& a, const Image& b) {
  if (a.Width() != b.Width() || a.Height() != b.Height()) return false;
  for (int y = 0; y < a.Height(); ++y)
    for (int x = 0; x < a.Width(); ++x)
      if (a.getPixel(x, y) != b.getPixel(x, y)) return false;
  return true;
}

inline Rgb8 grey(double value) {
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
        sampler_(options.sampling),
        filter_(options.sampling),
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
    int count = sampler_.getNumFirst();
    ColorRange around, own;
    for (int v = j - 1; v <= j + 1; ++v)
      for (int u = i - 1; u <= i + 1; ++u)
        for (int n = 0; n < count; ++n) around.add(sampleColor(u, v, n));
    if (!(around.width() > options_.sampling.tolerance)) return count;
    for (int n = 0; count < sampler_.getNumSamples();) {
      count *= 4;
      for (; n < count; ++n) own.add(sampleColor(i, j, n));
      if (!(own.width() > options_.sampling.tolerance)) break;
    }
    return count;
  }

 private:
  Vec3f sampleColor(int i, int j, int n) const {
    const Vec2d offset = sampler_.getSamplePosition(i, j, n);
    const double longer = std::max(width_, height_);
    Ray ray = scene_.getCamera()->generateRay(
        {(i + offset.x() - width_ / 2.0) / longer, (j + offset.y() - height_ / 2.0) / longer});
    Hit hit;
    return tracer_.traceRay(ray, float(scene_.getCamera()->getTMin()), 0, 1, 1, hit);
  }

  Vec3f pixelColor(int i, int j) const {
    const int reach = filter_.getSupportRadius();
    Vec3d sum;
    double weights = 0;
    for (const Pixel at : pixelsInOrder({i - reach, j - reach, i + reach + 1, j + reach + 1})) {
      const int count = sampleCount(at.i, at.j);
      for (int n = 0; n < count; ++n) {
        const Vec2d offset = sampler_.getSamplePosition(at.i, at.j, n);
        const double weight =
            filter_.getWeight(at.i - i + (offset.x() - 0.5), at.j - j + (offset.y() - 0.5)) *
            (sampler_.getNumSamples() / double(count));
        sum += Vec3d(sampleColor(at.i, at.j, n)) * weight;
        weights += weight;
      }
    }
    return Vec3f(sum / weights);
  }

  const SceneParser& scene_;
  const RenderOptions options_;
  const RayTracer tracer_;
  const Sampler sampler_;
  const Filter filter_;
  const int width_, height_;
};

}  // namespace sampling
