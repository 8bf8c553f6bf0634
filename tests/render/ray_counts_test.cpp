// What an observer is told, and the counts that come of it.
#include "render/ray_counts.h"

#include "accel/compiled_scene.h"
#include "check.h"
#include "eye_rays.h"
#include "render/renderer.h"
#include "render/watched_tracer.h"
#include "render/wave_tracer.h"
#include "scene_text.h"
#include "vectors.h"

namespace {

/// A line for each event, in order.
class Log : public RayObserver {
 public:
  void rayBegins(RayKind kind, int bounces, const TracedRay&) override {
    constexpr const char* kNames[] = {"eye", "mirror", "refracted"};
    text_ += std::string(kNames[int(kind)]) + " " + std::to_string(bounces) + " (";
  }
  void rayMeets(const Hit* hit, const Interface&) override { text_ += hit ? "hit " : "nothing "; }
  void lightAnswers(int light, const LightSample& sample, const ShadowQuery* shadowRay,
                    const Vec3f& visible, const Vec3d&) override {
    text_ += "light" + std::to_string(light);
    text_ += !sample.isInFront    ? "-behind "
             : !shadowRay         ? "-unasked "
             : visible == Vec3f() ? "-blocked "
             : visible == white() ? "-open "
                                  : "-tinted ";
  }
  void branchEnds(RayKind kind, Outcome why, float) override {
    text_ += std::string(kind == RayKind::mirror ? "no-mirror-" : "no-refraction-") +
             (why == Outcome::tooManyBounces    ? "bounces "
              : why == Outcome::tooFaint        ? "weight "
              : why == Outcome::totalReflection ? "total-reflection "
                                                : "? ");
  }
  void termIsKnown(ColorTerm term, const Vec3d& color) override {
    sum_ = term == ColorTerm::ambient ? color : sum_ + color;
    text_ += "+ ";
  }
  void rayEnds(const Vec3f& color) override {
    color_ = color;
    text_ += ") ";
  }
  const std::string& text() const { return text_; }
  /// The terms of the ray that ended last, and its colour.
  Vec3d sum() const { return sum_; }
  Vec3f color() const { return color_; }

 private:
  static Vec3f white() { return {1, 1, 1}; }
  std::string text_;
  Vec3d sum_;
  Vec3f color_;
};

std::string logOf(const std::string& sceneText, const Ray& eyeRay,
                  const RenderOptions& options = {}) {
  const SceneParser scene = scene_text::parse(sceneText);
  Log log;
  const WatchedTracer tracer(RayTracer(scene, *scene.getGroup(), options), log);
  Ray ray = eyeRay;
  Hit hit;
  const Vec3f color = tracer.traceRay(ray, 0, 0, 1, 1, hit);
  CHECK(log.color() == color);
  if (hit.getMaterial()) CHECK(Vec3f(log.sum()) == color);
  return log.text();
}

/// Counts of a whole picture, and the picture.
struct Counted {
  RayCounts rays;
  Image image;
};

Counted render(const SceneParser& scene, const Object3D& geometry, int threads,
               const RenderOptions& options, int width = 40, int height = 30) {
  Counted counted;
  counted.image = Image(width, height);
  RenderTargets targets;
  targets.color = &counted.image;
  render(RayTracer(scene, geometry, options), threads, targets, &counted.rays);
  return counted;
}

void checkSame(const RayCounts& a, const RayCounts& b) {
  for (const RayKind kind : {RayKind::eye, RayKind::mirror, RayKind::refracted}) {
    CHECK_EQUAL(a.rays(kind), b.rays(kind));
  }
  for (const Outcome why : {Outcome::tooManyBounces, Outcome::tooFaint, Outcome::totalReflection}) {
    CHECK_EQUAL(a.ends(why), b.ends(why));
  }
  CHECK_EQUAL(a.shadowRays(), b.shadowRays());
  CHECK_EQUAL(a.blockedShadowRays(), b.blockedShadowRays());
  CHECK_EQUAL(a.misses(), b.misses());
  CHECK(a.byBounces() == b.byBounces());
}

/// Mirrors at z = -1 and z = 9 that face each other, the camera of scene_text between them. Light
/// falls straight along -z.
const char* const kFacingMirrors =
    "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 1 1 1 } }\n"
    "Materials { numMaterials 1 PhongMaterial { reflectiveColor 0.5 0.5 0.5 } }\n"
    "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 0 1 offset -1 }\n"
    "                                     Plane { normal 0 0 -1 offset -9 } }\n";

}  // namespace

TEST(
    "traceRay tells of rays, hits, lights and branches in order, each inside the one it "
    "continues") {
  // From the origin down to the first mirror, whose lamp is behind the second; up to that one,
  // which is turned away from the lamp; down again, where the bounces end.
  CHECK_EQUAL(logOf(kFacingMirrors, Ray({0, 0, 0}, {0, 0, -1}), scene_text::bouncing(2)),
              "eye 0 (hit + light0-blocked + "
              "mirror 1 (hit + light0-behind + "
              "mirror 2 (hit + light0-blocked + no-mirror-bounces + + ) "
              "+ + ) "
              "+ + ) ");
}

TEST("the reasons why a branch is not followed are told apart") {
  RenderOptions heavy = scene_text::bouncing(5);
  heavy.minWeight = 0.9f;  // a mirror ray has the weight 0.5 sqrt 3 = 0.866
  CHECK_EQUAL(logOf(kFacingMirrors, Ray({0, 0, 0}, {0, 0, -1}), heavy),
              "eye 0 (hit + light0-blocked + no-mirror-weight + + ) ");
  // Inside glass of index 2 a ray at 60 degrees to the normal is reflected totally: sin 60 > 1/2.
  const std::string glass =
      "Materials { numMaterials 1 PhongMaterial { transparentColor 1 1 1 indexOfRefraction 2 } }\n"
      "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 0 offset 1 } }\n";
  CHECK_EQUAL(logOf(glass, Ray({0, 0, 0}, normalize(Vec3d(1.7320508, 1, 0)))),
              "eye 0 (hit + + + no-refraction-total-reflection + ) ");
  CHECK_EQUAL(logOf(glass, Ray({0, 0, 0}, {0, 1, 0})),
              "eye 0 (hit + + + refracted 1 (nothing ) + ) ");
}

TEST("shadow rays are told apart: open, blocked, tinted, and none asked for") {
  const std::string start =
      "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 1 1 } }\n"
      "Materials { numMaterials 2 PhongMaterial { }\n"
      "    PhongMaterial { transparentColor 0.5 0.5 0.5 } }\n"
      "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 1 0 offset 0 }\n"
      "    MaterialIndex 1 Triangle { vertex0 -1 5 -1 vertex1 1 5 -1 vertex2 0 5 1 } }\n";
  const Ray under({0.0, 1, 0}, {0, -1, 0}), aside({9, 1, 0}, {0, -1, 0});
  CHECK_EQUAL(logOf(start, aside), "eye 0 (hit + light0-open + + + ) ");
  CHECK_EQUAL(logOf(start, under), "eye 0 (hit + light0-blocked + + + ) ");
  RenderOptions options;
  options.transparentShadows = true;
  CHECK_EQUAL(logOf(start, under, options), "eye 0 (hit + light0-tinted + + + ) ");
  options.shadows = false;
  CHECK_EQUAL(logOf(start, under, options), "eye 0 (hit + light0-unasked + + + ) ");
}

TEST("between facing mirrors every ray is counted, at every bounce") {
  // The eye ray of each of the 1200 pixels meets a mirror, and so do its 5 mirrored rays. The
  // first, third and fifth hit are on the mirror that faces the lamp, behind the other one.
  const SceneParser scene = scene_text::parse(kFacingMirrors);
  const RayCounts rays = render(scene, *scene.getGroup(), 1, scene_text::bouncing(5)).rays;
  CHECK_EQUAL(rays.rays(RayKind::eye), 1200u);
  CHECK_EQUAL(rays.rays(RayKind::mirror), 5 * 1200u);
  CHECK_EQUAL(rays.rays(RayKind::refracted), 0u);
  CHECK_EQUAL(rays.shadowRays(), 3 * 1200u);
  CHECK_EQUAL(rays.blockedShadowRays(), 3 * 1200u);
  CHECK_EQUAL(rays.misses(), 0u);
  CHECK_EQUAL(rays.total(), 9 * 1200u);
  CHECK(rays.byBounces() == std::vector<std::uint64_t>(6, 1200));
  CHECK_EQUAL(rays.ends(Outcome::tooManyBounces), 1200u);
}

TEST("counts are the same for any number of threads, compiled or not, and change no byte") {
  const SceneParser scene((check::testsFolder() + "/../scenes/18_cut_glass.txt").c_str());
  const CompiledScene compiled(*scene.getGroup(), 1);
  RenderOptions options = scene_text::bouncing(4);
  for (const bool tinted : {false, true}) {
    options.transparentShadows = tinted;
    const Counted one = render(scene, compiled, 1, options);
    const Counted three = render(scene, compiled, 3, options);
    const Counted plain = render(scene, *scene.getGroup(), 2, options);
    CHECK(one.rays.rays(RayKind::refracted) > 500 && one.rays.shadowRays() > 500);
    checkSame(one.rays, three.rays);
    checkSame(one.rays, plain.rays);
    Image unwatched(40, 30);
    RenderTargets targets;
    targets.color = &unwatched;
    render(RayTracer(scene, compiled, options), 1, targets);
    for (int i = 0; i < 40 * 30; ++i) {
      CHECK(unwatched.getPixel(i % 40, i / 40) == one.image.getPixel(i % 40, i / 40));
    }
  }
}

TEST("several samples in a pixel under a filter are counted alike by any number of threads") {
  const SceneParser scene = scene_text::parse(kFacingMirrors);
  RenderOptions options = scene_text::bouncing(1);
  options.sampling.pattern = SamplingOptions::Pattern::jittered;
  options.sampling.samples = 4;
  options.sampling.filter = SamplingOptions::FilterKind::tent;
  options.sampling.filterSize = 2;
  const RayCounts one = render(scene, *scene.getGroup(), 1, options, 128, 128).rays;
  const RayCounts five = render(scene, *scene.getGroup(), 5, options, 128, 128).rays;
  CHECK(one.rays(RayKind::eye) > 4 * 128 * 128);  // and those around each tile
  checkSame(one, five);
}

TEST("rays that are traced one by one are counted as those of a batch") {
  const SceneParser scene((check::testsFolder() + "/../scenes/17_gem.txt").c_str());
  RayCounts single, batch;
  const RayTracer tracer(scene, *scene.getGroup(), scene_text::bouncing(4));
  const WatchedTracer singleTracer(tracer, single), batchTracer(tracer, batch);
  std::vector<Ray> rays;
  for (int i = 0; i < 64; ++i) {
    const Ray ray = scene.getCamera()->generateRay({(i % 8 - 3.5) / 16, (i / 8 - 3.5) / 16});
    rays.push_back(ray);
    Ray copy = ray;
    Hit hit;
    singleTracer.traceRay(copy, 0, 0, 1, 1, hit);
  }
  WaveTracer waves(batchTracer, &batch);
  WaveRays table = eye_rays::tableOf(rays, waves.arena());
  HitTable hits(waves.arena(), 64);
  std::vector<Vec3f> colors(64);
  waves.trace(table, 0, hits, colors.data());
  CHECK(single.rays(RayKind::refracted) > 20);
  checkSame(single, batch);
}
