// Transforms inside Transforms, seen from so far away that rounding decides what is hit: the trees
// find the same all the same.
#include "accel/comparison.h"
#include "accel/random_scene.h"
#include "accel/transform_range.h"
#include "random.h"

namespace {

using namespace accel_test;

/// A ball that is turned and then squeezed to `squeeze` along y.
const Object3D* squeezedBall(Owner& owner, Random& random, double squeeze) {
  const Vec3d center = random.inCube(-1, 1), axis = random.unitVector();
  const Object3D* ball = &owner.make<Sphere>(center, 0.1, owner.material(0));
  const double degrees = random.uniform(0, 360);
  const Object3D* turned = &owner.make<Transform>(Matrix::rotation(axis, degrees), ball);
  return &owner.make<Transform>(Matrix::scale({1, squeeze, 1}), turned);
}

/// Several of them, a tree's worth.
void fill(Owner& owner, Random& random, double squeeze, Group& group) {
  for (int i = 0; i < 12; ++i) group.addObject(squeezedBall(owner, random, squeeze));
}

/// Asks about rays from 1e3 to 1e16 away, most of which miss by little.
void askFromFar(Random& random, Comparison& comparison) {
  for (int i = 0; i < 3000; ++i) {
    const Vec3d away = random.unitVector();
    const Vec3d from = away * random.logUniform(1e3, 1e16);
    const Vec3d aim = random.inCube(-20, 20);
    const Ray ray(from, normalize(aim - from));
    comparison.ask(ray, 0, kInf);
    comparison.askCrossings(ray);
  }
}

}  // namespace

TEST("squeezed and turned balls are found from far away where rounding says that they are hit") {
  // From 1e14 away, squeezed to 1e-3: in the balls' own space the ray starts at up to 1e17, where
  // neighbouring doubles are 16 apart, along every axis. So a ball of radius 0.1 may seem to be hit
  // by a ray that passes it by several units, in the world too.
  Owner owner;
  Group group;
  Random random(31);
  fill(owner, random, 1e-3, group);
  Comparison comparison(group, "squeezed");
  askFromFar(random, comparison);
  CHECK_EQUAL(comparison.firstFailure(), "");
  CHECK(comparison.hits() > 100);
}

TEST("so are those that stand alone under a Transform, which only rays at its box are moved into") {
  Owner owner;
  Random random(31);
  Group balls, group;
  fill(owner, random, 1, balls);
  group.addObject(&owner.make<Transform>(Matrix::scale({1, 1e-3, 1}), &balls));
  Comparison comparison(group, "alone");
  askFromFar(random, comparison);
  CHECK_EQUAL(comparison.firstFailure(), "");
  CHECK(comparison.hits() > 50);
}

TEST("the noise of a Transform grows with what it squeezes, and of nested ones with the product") {
  Owner owner;
  const Object3D* ball = &owner.make<Sphere>(Vec3d(), 1.0, owner.material(0));
  const Transform plain(Matrix(), ball);
  // Nothing moves: two steps of 2 each, in and out by a factor of 1; the product is exact.
  const accel::TransformError none = accel::errorThrough(plain, {});
  CHECK_EQUAL(none.perSize, 4);
  CHECK_EQUAL(none.fixed, 0);
  // y / 1024: inside numbers are 1024 times as large, and the way out keeps x and z.
  const Transform flat(Matrix::scale({1, 0x1p-10, 1}), ball);
  CHECK_EQUAL(accel::errorThrough(flat, {}).perSize, 4 * 1024);
  CHECK_EQUAL(accel::errorThrough(flat, accel::errorThrough(flat, {})).perSize,
              (4 + 4 * 1024) * 1024);
  // x - 8 inside: 4 times that, and 2 times the offset on the way out.
  const Transform moved(Matrix::translation({8, 0, 0}), ball);
  CHECK_EQUAL(accel::errorThrough(moved, {}).perSize, 4);
  CHECK_EQUAL(accel::errorThrough(moved, {}).fixed, 4 * 8 + 2 * 8);
  // What is nested errs at x = 0 by 100: taken through the translation by as much.
  CHECK_EQUAL(accel::errorThrough(moved, {0, 100}).fixed, 4 * 8 + 2 * 8 + 100);
}
