// The program's pictures against those of a second tracer in long double: where they differ by
// more than 2 levels, the pixel lies on an edge. RAYTRACER_NUMBERS=N compares N scenes.
#include <cstdlib>

#include "check.h"
#include "picture_comparison.h"
#include "random_plain_scene.h"

using numbers::PictureComparison;
using numbers::PlainObject;
using numbers::Setup;

namespace {

/// About a second; sh tests/run.sh --numbers compares 500.
constexpr int kOrdinaryScenes = 120;

/// By turns: the course's epsilon, adaptive, the default and one of its own; and scenes of all
/// sizes, but for the first, which is an absolute length.
double unitOf(int i, Random& random) {
  if (i % 4 == 1) return random.logUniform(1e-5, 1e5);
  return i % 4 == 2 ? random.logUniform(0.01, 300) : 1;
}

Setup setupOf(int i, double unit, Random& random) {
  Setup setup;
  if (i % 3 == 1) setup.height = 30 + random.index(15);
  if (i % 3 == 2) setup.width = 30 + random.index(15);
  RenderOptions& options = setup.options;
  options.maxBounces = random.index(8);
  options.minWeight = random.index(3) ? 0.01f : float(random.uniform(0, 0.5));
  options.shadows = random.index(8) != 0;
  options.transparentShadows = random.index(2) != 0;
  options.shadeBack = random.index(3) == 0;
  const Epsilon choices[] = {{Epsilon::Kind::fixed, Epsilon::kCourse},
                             {Epsilon::Kind::adaptive, 0},
                             {},
                             {Epsilon::Kind::fixed, random.logUniform(1e-8, 1e-2)}};
  options.epsilon = choices[i % 4];
  setup.depthMin = random.uniform(-3, 5) * unit;
  setup.depthMax = random.uniform(6, 12) * unit;
  return setup;
}

void compare(int i, PictureComparison::Tally& tally) {
  Random random{std::uint64_t(5000 + i)};
  const double unit = unitOf(i, random);
  const Setup setup = setupOf(i, unit, random);
  numbers::RandomPlainScene made(std::uint64_t(i), unit);
  if (i % 6 == 4) made.moveAway(random.logUniform(1, 100));
  if (i % 6 == 3) made.moveAway(random.logUniform(1, 1e5));
  numbers::SceneFiles files(made.scene());
  PictureComparison(made.scene(), setup).compare(files, "scene " + std::to_string(i), tally);
}

/// Two white triangles on black that share an edge; seen from z = 4 it runs straight up at x = 0.
numbers::PlainScene twoTriangles() {
  numbers::PlainScene scene;
  scene.background = Vec3f();
  scene.materials.emplace_back();
  scene.camera = {false, {0, 0, 4}, {0, 0, -1}, {0, 1, 0}, 9};
  for (const double x : {-3.0, 3.0}) {
    PlainObject triangle;
    triangle.kind = PlainObject::Kind::triangle;
    triangle.a = {0, -3, 0};
    triangle.b = {x, 0, 0};
    triangle.c = {0, 3, 0};
    scene.objects.push_back(triangle);
  }
  return scene;
}

}  // namespace

TEST("pictures of random scenes differ from those in long double at edges alone, and rarely") {
  const char* wanted = std::getenv("RAYTRACER_NUMBERS");
  const int scenes = wanted ? std::atoi(wanted) : kOrdinaryScenes;
  PictureComparison::Tally tally;
  for (int i = 0; i < scenes; ++i) compare(i, tally);
  CHECK_EQUAL(tally.cases.firstFailure(), "");
  CHECK(tally.hits > tally.pixels / 2);
  CHECK(tally.edges <= tally.pixels / 2000);
  // Were most pixels edges, the first check would say nothing.
  CHECK(tally.asked > tally.pixels / 100 && tally.sharp <= tally.asked / 200);
  if (wanted) {
    std::printf("%d scenes, %ld pixels, %ld hit something; %ld edge pixels differ\n", scenes,
                tally.pixels, tally.hits, tally.edges);
  }
}

TEST("a pixel whose ray meets a shared edge is an edge pixel, and its neighbours are not") {
  const numbers::PlainScene scene = twoTriangles();
  Setup setup;
  setup.width = setup.height = 9;  // one unit to a pixel: the middle of column 4 is x = 0
  const PictureComparison comparison(scene, setup);
  for (int x = 0; x < 9; ++x) {
    CHECK_EQUAL(comparison.isEdge(comparison.pixel(x, 4), x, 4), x == 1 || x == 4 || x == 7);
  }
}
