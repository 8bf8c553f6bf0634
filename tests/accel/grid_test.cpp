// The uniform grid: where it finds hits, and the bounds of its memory. That it finds what the plain
// objects give is also asked by every test that uses comparison.h.
#include "accel/grid/grid.h"

#include "../geometry/shapes.h"
#include "check.h"
#include "comparison.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"
#include "random_scene.h"

using accel_test::Comparison;
using accel_test::kInf;
using accel_test::Owner;
using accel_test::RandomScene;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A sphere that counts how often it is asked, and for what. One thread asks at a time.
class CountingSphere : public Sphere {
 public:
  struct Counts {
    int intersect = 0, occluded = 0;
  };
  CountingSphere(const Vec3d& center, Counts& counts, const Material* material)
      : Sphere(center, 0.5, material), counts_(&counts) {}

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override {
    ++counts_->intersect;
    return Sphere::intersect(ray, hit, tmin);
  }
  bool occluded(const Ray& ray, double tmin, double tmax) const override {
    ++counts_->occluded;
    return Sphere::occluded(ray, tmin, tmax);
  }

 private:
  Counts* counts_;
};

}  // namespace

TEST("a ray asks only the objects of the cells that it passes, up to the first hit") {
  // Ten balls in a row along x, one to a cell of side 2; the ray runs through all of them.
  Owner owner;
  CountingSphere::Counts counts[10];
  Group group;
  for (int i = 0; i < 10; ++i) {
    group.addObject(&owner.make<CountingSphere>(Vec3d(2 * i, 0, 0), counts[i], owner.material(0)));
  }
  const Grid grid(group, {10, 1, 1});
  Hit hit;
  CHECK(grid.intersect(Ray({-5, 0, 0}, {1, 0, 0}), hit, 0));
  CHECK_EQUAL(hit.getT(), 4.5);
  CHECK_EQUAL(counts[0].intersect, 1);
  CHECK(grid.occluded(Ray({25, 0, 0}, {-1, 0, 0}), 0, kInf));
  CHECK_EQUAL(counts[9].occluded, 1);
  for (int i = 1; i < 9; ++i) CHECK_EQUAL(counts[i].intersect + counts[i].occluded, 0);
}

TEST("from inside the grid, along its cells and from tmin = -infinity the nearest hit is found") {
  RandomScene scene(4, 60, 1, {0, 0, 0});
  Comparison comparison(scene.root(), "inside");
  Random random(12);
  for (int i = 0; i < 2000; ++i) {
    Vec3d direction;
    direction[random.index(3)] = random.index(2) ? 1 : -1;
    const double tmin = i % 3 == 0 ? -kInf : 0;
    comparison.ask(Ray(scene.somewhere(), direction), tmin, kInf);
    comparison.ask(Ray{scene.somewhere(), random.unitVector()}, tmin, kInf);
  }
  CHECK_EQUAL(comparison.firstFailure(), "");
  CHECK(comparison.hits() > 1000);
}

TEST("of equal spheres in one cell and in several the first one in the scene is hit") {
  Owner owner;
  Group group;
  const Sphere* first = nullptr;
  for (int i = 0; i < 8; ++i) {
    const auto& sphere = owner.make<Sphere>(Vec3d(), 1.0, owner.material(i));
    if (i == 0) first = &sphere;
    group.addObject(&sphere);
  }
  for (const GridSize& size : {GridSize{1, 1, 1}, GridSize{8, 8, 8}, GridSize{5, 1, 2}}) {
    const Grid grid(group, size);
    Hit hit;
    CHECK(grid.intersect(Ray({0, 0, 5}, {0, 0, -1}), hit, 0));
    CHECK(hit.getObject() == first);
  }
}

TEST(
    "cells that only the box of a ball or a triangle reaches, or that a ball surrounds, list "
    "nothing") {
  // The unit ball in 27 cells: of side 2/3, of which the one in the middle reaches sqrt(3)/3 from
  // the centre, and each of the eight in the corners comes as near.
  Owner owner;
  Group ball;
  ball.addObject(&owner.make<Sphere>(Vec3d(), 1.0, owner.material(0)));
  CHECK(contains(Grid(ball, {3, 3, 3}).describe(), "3 x 3 x 3 cells; 26 entries"));
  // Half a square, a right angle at (0, 0), in 4 x 4 cells: 1 + 2 + 3 + 4 have a part of it, and
  // the margin adds those at whose corners it ends: 3. The one cell along z is as thin.
  Group half;
  half.addObject(
      &owner.make<Triangle>(Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), owner.material(0)));
  CHECK(contains(Grid(half, {4, 4, 1}).describe(), "4 x 4 x 1 cells; 13 entries"));
}

TEST("triangles that cover the whole grid do not fill each of 2^24 cells with a list of its own") {
  // Each box covers all 2^24 cells: five boxes would take more than 2^26 entries. With sides of
  // 512, 512 and 8 cells they take 5 * 2^21 at the most.
  Owner owner;
  Group group;
  for (int i = 0; i < 5; ++i) {
    group.addObject(&owner.make<Triangle>(Vec3d(-1, -1, -1), Vec3d(1, 1, 1), Vec3d(-1, 1, 0.1 * i),
                                          owner.material(i)));
  }
  const Grid grid(group, {1024, 1024, 16});
  CHECK(contains(grid.describe(), "512 x 512 x 8 cells; "));
  Hit hit;
  CHECK(grid.intersect(Ray({-0.5, 0.5, 5}, {0, 0, -1}), hit, 0));
}

TEST("with little room cells grow to two entries a face, and every face is still hit") {
  // Two triangles whose boxes fill all four cells: 8 entries are too many, those of two cells not.
  Owner owner;
  Group crossed;
  for (const double x : {0.0, 4.0}) {
    crossed.addObject(&owner.make<Triangle>(Vec3d(x, 0, 0), Vec3d(4 - x, 1, 0), Vec3d(x, 1, 1),
                                            owner.material(0)));
  }
  CHECK(contains(Grid(crossed, {4, 1, 1}, nullptr, 7).describe(), "2 x 1 x 1 cells; "));
  CHECK(contains(Grid(crossed, {4, 1, 1}, nullptr, 8).describe(), "4 x 1 x 1 cells; "));
  CHECK(contains(Grid(crossed, {4, 1, 1}, nullptr, 1).describe(), "2 x 1 x 1 cells; "));
  Group group;
  const MeshGeometry* ball = owner.geometry(shapes::ball(2));
  group.addObject(&owner.make<TriangleMesh>(ball, owner.material(0)));
  CHECK_EQUAL(ball->faceCount(), 128u);
  const Grid grid(group, {4, 4, 4}, nullptr, 9);
  for (std::uint32_t face = 0; face < ball->faceCount(); ++face) {
    const Vec3d middle =
        (ball->corner(face, 0) + ball->corner(face, 1) + ball->corner(face, 2)) / 3;
    Hit hit;
    CHECK(grid.intersect(Ray(middle * 3, -middle), hit, 0));
    CHECK_EQUAL(hit.getFace(), face);
  }
}

TEST("planes stand beside the grid, and a scene of planes alone has no cells") {
  Owner owner;
  Group group;
  group.addObject(&owner.make<Plane>(Vec3d(0, 1, 0), -1.0, owner.material(0)));
  const Grid planes(group, {20, 20, 20});
  CHECK(contains(planes.describe(), "0 x 0 x 0 cells; 0 entries, 1 objects beside"));
  Hit hit;
  CHECK(planes.intersect(Ray({0, 5, 0}, {0, -1, 0}), hit, 0));
  CHECK_EQUAL(hit.getT(), 6);
}

TEST("rays from further away than a thousand sizes of the scene find the same hits") {
  RandomScene scene(8, 40, 1, {0, 0, 0});
  Comparison comparison(scene.root(), "far");
  Random random(3);
  for (int i = 0; i < 600; ++i) {
    const Vec3d from = random.ofLogLength(500, 1e15);
    const Vec3d aim = random.index(2) ? scene.target() : scene.somewhere() * 5;
    comparison.ask(Ray(from, normalize(aim - from)), 0, kInf);
  }
  CHECK_EQUAL(comparison.firstFailure(), "");
  CHECK(comparison.hits() > 100);
}
