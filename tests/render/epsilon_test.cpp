// Where secondary rays start: the assignment's constant, and the adaptive rule without constants.
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"
#include "random.h"
#include "scene_text.h"
#include "shading/phong_material.h"
#include "vectors.h"

namespace {

/// Lights come from the six axes, so that some of them shine on any surface.
SceneParser lights(double size) {
  std::string text = "Lights { numLights 6 ";
  for (int axis = 0; axis < 6; ++axis) {
    Vec3d direction;
    direction[axis / 2] = axis % 2 ? 1 : -1;
    text += "DirectionalLight { direction" + scene_text::word(direction) + " color 1 1 1 }\n";
  }
  return scene_text::parse(text +
                           "} Background { color 0.25 0.5 0.125 }"
                           "Materials { numMaterials 1 PhongMaterial { } }"
                           "Group { numObjects 1 MaterialIndex 0 Sphere { center 0 0 0 radius" +
                           scene_text::word(size) + "} }");
}

const PhongMaterial kMirror({1, 1, 1}, {0, 0, 0}, 1, {0, 0, 0}, {1, 1, 1}, 1);
const PhongMaterial kAir({0, 0, 0}, {0, 0, 0}, 1, {1, 1, 1}, {0, 0, 0}, 1);

RenderOptions adaptive() {
  RenderOptions options;
  options.epsilon = {Epsilon::Kind::adaptive, 0};
  return options;
}

/// What a lone convex mirror shows: the six lights on a white surface, and the background.
Vec3d loneMirror(const Vec3d& n) {
  const double light = std::fabs(n.x()) + std::fabs(n.y()) + std::fabs(n.z());
  return Vec3d(light, light, light) + Vec3d(0.25, 0.5, 0.125);
}

std::string describe(const Ray& ray, const Vec3f& found) {
  return check::show(ray.getOrigin()) + " along " + check::show(ray.getDirection()) + " found " +
         check::show(found);
}

}  // namespace

TEST("with adaptive epsilon no mirror or shadow ray meets the ball it leaves") {
  const SceneParser scene = lights(1);
  Random random(91);
  check::Cases cases;
  for (int i = 0; i < 60000; ++i) {
    const double radius = random.logUniform(1e-6, 1e6);
    const Vec3d center = random.ofLogLength(1e-3, 1e6);
    const Sphere sphere(center, radius, &kMirror);
    const RayTracer tracer(scene, sphere, adaptive());
    const Vec3d target = center + random.ofLength(0, 1) * radius;
    const Vec3d origin = center + random.ofLogLength(1.01, 1e3) * radius;
    Ray ray(origin, normalize(target - origin));
    Hit hit;
    const Vec3f found = tracer.traceRay(ray, 0, 0, 1, 1, hit);
    if (hit.getMaterial() == nullptr) continue;
    const Vec3d expected = loneMirror(hit.getNormal());
    cases.expect(maxAbs(Vec3d(found) - expected) < 1e-5, [&] { return describe(ray, found); });
  }
  CHECK(cases.tried() > 50000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("with adaptive epsilon a ray through a ball of air meets it exactly twice") {
  const SceneParser scene = lights(1);
  Random random(92);
  check::Cases cases;
  for (int i = 0; i < 60000; ++i) {
    const double radius = random.logUniform(1e-6, 1e6);
    const Vec3d center = random.ofLogLength(1e-3, 1e6);
    // The ball must be more than a few ulps of where it lies.
    if (radius < 1e-9 * length(center)) continue;
    const Sphere sphere(center, radius, &kAir);
    const Vec3d target = center + random.ofLength(0, 0.99) * radius;
    const Vec3d origin = center + random.ofLogLength(1.01, 1e3) * radius;
    Ray ray(origin, normalize(target - origin));
    // Two refractions see the background; with one allowed only, the second adds nothing.
    RenderOptions options = adaptive();
    options.maxBounces = 2;
    Hit hit, again;
    const Vec3f through = RayTracer(scene, sphere, options).traceRay(ray, 0, 0, 1, 1, hit);
    options.maxBounces = 1;
    const Vec3f stopped = RayTracer(scene, sphere, options).traceRay(ray, 0, 0, 1, 1, again);
    if (hit.getMaterial() == nullptr) continue;
    cases.expect(through == scene.getBackgroundColor() && stopped == Vec3f(),
                 [&] { return describe(ray, through); });
  }
  CHECK(cases.tried() > 50000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("with adaptive epsilon no ray meets the plane or triangle it leaves, however flat") {
  const SceneParser scene = lights(1);
  Random random(93);
  check::Cases cases;
  for (int i = 0; i < 30000; ++i) {
    const double size = random.logUniform(1e-6, 1e6), offset = random.uniform(-1e3, 1e3) * size;
    const Vec3d normal = random.unitVector(), side = normalize(cross(normal, random.unitVector()));
    const Plane plane(normal, offset, &kMirror);
    const Vec3d on = normal * offset;
    const Triangle triangle(on - side * size, on + side * size, on + cross(normal, side) * size,
                            &kMirror);
    const Object3D& object = i % 2 ? static_cast<const Object3D&>(plane) : triangle;
    const double slope = random.logUniform(1e-12, 1);
    const Vec3d target = on + cross(normal, side) * (size * random.uniform(0.1, 0.5));
    const Vec3d toward = normalize(side - normal * slope);
    Ray ray(target - toward * (size * random.uniform(0.1, 10)), toward);
    Hit hit;
    const Vec3f found = RayTracer(scene, object, adaptive()).traceRay(ray, 0, 0, 1, 1, hit);
    if (hit.getMaterial() == nullptr) continue;
    const Vec3d expected = loneMirror(hit.getNormal());
    cases.expect(maxAbs(Vec3d(found) - expected) < 1e-5, [&] { return describe(ray, found); });
  }
  CHECK(cases.tried() > 20000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

namespace {

/// A scene of everything, all its lengths times `unit`.
SceneParser sceneOfUnit(double unit) {
  const auto at = [&](double x, double y, double z) {
    return scene_text::word(Vec3d(x, y, z) * unit);
  };
  return scene_text::parse(
      "Lights { numLights 2 PointLight { position" + at(3, 7, 5) +
      "color 0.9 0.8 0.7 }"
      "  DirectionalLight { direction -1 -2 -0.5 color 0.3 0.4 0.5 } }"
      "Background { color 0.2 0.3 0.4 ambientLight 0.1 0.1 0.1 }"
      "Materials { numMaterials 3 PhongMaterial { diffuseColor 0.8 0.7 0.6 specularColor 1 1 1"
      "    exponent 20 reflectiveColor 0.4 0.4 0.4 }"
      "  PhongMaterial { diffuseColor 0.1 0.1 0.1 transparentColor 0.9 0.8 0.9"
      "    reflectiveColor 0.1 0.1 0.1 indexOfRefraction 1.5 }"
      "  PhongMaterial { diffuseColor 0.3 0.9 0.4 } }"
      "Group { numObjects 5 MaterialIndex 0 Plane { normal 0.1 1 0 offset" +
      scene_text::word(-1.3 * unit) + "} MaterialIndex 1 Sphere { center" + at(0.3, 0.1, 0) +
      "radius" + scene_text::word(0.9 * unit) + "} MaterialIndex 2 Triangle { vertex0" +
      at(-2, -1, -2) + "vertex1" + at(2, -1, -2) + "vertex2" + at(0, 2, -2.5) +
      "} MaterialIndex 0 Transform { Translate" + at(-1.5, 0, 0.5) +
      "Rotate { 1 2 3 40 } Scale 1 0.5 0.7 Sphere { center 0 0 0 radius" + scene_text::word(unit) +
      "} } MaterialIndex 2 Sphere { center" + at(1.6, -0.6, 0.9) + "radius" +
      scene_text::word(0.4 * unit) + "} }");
}

}  // namespace

TEST("a scene times a power of two gives the same colours bit for bit with adaptive epsilon") {
  for (int power : {-60, -31, -7, 1, 13, 60}) {
    const double unit = std::ldexp(1.0, power);
    const SceneParser plain = sceneOfUnit(1), scaled = sceneOfUnit(unit);
    const RayTracer tracer(plain, *plain.getGroup(), adaptive());
    const RayTracer scaledTracer(scaled, *scaled.getGroup(), adaptive());
    Random random(94);
    check::Cases cases;
    for (int i = 0; i < 3000; ++i) {
      const Vec3d origin = random.unitVector() * 6.0, target = random.inCube(-2, 2);
      const Vec3d direction = normalize(target - origin);
      Ray ray(origin, direction), scaledRay(origin * unit, direction);
      Hit hit, scaledHit;
      const Vec3f expected = tracer.traceRay(ray, 0, 0, 1, 1, hit);
      const Vec3f found = scaledTracer.traceRay(scaledRay, 0, 0, 1, 1, scaledHit);
      cases.expect(found == expected && scaledHit.getT() == hit.getT() * unit,
                   [&] { return "2^" + std::to_string(power) + ": " + describe(ray, found); });
    }
    CHECK_EQUAL(cases.firstFailure(), "");
  }
}

TEST("a neighbour more than 1e-9 of the largest number away is not passed") {
  // A mirror ray from the plane z = 1 straight back up meets a ceiling just above it; numbers of
  // size 1 and 1000 are involved.
  for (double size : {1.0, 1000.0}) {
    const SceneParser scene = lights(1);
    const PhongMaterial black({0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}, {0, 0, 0}, 1);
    const Plane floor({0, 0, 1}, size, &kMirror);
    const Plane ceiling({0, 0, 1}, size * (1 + 2e-9), &black);
    Group group;
    group.addObject(&floor);
    group.addObject(&ceiling);
    const RayTracer tracer(scene, group, adaptive());
    // The eye is between the two.
    Ray ray({0, 0, size * (1 + 1e-9)}, {0, 0, -1});
    Hit hit;
    const Vec3f found = tracer.traceRay(ray, 0, 0, 1, 1, hit);
    CHECK_EQUAL(hit.getMaterial(), &kMirror);
    CHECK_EQUAL(found, Vec3f());  // the ceiling is black and keeps all lights off
  }
}

namespace {

/// Whether a shadow caster 0.0005 above the ground is passed over, as a start at 0.001 does.
bool startsAtOneThousandth(const std::string& objects, int count, const RenderOptions& options) {
  const SceneParser scene = scene_text::parse(
      "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 1 1 } }"
      "Materials { numMaterials 1 PhongMaterial { } } Group { numObjects " +
      std::to_string(count + 2) +
      " MaterialIndex 0 Plane { normal 0 1 0 offset 0 } Plane { normal 0 1 0 offset 0.0005 }" +
      objects + "}");
  // From below the second plane, onto the ground.
  return scene_text::colorTowards(scene, {0.1, 0.0003, 0}, {0, 0, 0}, options) == Vec3f(1, 1, 1);
}

std::string ball(double radius) {
  return "Sphere { center 0 -5000 0 radius" + scene_text::word(radius) + "}";
}

}  // namespace

TEST("epsilon is the assignment's constant where the bounded objects span 1 to 1000 units") {
  CHECK(startsAtOneThousandth("", 0, {}));  // planes alone have no span
  CHECK(startsAtOneThousandth(ball(0.5), 1, {}));
  CHECK(startsAtOneThousandth(ball(500), 1, {}));
  CHECK(!startsAtOneThousandth(ball(0.499), 1, {}));
  CHECK(!startsAtOneThousandth(ball(501), 1, {}));
}

TEST("a chosen epsilon does not ask for the span") {
  RenderOptions options;
  options.epsilon = {Epsilon::Kind::fixed, Epsilon::kCourse};
  CHECK(startsAtOneThousandth(ball(2000), 1, options));
  options.epsilon = {Epsilon::Kind::fixed, 0.0001};
  CHECK(!startsAtOneThousandth(ball(10), 1, options));
  CHECK(!startsAtOneThousandth(ball(10), 1, adaptive()));
}

TEST("mirror and refracted rays pass what lies nearer than a chosen epsilon") {
  // A mirror and clear glass of index 1 at y = 0, black planes 0.0005 above and below it.
  const auto between = [](const std::string& field, double epsilon, double eye) {
    const SceneParser scene = scene_text::parse(
        "Background { color 0.25 0.5 0.75 } Materials { numMaterials 2 PhongMaterial {"
        "  diffuseColor 0 0 0 " +
        field +
        " 1 1 1 } PhongMaterial { diffuseColor 0 0 0 } }"
        "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 1 0 offset 0 }"
        "  MaterialIndex 1 Plane { normal 0 1 0 offset 0.0005 } }");
    RenderOptions options;
    options.epsilon = {Epsilon::Kind::fixed, epsilon};
    return scene_text::colorTowards(scene, {0, eye, 0}, {0, 0, 0}, options);
  };
  const Vec3f background(0.25f, 0.5f, 0.75f);
  CHECK_EQUAL(between("reflectiveColor", 0.001, 0.0003), background);
  CHECK_EQUAL(between("reflectiveColor", 0.0001, 0.0003), Vec3f());
  CHECK_EQUAL(between("transparentColor", 0.001, -1), background);
  CHECK_EQUAL(between("transparentColor", 0.0001, -1), Vec3f());
}
