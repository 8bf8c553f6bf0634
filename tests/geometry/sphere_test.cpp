// Sphere: both roots, limits, crossings, rays that leave it, and far-away spheres.
#include "geometry/sphere.h"

#include "geometry/shapes.h"
#include "random.h"
#include "vectors.h"

using shapes::kInf;

namespace {

const PhongMaterial kMaterial = shapes::plainMaterial();

}  // namespace

// The sphere of radius 2 around (1, 2, 3), met along -z from (1, 2, 10), lies at t = 5 and t = 9.
TEST("a ray from outside meets the near side") {
  const Sphere sphere({1, 2, 3}, 2, &kMaterial);
  const Ray ray({1, 2, 10}, {0, 0, -1});
  Hit hit;
  CHECK(sphere.intersect(ray, hit, 0));
  CHECK_EQUAL(hit.getT(), 5.0);
  CHECK_EQUAL(hit.getMaterial(), &kMaterial);
  CHECK_EQUAL(hit.getNormal(), Vec3d(0, 0, 1));
  CHECK_EQUAL(hit.getIntersectionPoint(), Vec3d(1, 2, 5));
  CHECK_EQUAL(hit.getObject(), &sphere);
}

TEST("a ray from inside meets the far side, whose normal points outwards") {
  const Sphere sphere({1, 2, 3}, 2, &kMaterial);
  Hit hit;
  CHECK(sphere.intersect(Ray({1, 2, 3}, {0, 1, 0}), hit, 0));
  CHECK_EQUAL(hit.getT(), 2.0);
  CHECK_EQUAL(hit.getNormal(), Vec3d(0, 1, 0));
}

TEST("an off-centre ray meets the sphere where Pythagoras says") {
  // 3-4-5: at height 3 the sphere of radius 5 is met 4 before its middle.
  const Sphere sphere({0, 0, 0}, 5, &kMaterial);
  Hit hit;
  CHECK(sphere.intersect(Ray({-10, 3, 0}, {1, 0, 0}), hit, 0));
  CHECK_NEAR(hit.getT(), 6, 1e-14);
  CHECK_NEAR_VECTOR(hit.getNormal(), Vec3d(-0.8, 0.6, 0), 1e-15);
}

TEST("t counts in lengths of the direction, which need not be a unit vector") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial);
  for (double scale : {0.001, 0.5, 4.0, 1e6}) {
    Hit hit;
    CHECK(sphere.intersect(Ray({0, 0, 5}, {0, 0, -scale}), hit, 0));
    CHECK_NEAR(hit.getT() * scale, 4, 1e-14);
    CHECK_NEAR_VECTOR(hit.getNormal(), Vec3d(0, 0, 1), 1e-15);
  }
}

TEST("a ray that passes beside or points away misses and leaves the hit alone") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial);
  Hit hit(50);
  CHECK(!sphere.intersect(Ray({0, 1.0001, 5}, {0, 0, -1}), hit, 0));
  CHECK(!sphere.intersect(Ray({0, 0, 5}, {0, 0, 1}), hit, 0));
  CHECK_EQUAL(hit.getT(), 50.0);
  CHECK(hit.getMaterial() == nullptr);
}

TEST("tmin and the hit's t are strict limits") {
  const Sphere sphere({1, 2, 3}, 2, &kMaterial);
  const Ray ray({1, 2, 10}, {0, 0, -1});
  Hit behindNear;
  CHECK(sphere.intersect(ray, behindNear, 5));
  CHECK_EQUAL(behindNear.getT(), 9.0);
  Hit fresh, limited(5);
  CHECK(!sphere.intersect(ray, fresh, 9));
  CHECK(!sphere.intersect(ray, limited, 0));
  Hit justEnough(std::nextafter(5.0, 6.0));
  CHECK(sphere.intersect(ray, justEnough, std::nextafter(5.0, 4.0)));
}

TEST("with tmin at minus infinity the first root counts even behind the origin") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial);
  Hit hit;
  CHECK(sphere.intersect(Ray({0, 0, -7}, {0, 0, -1}), hit, -kInf));
  CHECK_EQUAL(hit.getT(), -8.0);
  CHECK_EQUAL(hit.getNormal(), Vec3d(0, 0, 1));
}

TEST("a sphere is in the way only strictly between tmin and tmax") {
  const Sphere sphere({1, 2, 3}, 2, &kMaterial);  // t = 5 and 9
  const Ray ray({1, 2, 10}, {0, 0, -1});
  CHECK(sphere.occluded(ray, 0, 100));
  CHECK(sphere.occluded(ray, 0, kInf));
  CHECK(sphere.occluded(ray, 5, 9.5));
  CHECK(sphere.occluded(ray, -kInf, 6));
  CHECK(!sphere.occluded(ray, 0, 5));
  CHECK(!sphere.occluded(ray, 5, 9));
  CHECK(!sphere.occluded(ray, 9, kInf));
}

TEST("a ray through a sphere crosses inwards, then outwards") {
  const Sphere sphere({1, 2, 3}, 2, &kMaterial);
  const shapes::CrossingList list(sphere, Ray({1, 2, 10}, {0, 0, -1}));
  CHECK_EQUAL(list.size(), 2);
  CHECK_EQUAL(list[0].t, 5.0);
  CHECK_EQUAL(list[1].t, 9.0);
  CHECK(!list[0].leaving);
  CHECK(list[1].leaving);
  for (int i : {0, 1}) {
    CHECK(list[i].closed);
    CHECK_EQUAL(list[i].object, &sphere);
    CHECK_EQUAL(list[i].material, &kMaterial);
  }
}

TEST("crossings behind the origin are not reported") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial);
  const shapes::CrossingList inside(sphere, Ray({0, 0, 0.5}, {0, 0, 1}));
  CHECK_EQUAL(inside.size(), 1);
  CHECK_EQUAL(inside[0].t, 0.5);
  CHECK(inside[0].leaving);
  CHECK_EQUAL(shapes::CrossingList(sphere, Ray({0, 0, 5}, {0, 0, 1})).size(), 0);
}

TEST("a ray that leaves a sphere meets it only on the other side") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial);
  for (double error : {-1e-12, 0.0, 1e-12}) {
    Ray inwards({0, 0, 1 + error}, {0, 0, -1}), outwards({0, 0, 1 + error}, {0, 0, 1});
    inwards.setSource(&sphere, 0);
    outwards.setSource(&sphere, 0);
    Hit hit, none;
    CHECK(sphere.intersect(inwards, hit, 0));
    CHECK_NEAR(hit.getT(), 2, 1e-11);
    CHECK(!sphere.intersect(outwards, none, 0));
    CHECK(!sphere.occluded(outwards, 0, kInf));
  }
}

TEST("a ray that leaves another sphere meets this one as usual") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial), other({0, 0, 5}, 1, &kMaterial);
  Ray ray({0, 0, 4}, {0, 0, -1});
  ray.setSource(&other, 0);
  Hit hit;
  CHECK(sphere.intersect(ray, hit, 0));
  CHECK_EQUAL(hit.getT(), 3.0);
}

TEST("the bounds of a sphere are its centre plus and minus its radius") {
  const Sphere sphere({1, 2, 3}, 2, &kMaterial);
  BoundingBox box;
  sphere.addBounds(Matrix(), box);
  CHECK_EQUAL(box.low(), Vec3d(-1, 0, 1));
  CHECK_EQUAL(box.high(), Vec3d(3, 4, 5));
  CHECK(sphere.isBounded());
}

TEST("the bounds of a turned and stretched sphere fit tightly") {
  // Rows (0, -3, 0) and (2, 0, 0): the ball becomes an ellipsoid of half axes 3 r, 2 r and r.
  const Sphere sphere({1, 1, 1}, 2, &kMaterial);
  BoundingBox box;
  sphere.addBounds(Matrix::rotation({0, 0, 1}, 90) * Matrix::scale({2, 3, 1}), box);
  CHECK_NEAR_VECTOR(box.low(), Vec3d(-3 - 6, 2 - 4, 1 - 2), 1e-13);
  CHECK_NEAR_VECTOR(box.high(), Vec3d(-3 + 6, 2 + 4, 1 + 2), 1e-13);
  BoundingBox turned;
  Sphere({0, 0, 0}, 1, &kMaterial).addBounds(Matrix::rotation({1, 2, 3}, 33), turned);
  CHECK_NEAR(turned.longestSide(), 2, 1e-14);
}

TEST("random rays at spheres of every size hit them where long double arithmetic says") {
  Random random(31);
  check::Cases cases;
  for (int i = 0; i < 100000; ++i) {
    const double radius = random.logUniform(1e-6, 1e6);
    const Vec3d center = random.ofLogLength(1e-3, 1e6);
    const Vec3d normal = random.unitVector(), p = center + normal * radius;
    Vec3d away = random.unitVector();
    if (dot(away, normal) < 0) away = -away;
    if (dot(away, normal) < 0.3) continue;  // a grazing ray multiplies every error
    const double distance = random.logUniform(1e-3, 1e6);
    const Sphere sphere(center, radius, &kMaterial);
    Hit hit;
    const bool found = sphere.intersect(Ray(p + away * distance, -away), hit, 0);
    // p itself is off by an ulp of the largest number, which the slope makes 1 / 0.3 times more.
    const double size = std::max({radius, maxAbs(center), distance}), bound = 1e-14 * size;
    if (bound > 0.1 * radius) continue;
    const bool ok = found && std::fabs(hit.getT() - distance) < bound &&
                    length(hit.getNormal() - normal) < bound / radius + 1e-14 &&
                    hit.getMagnitude() >= std::max(radius, distance) * (1 - 1e-6);
    cases.expect(ok, [&] {
      return "radius " + check::show(radius) + " at " + check::show(center) + " from " +
             check::show(distance) + " found " + check::show(hit.getT());
    });
  }
  CHECK(cases.tried() > 60000);
  CHECK_EQUAL(cases.firstFailure(), "");
}
