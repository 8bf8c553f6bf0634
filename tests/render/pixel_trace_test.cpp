// One pixel has the colour that the whole picture has there.
#include "render/pixel_trace.h"

#include "check.h"
#include "image/image.h"
#include "render/renderer.h"
#include "scene_text.h"

namespace {

using Pattern = SamplingOptions::Pattern;

constexpr int kWidth = 21, kHeight = 17;

const char* const kScene =
    "Lights { numLights 2 DirectionalLight { direction -1 -1 -1 color 1 1 1 }\n"
    "                     PointLight { position 3 3 3 color 1 1 1 } }\n"
    "Background { color 0.2 0.4 0.8 ambientLight 0.1 0.1 0.1 }\n"
    "Materials { numMaterials 3 PhongMaterial { reflectiveColor 0.2 0.2 0.2 transparentColor 0.8 "
    "0.8 0.5 indexOfRefraction 1.5 } PhongMaterial { reflectiveColor 0.5 0.5 0.5 }\n"
    "  Checkerboard { materialIndex 0 materialIndex 1 size 0.3 } }\n"
    "Group { numObjects 2 MaterialIndex 2 Sphere { center 0 0 0 radius 0.9 }\n"
    "                     MaterialIndex 1 Sphere { center 0 -10.7 0 radius 10 } }\n";

/// The eye ray ends last.
struct LastColor : RayObserver {
  void rayEnds(const Vec3f& ended) override { color = ended; }
  Vec3f color;
};

/// Compares all pixels, to the last bit.
void compare(const RenderOptions& options) {
  SceneParser scene = scene_text::parse(kScene);
  scene.findSolids();
  const RayTracer tracer(scene, *scene.getGroup(), options);
  Image image(kWidth, kHeight);
  FloatImage exact(kWidth, kHeight);
  RenderTargets targets;
  targets.color = &image;
  targets.exactColor = &exact;
  render(tracer, 2, targets);
  int different = 0;
  for (int j = 0; j < kHeight; ++j) {
    for (int i = 0; i < kWidth; ++i) {
      LastColor first, second;
      const Vec3f color = tracePixel(tracer, {i, j, kWidth, kHeight}, {&first, &second});
      different += color != exact.getPixel(i, j);
      if (options.sampling.isPlain()) CHECK(first.color == color && second.color == color);
    }
  }
  CHECK_EQUAL(different, 0);
}

}  // namespace

TEST("a pixel of one ray has the picture's colour") {
  compare({});
  RenderOptions options;
  options.fresnel = options.nestedDielectrics = options.transparentShadows = true;
  options.shadeBack = true;
  compare(options);
}

TEST("a pixel of many samples under a filter has the picture's colour") {
  for (const Pattern pattern :
       {Pattern::center, Pattern::random, Pattern::uniform, Pattern::jittered, Pattern::adaptive}) {
    RenderOptions options;
    options.sampling.pattern = pattern;
    options.sampling.samples = 4;
    options.sampling.maxSamples = 16;
    options.sampling.tolerance = 0.05;
    compare(options);
    options.sampling.filter = SamplingOptions::FilterKind::gaussian;
    options.sampling.filterSize = 0.7;
    compare(options);
  }
}

TEST("a pixel can be traced as deep as the most bounces allow") {
  const SceneParser scene = scene_text::parse(
      "Materials { numMaterials 1 PhongMaterial { reflectiveColor 1 1 1 } }\n"
      "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 0 1 offset -1 }\n"
      "                                     Plane { normal 0 0 -1 offset -9 } }\n");
  struct Depth : RayObserver {
    void rayBegins(RayKind, int bounces, const TracedRay&) override { most = bounces; }
    int most = 0;
  } depth;
  tracePixel(RayTracer(scene, *scene.getGroup(), scene_text::bouncing(kMaxBounces)), {0, 0, 1, 1},
             {&depth});
  CHECK_EQUAL(depth.most, kMaxBounces);
}
