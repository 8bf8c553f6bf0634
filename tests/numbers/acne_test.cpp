// No acne and no light under a contact: ground of radius 1e6, far from the origin, in low sun.
#include "accel/compiled_scene.h"
#include "check.h"
#include "picture_comparison.h"
#include "random.h"
#include "scene_text.h"

using numbers::PictureComparison;
using numbers::PlainObject;
using numbers::PlainScene;
using scene_text::word;

namespace {

constexpr Epsilon kAdaptive{Epsilon::Kind::adaptive, 0};
constexpr Epsilon kCourse{Epsilon::Kind::fixed, Epsilon::kCourse};

/// One white lamp at no distance, no ambient light, a blue sky, one material and one object.
SceneParser sunlit(const Vec3d& sun, const std::string& material, const std::string& objects,
                   int count = 1) {
  return scene_text::parse("Lights { numLights 1 DirectionalLight { direction" + word(sun) +
                           "color 1 1 1 } } Background { color 0 0.25 1 }"
                           "Materials { numMaterials 1 PhongMaterial { " +
                           material + " } } Group { numObjects " + std::to_string(count) +
                           " MaterialIndex 0 " + objects + " }");
}

/// What is seen of a compiled scene from one point towards another.
struct View {
  Vec3f color;
  Hit hit;
  View(const SceneParser& scene, const Epsilon& epsilon, const Vec3d& from, const Vec3d& to) {
    RenderOptions options;
    options.epsilon = epsilon;
    const CompiledScene compiled(*scene.getGroup(), 1);
    Ray ray(from, normalize(to - from));
    color = RayTracer(scene, compiled, options).traceRay(ray, 0, 0, 1, 1, hit);
  }
};

/// A sun whose light meets a surface of normal `n` at the given slope.
Vec3d sunAt(const Vec3d& n, double slope, Random& random) {
  const Vec3d level = normalize(cross(n, random.unitVector()));
  return -(level + n * slope);
}

std::string describe(double x, const Vec3f& found) {
  return check::show(x) + ": found " + check::show(found);
}

/// Where a scene lies, and the words of a Transform that moves a body there.
struct Place {
  Vec3d at;
  std::string move;
  Place(double away, Random& random)
      : at(random.unitVector() * away), move("Transform { Translate" + word(at)) {}
};

/// A convex body about 2 large around the place: a ball, a cube of triangles (as words or as a
/// mesh), a ball in a Transform, a cube mesh in a Transform. Meshes are moved, not made there:
/// their vertices are single precision.
std::string convexBody(int kind, const Place& place, const std::string& cubeFile) {
  const Vec3d& c = place.at;
  if (kind == 0) return "Sphere { center" + word(c) + "radius 1 }";
  if (kind == 1) return place.move + "Sphere { center 0 0 0 radius 1 } }";
  if (kind == 2) return place.move + scene_text::mesh(cubeFile) + "}";
  if (kind == 3) return place.move + "Rotate { 1 2 3 40 }" + scene_text::mesh(cubeFile) + "}";
  const double top = c.y() + 1;
  return "Triangle { vertex0" + word(Vec3d(c.x() - 3, top, c.z() + 2)) + "vertex1" +
         word(Vec3d(c.x() + 3, top, c.z() + 2)) + "vertex2" + word(Vec3d(c.x(), top, c.z() - 4)) +
         "}";
}

const char* const kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

/// Ground, three balls and a tetrahedron that rest on it, all of them around `at`, in low sun.
PlainScene stillLife(const Vec3d& at, const PlainObject& ground) {
  PlainScene scene;
  scene.ambient = {0.1f, 0.1f, 0.1f};
  scene.lights.resize(2);
  scene.lights[0].place = {-1, -0.02, -0.3};
  scene.lights[0].color = {0.7f, 0.7f, 0.6f};
  scene.lights[1].isPoint = true;
  scene.lights[1].place = at + Vec3d(2, 5, 3);
  scene.lights[1].color = {0.4f, 0.3f, 0.5f};
  scene.materials.resize(3);
  scene.materials[1].reflective = {0.5f, 0.5f, 0.5f};
  scene.materials[2].diffuse = {0.1f, 0.1f, 0.1f};
  scene.materials[2].transparent = {0.8f, 0.9f, 0.8f};
  scene.materials[2].index = 1.5f;
  scene.camera = {true, at + Vec3d(1, 0.6, 5), {-0.2, -0.1, -1}, {0, 1, 0}, 55};
  scene.objects.push_back(ground);
  for (int i = 0; i < 3; ++i) {
    PlainObject ball;
    ball.material = i;
    ball.f = 0.5 + 0.25 * i;
    ball.a = at + Vec3d(1.75 * i - 2, ball.f, -0.5 * i);
    scene.objects.push_back(ball);
  }
  const Vec3d corners[4] = {{0, 0, 1}, {1, 0, 1.5}, {0.75, 0, 0.75}, {0.5, 1, 1}};
  for (int i = 0; i < 4; ++i) {
    PlainObject side;
    side.kind = PlainObject::Kind::triangle;
    side.a = at + corners[(i + 1) % 4];
    side.b = at + corners[i % 2 ? (i + 2) % 4 : (i + 3) % 4];
    side.c = at + corners[i % 2 ? (i + 3) % 4 : (i + 2) % 4];
    scene.objects.push_back(side);
  }
  return scene;
}

void compareStillLife(const Vec3d& at, const PlainObject& ground, PictureComparison::Tally& tally) {
  const PlainScene scene = stillLife(at, ground);
  for (const Epsilon& epsilon : {kAdaptive, kCourse}) {
    numbers::Setup setup;
    setup.options.epsilon = epsilon;
    setup.depthMax = 20;
    setup.beside = 1e-5;
    numbers::SceneFiles files(scene);
    PictureComparison(scene, setup).compare(files, "still life at " + check::show(at), tally);
  }
}

PlainObject levelPlane(double height) {
  PlainObject plane;
  plane.kind = PlainObject::Kind::plane;
  plane.a = {0, 1, 0};
  plane.f = height;
  return plane;
}

}  // namespace

TEST("a ground ball of radius 1e6 is lit wherever the sun is above it, however low and far") {
  const std::string ground = "Sphere { center 0 -1e6 0 radius 1e6 }";
  Random random(71);
  for (const Epsilon& epsilon : {kAdaptive, kCourse}) {
    check::Cases cases;
    for (int i = 0; i < 3000; ++i) {
      const double away = random.logUniform(1e-3, 1e5), angle = random.uniform(0, 6.28);
      Vec3d to = Vec3d(math::cos(angle), 0, math::sin(angle)) * away;
      to[1] = -away * away / (1e6 + std::sqrt(1e12 - away * away));
      const Vec3d normal = normalize(to + Vec3d(0, 1e6, 0));
      const double slope = random.logUniform(1e-5, 1);
      const SceneParser scene =
          sunlit(sunAt(normal, slope, random), "diffuseColor 1 1 1 reflectiveColor 1 1 1", ground);
      const View view(scene, epsilon, Vec3d(0, random.logUniform(1e-2, 1e4), 0), to);
      if (view.hit.getMaterial() == nullptr || dot(view.hit.getNormal(), normal) < 1 - 1e-12)
        continue;  // seen from too low, another point of the ground is in the way
      // The light, and the sky in the mirror.
      const double light = slope / std::sqrt(1 + slope * slope);
      const Vec3d expected = Vec3d(light, light + 0.25, light + 1);
      cases.expect(maxAbs(Vec3d(view.color) - expected) < 2e-6,
                   [&] { return describe(slope, view.color); });
    }
    CHECK(cases.tried() > 2000);
    CHECK_EQUAL(cases.firstFailure(), "");
  }
}

TEST("no light gets under a ball that rests on ground of radius 1e6 or far from the origin") {
  Random random(72);
  check::Cases cases;
  for (int i = 0; i < 2000; ++i) {
    const Place place(random.logUniform(1e3, 1e9), random);
    const bool isBall = i % 4 < 2;
    // The gap at distance x from the contact may be less than epsilon, but the ball's far side is
    // more than 0.8 above the ground there.
    // At the least x the gap, x^2 / 2, is five times the rounding of a coordinate.
    const double least = std::sqrt(1e-15 * (isBall ? 1e6 : length(place.at)));
    const double x = i % 2 ? random.uniform(least, 0.9) : random.logUniform(least, 0.9);
    const double outside = random.uniform(1.01, 3), angle = random.uniform(0, 6.28);
    const Vec3d way(math::cos(angle), 0, math::sin(angle));
    const Vec3d at = isBall ? Vec3d() : place.at;
    const std::string ground = isBall ? " Sphere { center 0 -1e6 0 radius 1e6 }"
                                      : " Plane { normal 0 1 0 offset" + word(at.y()) + "}";
    const std::string ball = "Sphere { center" + word(at + Vec3d(0, 1, 0)) + "radius 1 }";
    const SceneParser scene = sunlit({0, -1, 0}, "", ball + ground, 2);
    for (const Epsilon& epsilon : {kAdaptive, kCourse}) {
      // A line at slope x to the ground is below the ball, whose height is over r^2 / 2 at r.
      const View dark(scene, epsilon, at + way * (x + 0.5) + Vec3d(0, 0.5 * x, 0), at + way * x);
      const bool isGround = dark.hit.getMaterial() != nullptr && dark.hit.getNormal().y() > 0.9;
      cases.expect(isGround && dark.color == Vec3f(),
                   [&] { return describe(x, dark.color) + " below"; });
      const View lit(scene, epsilon, at + way * outside + Vec3d(0, 3, 0), at + way * outside);
      cases.expect(std::fabs(lit.color.r() - 1) < 1e-6f,
                   [&] { return describe(outside, lit.color) + " beside"; });
    }
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("convex bodies of size 1 are lit without acne up to 1e9 from the origin, in low sun too") {
  const std::string cubeFile = scene_text::write(kCube, ".obj");
  Random random(73);
  for (const Epsilon& epsilon : {kAdaptive, kCourse}) {
    check::Cases cases;
    for (int i = 0; i < 3000; ++i) {
      const double away = random.logUniform(1e3, 1e9);
      const Place place(away, random);
      const std::string body = convexBody(i % 5, place, cubeFile);
      const Vec3d from = place.at + random.ofLogLength(4, 100);
      const Vec3d to = place.at + random.inCube(-0.5, 0.5);
      const View first(sunlit({0, -1, 0}, "", body), kAdaptive, from, to);
      if (first.hit.getMaterial() == nullptr) continue;
      // A point is rounded by some 4 away 2^-53; at this slope it lies less than 0.001 below.
      const double slope = random.logUniform(std::max(1e-4, 4e-13 * away), 1);
      const Vec3d sun = sunAt(first.hit.getNormal(), slope, random);
      // Looked at again from 1e-6 to 1e6 away, steeply enough to meet the same side.
      const Vec3d p = first.hit.getIntersectionPoint();
      const Vec3d up = normalize(first.hit.getNormal() * 1.5 + random.unitVector());
      const double eyeAway = random.logUniform(std::max(1e-6, 1e-14 * away), 1e6);
      const View view(sunlit(sun, "", body), epsilon, p + up * eyeAway, p);
      if (view.hit.getMaterial() == nullptr) continue;
      const double expected = dot(view.hit.getNormal(), -normalize(sun));
      cases.expect(std::fabs(double(view.color.r()) - expected) < 1e-6, [&] {
        return "body " + std::to_string(i % 5) + " at " + check::show(away) + ", sun " +
               describe(slope, view.color);
      });
    }
    CHECK(cases.tried() > 1500);
    CHECK_EQUAL(cases.firstFailure(), "");
  }
  std::remove(cubeFile.c_str());
}

TEST("a still life in low sun looks as in long double up to 1e5 from the origin") {
  Random random(74);
  PictureComparison::Tally tally;
  for (const double away : {0.0, 1e3, 1e4, 1e5}) {
    const Vec3d at = random.unitVector() * away;
    compareStillLife(at, levelPlane(at.y()), tally);
  }
  PlainObject ground;
  ground.a = {0, -1e6, 0};
  ground.f = 1e6;
  compareStillLife(Vec3d(), ground, tally);
  CHECK_EQUAL(tally.cases.firstFailure(), "");
  CHECK(tally.hits > tally.pixels / 2 && tally.edges <= tally.pixels / 2000);
}
