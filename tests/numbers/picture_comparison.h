// The program's pictures of a plain scene beside those of the tracer in long double.
#pragma once
#include "accel/compiled_scene.h"
#include "image/image.h"
#include "long_tracer.h"
#include "math/functions.h"
#include "plain_scene_text.h"
#include "render/renderer.h"
#include "vectors.h"

namespace numbers {

/// How a scene is drawn.
struct Setup {
  int width = 48, height = 48;
  RenderOptions options;
  double depthMin = 0, depthMax = 1;
  double beside = 1e-6;  ///< in pixels: a pixel that is no edge looks the same this far beside it
};

/// The tracer's settings for the same options; epsilon as the arguments' table says.
inline LongSettings settingsOf(const RenderOptions& options, Real span) {
  LongSettings settings;
  settings.bounces = options.maxBounces;
  settings.weight = options.minWeight;
  settings.shadows = options.shadows;
  settings.transparentShadows = options.transparentShadows;
  settings.shadeBack = options.shadeBack;
  const bool isOrdinary = span == 0 || (span >= 1 && span <= 1000);
  if (options.epsilon.kind == Epsilon::Kind::fixed) settings.epsilon = options.epsilon.value;
  if (options.epsilon.kind == Epsilon::Kind::adaptive) settings.epsilon = -1;
  if (options.epsilon.kind == Epsilon::Kind::automatic && !isOrdinary) settings.epsilon = -1;
  return settings;
}

/// The three pictures of one scene by the program.
struct Pictures {
  Image color, depth, normals;
  Pictures(const SceneParser& scene, const Setup& setup)
      : color(setup.width, setup.height), depth(color), normals(color) {
    RenderTargets targets;
    targets.color = &color;
    targets.depth = &depth;
    targets.normals = &normals;
    targets.depthMin = setup.depthMin;
    targets.depthMax = setup.depthMax;
    render(RayTracer(scene, CompiledScene(*scene.getGroup(), 2), setup.options), 2, targets);
  }
};

/// One scene drawn by both.
class PictureComparison {
 public:
  /// What has been found in many pictures. An edge pixel is one that `isEdge` says is one.
  struct Tally {
    long pixels = 0, hits = 0;
    long edges = 0;             ///< edge pixels more than two levels off
    long asked = 0, sharp = 0;  ///< of all pixels, those looked at whether they are edges, and are
    check::Cases cases;         ///< every pixel that is no edge must be right
  };

  /// `scene` is not owned.
  PictureComparison(const PlainScene& scene, const Setup& setup)
      : setup_(setup), tracer_(scene, {}) {
    tracer_.settings() = settingsOf(setup.options, tracer_.world().span());
  }

  /// Draws the scene as `files` tell the program; `name` is for messages. The files of the first
  /// scene that fails are kept.
  void compare(SceneFiles& files, const std::string& name, Tally& tally) const {
    SceneParser scene(files.scene().c_str());
    scene.findSolids();
    const Pictures pictures(scene, setup_);
    const std::string label = name + " (" + files.scene() + ")";
    const bool wasRight = tally.cases.firstFailure().empty();
    for (int y = 0; y < setup_.height; ++y) {
      for (int x = 0; x < setup_.width; ++x) {
        comparePixel(pictures, x, y, label, tally);
      }
    }
    if (wasRight && !tally.cases.firstFailure().empty()) files.keep();
  }

  LongPixel pixel(int x, int y, double aside = 0, double above = 0) const {
    return tracer_.pixel(x + Real(0.5) + aside, y + Real(0.5) + above, setup_.width, setup_.height);
  }
  /// Whether rays just beside the pixel's own meet something else, or see another colour.
  bool isEdge(const LongPixel& right, int x, int y) const {
    for (int k = 0; k < 8; ++k) {
      const double angle = (k + 0.3) * (math::kPi / 4);
      const LongPixel other =
          pixel(x, y, setup_.beside * math::cos(angle), setup_.beside * math::sin(angle));
      Real change = 0;
      for (int c = 0; c < 3; ++c) {
        change = std::max<Real>(change, std::abs(byteOf(other.color[c]) - byteOf(right.color[c])));
      }
      if (!(other.signature == right.signature) || change > 2) return true;
    }
    return false;
  }

 private:
  void comparePixel(const Pictures& pictures, int x, int y, const std::string& name,
                    Tally& tally) const {
    const LongPixel right = pixel(x, y);
    ++tally.pixels;
    if (right.t < kFar) ++tally.hits;
    if (tally.pixels % 97 == 0) {
      ++tally.asked;
      if (isEdge(right, x, y)) ++tally.sharp;
    }
    const int by = error(pictures, right, x, y);
    if (by <= 2) return;
    const bool excused = isEdge(right, x, y);
    if (excused) ++tally.edges;
    tally.cases.expect(excused, [&] {
      return name + ", pixel " + std::to_string(x) + " " + std::to_string(y) + ": " +
             std::to_string(by) + " levels off";
    });
  }
  /// How far the program's pixel is from the right one, in levels, in the worst of its pictures.
  int error(const Pictures& pictures, const LongPixel& right, int x, int y) const {
    const Real grey = (setup_.depthMax - right.t) / (Real(setup_.depthMax) - Real(setup_.depthMin));
    const Vec n(std::fabs(right.normal.x()), std::fabs(right.normal.y()),
                std::fabs(right.normal.z()));
    return std::max({apart(pictures.color.getPixel(x, y), right.color),
                     apart(pictures.depth.getPixel(x, y), {grey, grey, grey}),
                     apart(pictures.normals.getPixel(x, y), n)});
  }
  static int apart(const Rgb8& pixel, const Vec& color) {
    return std::max({std::abs(pixel.r - byteOf(color.x())), std::abs(pixel.g - byteOf(color.y())),
                     std::abs(pixel.b - byteOf(color.z()))});
  }

  Setup setup_;
  LongTracer tracer_;
};

}  // namespace numbers
