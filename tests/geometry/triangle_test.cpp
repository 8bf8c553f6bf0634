// Triangle: closed-form hits, edges and vertices, degenerate ones, crossings.
#include "geometry/triangle.h"

#include "geometry/shapes.h"
#include "random.h"
#include "vectors.h"

using shapes::kInf;

namespace {

const PhongMaterial kMaterial = shapes::plainMaterial();

/// In the plane z = 1, counter-clockwise seen from above.
Triangle sample() { return Triangle({0, 0, 1}, {4, 0, 1}, {0, 4, 1}, &kMaterial); }

}  // namespace

TEST("a triangle is hit at its plane, with the normal of its winding, from both sides") {
  const Triangle triangle = sample();
  Hit above, below;
  CHECK(triangle.intersect(Ray({1, 1, 5}, {0, 0, -2}), above, 0));
  CHECK_EQUAL(above.getT(), 2.0);
  CHECK_EQUAL(above.getNormal(), Vec3d(0, 0, 1));
  CHECK_EQUAL(above.getMaterial(), &kMaterial);
  CHECK_EQUAL(above.getIntersectionPoint(), Vec3d(1, 1, 1));
  CHECK_EQUAL(above.getObject(), &triangle);
  CHECK(triangle.intersect(Ray({1, 1, 0}, {0, 0, 1}), below, 0));
  CHECK_EQUAL(below.getT(), 1.0);
  CHECK_EQUAL(below.getNormal(), Vec3d(0, 0, 1));
}

TEST("exchanging two vertices turns the normal round") {
  const Triangle triangle({0, 0, 1}, {0, 4, 1}, {4, 0, 1}, &kMaterial);
  Hit hit;
  CHECK(triangle.intersect(Ray({1, 1, 5}, {0, 0, -1}), hit, 0));
  CHECK_EQUAL(hit.getNormal(), Vec3d(0, 0, -1));
}

TEST("points outside each edge are missed") {
  const Triangle triangle = sample();
  for (const Vec3d& beside : {Vec3d(-0.001, 2, 5), Vec3d(2, -0.001, 5), Vec3d(2.001, 2.001, 5),
                              Vec3d(5, -0.5, 5), Vec3d(-0.5, 5, 5)}) {
    Hit hit(77);
    CHECK(!triangle.intersect(Ray(beside, {0, 0, -1}), hit, -kInf));
    CHECK(!triangle.occluded(Ray(beside, {0, 0, -1}), -kInf, kInf));
    CHECK_EQUAL(hit.getT(), 77.0);
  }
}

TEST("edges and vertices belong to the triangle") {
  const Triangle triangle = sample();
  for (const Vec3d& over : {Vec3d(0, 0, 5), Vec3d(4, 0, 5), Vec3d(0, 4, 5), Vec3d(2, 0, 5),
                            Vec3d(0, 2, 5), Vec3d(2, 2, 5)}) {
    Hit hit;
    CHECK(triangle.intersect(Ray(over, {0, 0, -1}), hit, 0));
    CHECK_EQUAL(hit.getT(), 4.0);
  }
}

TEST("a triangle seen edge-on is missed") {
  const Triangle triangle = sample();
  Hit hit;
  CHECK(!triangle.intersect(Ray({-3, 1, 1}, {1, 0, 0}), hit, -kInf));
  CHECK(!triangle.intersect(Ray({-3, -3, 1}, {1, 1, 0}), hit, -kInf));
}

TEST("tmin and the hit's t are strict limits of a triangle") {
  const Triangle triangle = sample();
  const Ray ray({1, 1, 5}, {0, 0, -1});
  Hit fresh, limited(4), enough(std::nextafter(4.0, 5.0));
  CHECK(!triangle.intersect(ray, fresh, 4));
  CHECK(!triangle.intersect(ray, limited, 0));
  CHECK(triangle.intersect(ray, enough, std::nextafter(4.0, 3.0)));
  CHECK(triangle.occluded(ray, 3.9, 4.1));
  CHECK(!triangle.occluded(ray, 4, 5));
  CHECK(!triangle.occluded(ray, 3, 4));
}

TEST("with tmin at minus infinity a triangle behind the origin is seen") {
  Hit hit;
  CHECK(sample().intersect(Ray({1, 1, -2}, {0, 0, -1}), hit, -kInf));
  CHECK_EQUAL(hit.getT(), -3.0);
  Hit none;
  CHECK(!sample().intersect(Ray({1, 1, -2}, {0, 0, -1}), none, 0));
}

TEST("a triangle without area is never hit") {
  const Vec3d a(0, 0, 0), b(1, 2, 3), c(2, 4, 6);
  Random random(33);
  for (const Triangle& flat :
       {Triangle(a, b, c, &kMaterial), Triangle(a, a, b, &kMaterial), Triangle(a, b, b, &kMaterial),
        Triangle(b, a, b, &kMaterial), Triangle(b, b, b, &kMaterial)}) {
    CHECK(!flat.hasArea());
    for (int i = 0; i < 200; ++i) {
      const Vec3d target = b * random.uniform(0, 2), origin = random.inCube(-5, 5);
      Hit hit;
      CHECK(!flat.intersect(Ray(origin, target - origin), hit, -kInf));
      CHECK(!flat.occluded(Ray(origin, target - origin), -kInf, kInf));
      CHECK_EQUAL(shapes::CrossingList(flat, Ray(origin, target - origin)).size(), 0);
    }
  }
  CHECK(sample().hasArea());
}

TEST("a triangle is crossed once, is open, and is left along its normal") {
  const Triangle triangle = sample();
  const shapes::CrossingList down(triangle, Ray({1, 1, 5}, {0, 0, -1}));
  CHECK_EQUAL(down.size(), 1);
  CHECK_EQUAL(down[0].t, 4.0);
  CHECK(!down[0].closed);
  CHECK(!down[0].leaving);
  const shapes::CrossingList up(triangle, Ray({1, 1, 0}, {0, 0, 1}));
  CHECK_EQUAL(up.size(), 1);
  CHECK(up[0].leaving);
  CHECK_EQUAL(shapes::CrossingList(triangle, Ray({1, 1, 0}, {0, 0, -1})).size(), 0);
}

TEST("a ray that leaves a triangle never meets it") {
  const Triangle triangle = sample();
  Ray ray({1, 1, 1 + 1e-9}, {0, 0, -1});
  ray.setSource(&triangle, 0);
  Hit hit;
  CHECK(!triangle.intersect(ray, hit, -kInf));
  CHECK(!triangle.occluded(ray, -kInf, kInf));
}

TEST("the bounds of a triangle are those of its moved vertices") {
  BoundingBox box;
  sample().addBounds(Matrix::translation({10, 0, 0}) * Matrix::scale({1, -2, 3}), box);
  CHECK_EQUAL(box.low(), Vec3d(10, -8, 3));
  CHECK_EQUAL(box.high(), Vec3d(14, 0, 3));
  CHECK(sample().isBounded());
}

TEST("random rays aimed inside random triangles hit there, and those aimed outside miss") {
  Random random(34);
  check::Cases cases;
  while (cases.tried() < 50000) {
    const Vec3d a = random.inCube(-10, 10), b = random.inCube(-10, 10), c = random.inCube(-10, 10);
    const Vec3d origin = random.inCube(-10, 10);
    const double u = random.uniform(-1, 2), v = random.uniform(-1, 2), w = 1 - u - v;
    const Vec3d toTarget = a * u + b * v + c * w - origin, area = cross(b - a, c - a);
    const double slope = dot(area, toTarget) / (length(area) * length(toTarget));
    const double margin = std::min({u, v, w});
    if (length(area) < 1 || std::fabs(slope) < 0.05 || std::fabs(margin) < 1e-6) continue;
    Hit hit;
    const bool found = Triangle(a, b, c, &kMaterial).intersect(Ray(origin, toTarget), hit, 0);
    const bool ok = margin > 0 ? found && std::fabs(hit.getT() - 1) < 1e-10 : !found;
    cases.expect(ok, [&] {
      return check::show(a) + check::show(b) + check::show(c) + " from " + check::show(origin) +
             " at " + check::show(u) + ", " + check::show(v);
    });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("however flat the ray strikes, t stays within the range of the vertices") {
  Random random(35);
  int hits = 0;
  check::Cases cases;
  for (int i = 0; i < 50000; ++i) {
    // Rays almost in the plane z = 1: slopes from 1e-18 to 1.
    const Vec3d origin{random.uniform(-20, -10), random.uniform(0, 4), 1};
    const double slope = random.logUniform(1e-18, 1);
    const Vec3d direction(1, 0, -slope);
    Ray ray(origin + Vec3d(0, 0, slope * random.uniform(10, 24)), direction);
    Hit hit;
    if (!sample().intersect(ray, hit, -kInf)) continue;
    ++hits;
    const double low = -ray.getOrigin().x(), high = 4 - ray.getOrigin().x();
    cases.expect(hit.getT() > low - 1e-9 && hit.getT() < high + 1e-9,
                 [&] { return "slope " + check::show(slope) + " t " + check::show(hit.getT()); });
  }
  CHECK(hits > 1000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("the side of an edge is decided without rounding") {
  // Seen along z the edge runs from p to -q with p = (1 + h, 1), q = (1, 1 - h), h = 2^-30. The
  // products (1 + h)(1 - h) and 1 round to the same double, but differ by h^2: the ray passes to
  // the left of the edge.
  const double h = 0x1p-30;
  const Vec3d p(1 + h, 1, 1), q(-1, -(1 - h), 1);
  const Triangle left(p, q, {1, -2, 1}, &kMaterial), right(q, p, {-2, 1, 1}, &kMaterial);
  const Ray ray({0, 0, 0}, {0, 0, 1});
  Hit hit, none;
  CHECK(left.intersect(ray, hit, 0) != right.intersect(ray, none, 0));
  CHECK(left.occluded(ray, 0, kInf));
  CHECK_EQUAL(shapes::CrossingList(left, ray).size(), 1);
  CHECK_EQUAL(shapes::CrossingList(right, ray).size(), 0);
}
