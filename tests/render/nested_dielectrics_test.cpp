// -nested_dielectrics: the media on both sides of a surface, by what a ray is inside of.
#include <algorithm>
#include <memory>

#include "accel/compiled_scene.h"
#include "geometry/sphere.h"
#include "glasses.h"
#include "random.h"
#include "ray_log.h"
#include "render/media.h"
#include "scene_text.h"
#include "shading/phong_material.h"
#include "vectors.h"

using glasses::ball;
using glasses::Glass;
using glasses::Glasses;
using glasses::nested;
using scene_text::colorTowards;
using scene_text::parse;
using scene_text::word;

namespace {

/// `inner`, as an OBJ file.
std::string cubeFile(double inner = 0) {
  const char* const outwards[] = {"1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"};
  const char* const inwards[] = {"11 12 10 9",  "14 16 15 13", "10 14 13 9",
                                 "15 16 12 11", "13 15 11 9",  "12 16 14 10"};
  std::string text;
  for (const double half : {1.0, inner}) {
    if (half == 0) break;
    for (int i = 0; i < 8; ++i) {
      text += "v" + word(Vec3d(i & 4 ? half : -half, i & 2 ? half : -half, i & 1 ? half : -half)) +
              "\n";
    }
  }
  for (const char* side : outwards) text += std::string("f ") + side + "\n";
  for (const char* side : inwards) {
    if (inner > 0) text += std::string("f ") + side + "\n";
  }
  return scene_text::write(text, ".obj");
}

/// A slab from z = `near` down to z = `far`, very wide.
std::string slab(const std::string& cube, double near, double far) {
  return " Transform { Translate 0 0" + word((near + far) / 2) + "Scale 512 512" +
         word((near - far) / 2) + scene_text::mesh(cube) + "} ";
}

/// How far from the point `center` the line of a ray runs.
double distanceFrom(const Vec3d& center, const Ray& ray) {
  return length(cross(ray.getOrigin() - center, ray.getDirection()));
}

/// One plane-parallel layer of the straight-forward calculation.
struct Layer {
  double index, thickness;
};

/// Sends a ray through `glasses`, which should look like `layers` from z = top down, and compares
/// each bend with Snell's law: n sin is the same everywhere, and the ray moves aside by
/// thickness * tan in each layer.
void checkLayers(const Glasses& glasses, double top, const std::vector<Layer>& layers) {
  for (const double sine : {0.0, 0.3, 0.6, 0.9}) {
    const double cosine = std::sqrt(1 - sine * sine);
    const Vec3d start(sine / cosine * -2, 0.125, top + 2);
    const auto path = glasses.path(start, {sine, 0, -cosine}, nested());
    CHECK_EQUAL(path.size(), layers.size() + 2);
    if (path.size() != layers.size() + 2) return;
    double x = 0, z = top;
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const double inside = sine / layers[i].index, down = std::sqrt(1 - inside * inside);
      CHECK_NEAR_VECTOR(path[i + 1].getOrigin(), Vec3d(x, 0.125, z), 1e-12);
      CHECK_NEAR_VECTOR(path[i + 1].getDirection(), Vec3d(inside, 0, -down), 1e-14);
      x += layers[i].thickness * inside / down;
      z -= layers[i].thickness;
    }
    CHECK_NEAR_VECTOR(path.back().getOrigin(), Vec3d(x, 0.125, z), 1e-12);
    CHECK_NEAR_VECTOR(path.back().getDirection(), Vec3d(sine, 0, -cosine), 1e-14);
  }
}

}  // namespace

TEST("a stack of slabs that touch bends a ray as Snell's law says, in any order of the file") {
  const std::string cube = cubeFile();
  const std::vector<Layer> layers = {{1.5, 1}, {1.25, 2}, {2, 0.5}};
  const Glass first = {1.5, 0, slab(cube, 4, 3)}, second = {1.25, 0, slab(cube, 3, 1)},
              third = {2, 0, slab(cube, 1, 0.5)};
  checkLayers(Glasses({first, second, third}), 4, layers);
  checkLayers(Glasses({third, second, first}), 4, layers);
  checkLayers(Glasses({second, third, first}), 4, layers);
}

TEST("slabs that overlap are divided by priority, whatever their order") {
  const std::string cube = cubeFile();
  // From 4 to 1.75 and from 2.5 to 0; the second one gives way, or the first.
  const std::string upper = slab(cube, 4, 1.75), lower = slab(cube, 2.5, 0);
  checkLayers(Glasses({{1.5, 2, upper}, {1.25, -1, lower}}), 4, {{1.5, 2.25}, {1.25, 1.75}});
  checkLayers(Glasses({{1.25, -1, lower}, {1.5, 2, upper}}), 4, {{1.5, 2.25}, {1.25, 1.75}});
  checkLayers(Glasses({{1.5, 0, upper}, {1.25, 1, lower}}), 4, {{1.5, 1.5}, {1.25, 2.5}});
}

TEST("a slab inside a slab of higher priority is not there at all") {
  const std::string cube = cubeFile();
  checkLayers(Glasses({{1.25, 0, slab(cube, 3, 2)}, {1.5, 1, slab(cube, 4, 0)}}), 4, {{1.5, 4}});
}

TEST("layer within layer needs no priorities: the innermost fills its place") {
  const std::string cube = cubeFile();
  const std::vector<Layer> layers = {{1.33f, 1}, {1.5, 1}, {1, 0.5}, {1.5, 0.5}, {1.33f, 1}};
  const Glass water = {1.33, 0, slab(cube, 4, 0)}, glass = {1.5, 0, slab(cube, 3, 1)},
              air = {1, 0, slab(cube, 2, 1.5)};
  checkLayers(Glasses({water, glass, air}), 4, layers);
  checkLayers(Glasses({air, glass, water}), 4, layers);
}

TEST("of equal priority the smaller one wins where objects overlap, from either side") {
  const std::string cube = cubeFile();
  // From 4 to 1.5 and from 3 to 1; the other way round, 1.25 is seen first.
  const Glass large = {1.5, 7, slab(cube, 4, 1.5)}, small = {1.25, 7, slab(cube, 3, 1)};
  checkLayers(Glasses({large, small}), 4, {{1.5, 1}, {1.25, 2}});
  checkLayers(Glasses({small, large}), 4, {{1.5, 1}, {1.25, 2}});
  const Glass turnedLarge = {1.5, 7, slab(cube, 3.5, 1)}, turnedSmall = {1.25, 7, slab(cube, 4, 2)};
  checkLayers(Glasses({turnedLarge, turnedSmall}), 4, {{1.25, 2}, {1.5, 1}});
}

TEST("of equal priority and volume the one that the ray leaves first wins") {
  const std::string cube = cubeFile();
  checkLayers(Glasses({{1.5, 7, slab(cube, 4, 2)}, {1.25, 7, slab(cube, 3, 1)}}), 4,
              {{1.5, 2}, {1.25, 1}});
}

TEST("of two that differ in looks alone the first of the scene's materials wins") {
  // As two textures of the same mean do. Where the objects lie in memory must not matter.
  PhongMaterial first({}, {}, 1, {1, 1, 1}, {}, 1.5f), second({}, {}, 1, {1, 1, 1}, {}, 1.5f);
  first.setNumber(0);
  second.setNumber(1);
  for (const bool isTurned : {false, true}) {
    const Sphere balls[] = {Sphere({}, 1, isTurned ? &second : &first),
                            Sphere({}, 1, isTurned ? &first : &second)};
    Media media(nullptr);
    media.begin();
    for (const Sphere& each : balls) each.visitCrossings(Ray({0, 0, 3}, {0, 0, -1}), media);
    media.finish();
    CHECK(media.mediumAt(3).material == &first);
    CHECK(media.mediumAt(5).material == nullptr);
  }
}

TEST("liquid that reaches into the wall of its glass touches it without a gap") {
  // A shell from 2 to 1 and from -1 to -2; the liquid is higher than the hollow, and gives way.
  const Glass glass = {1.5, 1,
                       " Transform { Scale 512 512 2" + scene_text::mesh(cubeFile(0.5)) + "}"};
  const std::string cube = cubeFile();
  const std::vector<Layer> layers = {{1.5, 1}, {1.25, 2}, {1.5, 1}};
  checkLayers(Glasses({glass, {1.25, 0, slab(cube, 1.25, -1.5)}}), 2, layers);
  checkLayers(Glasses({{1.25, 0, slab(cube, 1.25, -1.5)}, glass}), 2, layers);
  // One that just touches does as well.
  checkLayers(Glasses({glass, {1.25, 0, slab(cube, 1, -1)}}), 2, layers);
  checkLayers(Glasses({{1.25, 0, slab(cube, 1, -1)}, glass}), 2, layers);
  // And without priorities a gap of air is a layer of its own.
  checkLayers(Glasses({{1.25, 0, slab(cube, 0.5, -0.5)}, {1.5, 0, glass.object}}), 2,
              {{1.5, 1}, {1, 0.5}, {1.25, 1}, {1, 0.5}, {1.5, 1}});
}

TEST("in balls about one centre n times the distance from it stays as it is") {
  // Bouguer's law. A bubble in glass in water, and one more drop inside, in no order of the file.
  const Glasses glasses({{1.5, 0, ball({1, 2, 3}, 2)},
                         {1.33, 0, ball({1, 2, 3}, 3)},
                         {1.25, 0, ball({1, 2, 3}, 0.5)},
                         {1, 0, ball({1, 2, 3}, 1)}});
  const double indices[] = {1, 1.33f, 1.5, 1, 1.25, 1, 1.5, 1.33f, 1};
  for (const double aside : {0.0, 0.1, 0.3, 0.45}) {
    const auto path = glasses.path({1 + aside, 2, 9}, {0, 0, -1}, nested());
    CHECK_EQUAL(path.size(), 9u);
    for (std::size_t i = 0; i < path.size() && i < 9; ++i) {
      CHECK_NEAR(distanceFrom({1, 2, 3}, path[i]) * indices[i], aside, 1e-13);
    }
  }
}

TEST("a surface between media of one index bends nothing, and one within a medium costs nothing") {
  const Glass outer = {1.5, 1, ball({0, 0, 0}, 2)};
  const Vec3d eye(0.7, 0.2, 5), ahead(-0.1, 0.05, -1);
  const auto alone = Glasses({outer}).path(eye, ahead, nested());
  CHECK_EQUAL(alone.size(), 3u);
  // An inner ball of the same index and no less a priority is a surface: two more rays, all along
  // the same line.
  const auto with = Glasses({outer, {1.5, 1, ball({0, 0, 0}, 1)}}).path(eye, ahead, nested());
  CHECK_EQUAL(with.size(), 5u);
  for (std::size_t i = 2; i < 4 && i < with.size(); ++i) {
    CHECK_EQUAL(with[i].getDirection(), with[1].getDirection());
  }
  CHECK_NEAR_VECTOR(with.back().getDirection(), alone.back().getDirection(), 1e-14);
  // One of less priority is not there: the very same rays, and no bounce is spent on it.
  const Glasses hidden({outer, {2.5, 0, ball({0, 0, 0}, 1)}});
  const auto same = hidden.path(eye, ahead, nested(2));
  CHECK_EQUAL(same.size(), alone.size());
  for (std::size_t i = 0; i < same.size() && i < alone.size(); ++i) {
    CHECK_EQUAL(same[i].getOrigin(), alone[i].getOrigin());
    CHECK_EQUAL(same[i].getDirection(), alone[i].getDirection());
  }
  CHECK_EQUAL(colorTowards(hidden, eye, {0, 0, 0}, nested(2)), Vec3f(0.5f, 0.25f, 1));
}

TEST("a hidden surface is not shaded, an opaque one inside glass is") {
  // The hidden ball is between the eye and the outer ball's far side; the opaque one behind it.
  const Glasses glasses({{1, 1, ball({0, 0, 0}, 3)}, {1.5, 0, ball({0, 0, 1}, 0.5)}},
                        ball({0, 0, -1}, 1), 1);
  CHECK_EQUAL(colorTowards(glasses, {0, 0, 9}, {0, 0, 0}, nested(1)), Vec3f(0.125f, 0.25f, 0.75f));
}

TEST("an eye inside glass knows where it is") {
  // In water of index 1.33: a glass ball bends by 1.33 to 1.5, and the water's end by 1.33 to 1.
  const Glasses glasses({{1.33, 0, ball({0, 0, 0}, 4)}, {1.5, 0, ball({0, 0, 0}, 1)}});
  const double indices[] = {1.33f, 1.5, 1.33f, 1};
  const auto path = glasses.path({0.5, 0, 2}, {0, 0, -1}, nested());
  CHECK_EQUAL(path.size(), 4u);
  for (std::size_t i = 0; i < path.size() && i < 4; ++i) {
    CHECK_NEAR(distanceFrom({0, 0, 0}, path[i]) * indices[i], 0.5 * 1.33f, 1e-13);
  }
  // In the innermost of three, in a hollow ball of index 1 inside glass: 1 to 1.5 to 1.33 to 1.
  const Glasses three(
      {{1, 0, ball({0, 0, 0}, 0.75)}, {1.5, 0, ball({0, 0, 0}, 1)}, {1.33, 0, ball({0, 0, 0}, 4)}});
  const double outwards[] = {1, 1.5, 1.33f, 1};
  const auto out = three.path({0.5, 0, 0}, {0, 0, -1}, nested());
  CHECK_EQUAL(out.size(), 4u);
  for (std::size_t i = 0; i < out.size() && i < 4; ++i) {
    CHECK_NEAR(distanceFrom({0, 0, 0}, out[i]) * outwards[i], 0.5, 1e-13);
  }
}

TEST("a ray from minus infinity begins outside of everything") {
  // As the rays of an orthographic camera do, wherever its centre: here in the middle of the balls.
  const Glasses glasses({{1.33, 0, ball({0, 0, 0}, 4)}, {1.5, 0, ball({0, 0, 0}, 1)}});
  const SceneParser& scene = glasses;
  std::vector<Ray> path;
  const RayLog log(*scene.getGroup(), &path);
  Ray ray(Vec3d(0.5, 0, 0), Vec3d(0, 0, -1));
  Hit hit;
  RayTracer(scene, log, nested(1))
      .traceRay(ray, -std::numeric_limits<float>::infinity(), 0, 1, 1, hit);
  CHECK_NEAR(hit.getT(), -std::sqrt(16 - 0.25), 1e-14);
  CHECK_EQUAL(path.size(), 2u);
  CHECK_NEAR(distanceFrom({0, 0, 0}, path.back()) * 1.33f, 0.5, 1e-13);
}

TEST("ten thousand hidden surfaces in a row are passed over") {
  const int count = 5000;
  std::string row;
  for (int i = 0; i < count; ++i) row += ball({0, 0, -1.0 * i}, 0.25);
  const Glass hidden = {3, 0, "Group { numObjects " + std::to_string(count) + row + "}"};
  const Glass outer = {1, 1, ball({0, 0, -2500}, 3000)};
  const Glasses glasses({hidden, outer});
  const SceneParser& scene = glasses;
  const CompiledScene compiled(*scene.getGroup(), 1);
  std::vector<Ray> path;
  const RayLog log(compiled, &path);
  Ray ray(Vec3d(0.01, 0.02, 600), Vec3d(0, 0, -1));
  Hit hit;
  const Vec3f color = RayTracer(scene, log, nested(2)).traceRay(ray, 0, 0, 1, 1, hit);
  CHECK_EQUAL(color, Vec3f(0.5f, 0.25f, 1));
  CHECK_EQUAL(path.size(), 3u);
}

TEST("open surfaces keep the plain rule inside a medium too") {
  const Glasses glasses({{1.25, 0, ball({0, 0, 0}, 4)},
                         {2, 0, "Triangle { vertex0 -2 -2 0 vertex1 2 -2 0 vertex2 0 3 0 }"}});
  const auto path = glasses.path({0, 0.5, 1}, {0.6, 0, -0.8}, nested());
  CHECK_EQUAL(path.size(), 3u);
  // From 1 to 2, as the triangle's front side has it: sin 0.3.
  CHECK_NEAR(path[1].getDirection().x(), 0.3, 1e-14);
}

TEST("a closed mesh that is inside out fills its inside all the same") {
  const std::string inverted = scene_text::write(
      "v 0 -1 -1\nv 1 -1 1\nv -1 -1 1\nv 0 1 0\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", ".obj");
  const std::string upright = scene_text::write(
      "v 0 -1 -1\nv 1 -1 1\nv -1 -1 1\nv 0 1 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n", ".obj");
  const Vec3d eye(0.2, 0.1, 5), ahead(-0.05, -0.05, -1);
  const auto a = Glasses({{1.03125, 0, scene_text::mesh(upright)}}).path(eye, ahead, nested());
  const auto b = Glasses({{1.03125, 0, scene_text::mesh(inverted)}}).path(eye, ahead, nested());
  CHECK_EQUAL(a.size(), 3u);
  CHECK_EQUAL(b.size(), a.size());
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    CHECK_NEAR_VECTOR(a[i].getDirection(), b[i].getDirection(), 1e-14);
  }
}
