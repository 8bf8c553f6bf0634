// Plane: offsets along the normalised normal, limits, parallel rays, crossings.
#include "geometry/plane.h"

#include "geometry/shapes.h"
#include "random.h"
#include "vectors.h"

using shapes::kInf;

namespace {

const PhongMaterial kMaterial = shapes::plainMaterial();

}  // namespace

TEST("the normal is normalised, and the offset counts along the unit normal") {
  const Plane plane({0, 10, 0}, 2, &kMaterial);
  CHECK_EQUAL(plane.getNormal(), Vec3d(0, 1, 0));
  CHECK_EQUAL(plane.getOffset(), 2.0);
  Hit hit;
  CHECK(plane.intersect(Ray({3, 7, 4}, {0, -1, 0}), hit, 0));
  CHECK_EQUAL(hit.getT(), 5.0);
  CHECK_EQUAL(hit.getNormal(), Vec3d(0, 1, 0));
  CHECK_EQUAL(hit.getIntersectionPoint(), Vec3d(3, 2, 4));
  CHECK_EQUAL(hit.getMaterial(), &kMaterial);
  CHECK_EQUAL(hit.getObject(), &plane);
}

TEST("a plane is hit from below with the same normal") {
  const Plane plane({0, 1, 0}, 2, &kMaterial);
  Hit hit;
  CHECK(plane.intersect(Ray({0, -1, 0}, {0, 0.5, 0}), hit, 0));
  CHECK_EQUAL(hit.getT(), 6.0);  // 3 units at half a unit each
  CHECK_EQUAL(hit.getNormal(), Vec3d(0, 1, 0));
}

TEST("a slanted plane is met at (offset - n.o) / n.d") {
  // n = (2, 3, 6) / 7; from the origin along z: t = 3 / (6 / 7) = 3.5.
  const Plane plane({2, 3, 6}, 3, &kMaterial);
  Hit hit;
  CHECK(plane.intersect(Ray({0, 0, 0}, {0, 0, 1}), hit, 0));
  CHECK_NEAR(hit.getT(), 3.5, 1e-14);
}

TEST("a ray parallel to a plane never meets it, inside it or beside it") {
  const Plane plane({0, 1, 0}, 2, &kMaterial);
  for (double height : {2.0, 5.0}) {
    Hit hit(9);
    const Ray ray({0, height, 0}, {1, 0, 1});
    CHECK(!plane.intersect(ray, hit, -kInf));
    CHECK(!plane.occluded(ray, -kInf, kInf));
    CHECK_EQUAL(shapes::CrossingList(plane, ray).size(), 0);
    CHECK_EQUAL(hit.getT(), 9.0);
  }
}

TEST("tmin and the hit's t are strict limits of a plane") {
  const Plane plane({0, 0, 1}, 0, &kMaterial);
  const Ray ray({0, 0, 4}, {0, 0, -1});
  Hit fresh, limited(4), enough(std::nextafter(4.0, 5.0));
  CHECK(!plane.intersect(ray, fresh, 4));
  CHECK(!plane.intersect(ray, limited, 0));
  CHECK(plane.intersect(ray, enough, std::nextafter(4.0, 3.0)));
  CHECK(plane.occluded(ray, 3.9, 4.1));
  CHECK(!plane.occluded(ray, 4, 5));
  CHECK(!plane.occluded(ray, 3, 4));
}

TEST("with tmin at minus infinity a plane behind the origin is seen") {
  const Plane plane({0, 0, 1}, 0, &kMaterial);
  const Ray ray({0, 0, -4}, {0, 0, -1});
  Hit hit, none;
  CHECK(plane.intersect(ray, hit, -kInf));
  CHECK_EQUAL(hit.getT(), -4.0);
  CHECK(!plane.intersect(ray, none, 0));
}

TEST("a plane is crossed once, is open, and is left along its normal") {
  const Plane plane({0, 0, 1}, 0, &kMaterial);
  const shapes::CrossingList down(plane, Ray({0, 0, 4}, {0, 0, -1}));
  CHECK_EQUAL(down.size(), 1);
  CHECK_EQUAL(down[0].t, 4.0);
  CHECK(!down[0].closed);
  CHECK(!down[0].leaving);
  const shapes::CrossingList up(plane, Ray({0, 0, -4}, {0, 0, 1}));
  CHECK_EQUAL(up.size(), 1);
  CHECK(up[0].leaving);
  CHECK_EQUAL(shapes::CrossingList(plane, Ray({0, 0, 4}, {0, 0, 1})).size(), 0);
}

TEST("a ray that leaves a plane never meets it") {
  const Plane plane({0, 0, 1}, 0, &kMaterial);
  for (double error : {-1e-9, 0.0, 1e-9}) {
    Ray ray({0, 0, error}, {0.6, 0, -0.8});
    ray.setSource(&plane, 0);
    Hit hit;
    CHECK(!plane.intersect(ray, hit, -kInf));
    CHECK(!plane.occluded(ray, -kInf, kInf));
  }
}

TEST("a plane has no bounds") {
  const Plane plane({0, 0, 1}, 0, &kMaterial);
  BoundingBox box;
  plane.addBounds(Matrix(), box);
  CHECK(box.isEmpty());
  CHECK(!plane.isBounded());
}

TEST("random rays meet random planes in the plane") {
  Random random(32);
  check::Cases cases;
  for (int i = 0; i < 50000; ++i) {
    const double offset = random.uniform(-100, 100);
    const Plane plane(random.inCube(-3, 3), offset, &kMaterial);
    const Ray ray{random.inCube(-100, 100), random.unitVector()};
    if (std::fabs(dot(ray.getDirection(), plane.getNormal())) < 0.01) continue;
    Hit hit;
    const bool found = plane.intersect(ray, hit, -kInf);
    // The point's coordinates reach 300 / 0.01; each is rounded to some 1e-16 of that.
    const double error = dot(plane.getNormal(), hit.getIntersectionPoint()) - offset;
    cases.expect(found && std::fabs(error) < 1e-14 * hit.getMagnitude(),
                 [&] { return check::show(plane.getNormal()) + " off by " + check::show(error); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}
