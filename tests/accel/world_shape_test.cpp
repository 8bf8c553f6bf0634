// Which cells a ball and a triangle have a part in.
#include <vector>

#include "accel/grid/flat_scene.h"
#include "check.h"
#include "random.h"
#include "vectors.h"

using accel::WorldShape;

namespace {

const BoundingBox kUnitCell({0, 0, 0}, {1, 1, 1});

/// The part of a polygon where sign * p[axis] <= sign * bound. Source: Sutherland and Hodgman,
/// "Reentrant Polygon Clipping", 1974.
std::vector<Vec3d> clipped(const std::vector<Vec3d>& polygon, int axis, double sign, double bound) {
  std::vector<Vec3d> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double before = sign * (p[axis] - bound), behind = sign * (q[axis] - bound);
    if (before <= 0) result.push_back(p);
    if ((before < 0) != (behind < 0)) result.push_back(p + (q - p) * (before / (before - behind)));
  }
  return result;
}

/// The area of the part of a triangle that is inside a cell.
double areaInside(const Vec3d (&corners)[3], const BoundingBox& cell) {
  std::vector<Vec3d> polygon(corners, corners + 3);
  for (int axis = 0; axis < 3; ++axis) {
    polygon = clipped(polygon, axis, -1, cell.low()[axis]);
    polygon = clipped(polygon, axis, 1, cell.high()[axis]);
  }
  Vec3d sum;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return length(sum) / 2;
}

WorldShape triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return {Matrix(), {a, b, c}};
}

WorldShape ball(const Vec3d& center, double radius) {
  return {Matrix(), Sphere(center, radius, nullptr)};
}

bool overlap(const Vec3d (&corners)[3], const BoundingBox& cell) {
  BoundingBox box;
  for (const Vec3d& corner : corners) box.extend(corner);
  for (int axis = 0; axis < 3; ++axis) {
    if (box.low()[axis] >= cell.high()[axis] || box.high()[axis] <= cell.low()[axis]) return false;
  }
  return true;
}

}  // namespace

TEST("a triangle meets the cells in which clipping leaves some of it") {
  Random random(71);
  int met = 0, missed = 0;
  std::string failure;
  for (int i = 0; i < 40000; ++i) {
    const Vec3d low = random.inCube(-1, 1), size = random.inCube(0.05, 0.8);
    const BoundingBox cell(low, low + size);
    const double scale = random.logUniform(0.2, 4);
    const Vec3d at = random.inCube(-1, 1);
    const Vec3d corners[3] = {at + random.inCube(-scale, scale), at + random.inCube(-scale, scale),
                              at + random.inCube(-scale, scale)};
    if (!overlap(corners, cell)) continue;
    const double area = areaInside(corners, cell);
    if (area > 0 && area < 1e-6) continue;  // hardly more than touched
    const bool meets = triangle(corners[0], corners[1], corners[2]).meets(cell);
    (area > 0 ? met : missed) += 1;
    if (meets != (area > 0)) failure = "case " + std::to_string(i);
  }
  CHECK_EQUAL(failure, "");
  CHECK(met > 1000 && missed > 500);
}

TEST("touching a cell is not enough, but lying in the plane of its side is") {
  // A corner on the edge x = y = 1 of the cell, and a triangle in the plane x + y = 2 through it.
  const Vec3d beside(3, -0.5, 0.2), above(-0.5, 3, 0.8);
  CHECK(!triangle({1, 1, 0.5}, beside, above).meets(kUnitCell));
  CHECK(!triangle({0, 2, 0}, {2, 0, 0}, {1, 1, 1}).meets(kUnitCell));
  // The same, moved inwards by 1e-6.
  CHECK(triangle({1 - 1e-6, 1, 0.5}, beside, above).meets(kUnitCell));
  CHECK(triangle({0, 2 - 1e-6, 0}, {2, 0, 0}, {1, 1 - 1e-6, 1}).meets(kUnitCell));
  // In the plane z = 1, flat or nearly so.
  for (const double tilt : {0.0, 1e-15}) {
    CHECK(triangle({-1, 0, 1}, {3, -1, 1 - tilt}, {0, 3, 1 + tilt}).meets(kUnitCell));
  }
}

TEST("a ball meets a cell that is nearer than its radius, and surrounds one that is all inside") {
  // From (2, 3, 0.5) the nearest point of the unit cell is (1, 1, 0.5), sqrt(5) away.
  const Vec3d center(2, 3, 0.5);
  CHECK(!ball(center, std::sqrt(5) - 1e-12).meets(kUnitCell));
  CHECK(ball(center, std::sqrt(5) + 1e-12).meets(kUnitCell));
  // The farthest is (0, 0, 0) or (0, 0, 1): sqrt(13.25) away.
  CHECK(!ball(center, std::sqrt(13.25) - 1e-12).surrounds(kUnitCell));
  CHECK(ball(center, std::sqrt(13.25) + 1e-12).surrounds(kUnitCell));
  // From inside it is met, however small.
  CHECK(ball({0.5, 0.5, 0.5}, 0.01).meets(kUnitCell));
}

TEST("turned, mirrored and evenly stretched a ball stays one; otherwise only its box is known") {
  const Matrix turned = Matrix::rotation({1, 2, 3}, 40) * Matrix::scale({2, -2, 2});
  const Vec3d center(1, 1, 1);
  // Twice the radius, at twice the distance from the origin: sqrt(12) - 2 is left.
  const WorldShape moved(turned, Sphere(center, 1, nullptr));
  CHECK(moved.isKnown());
  const Vec3d middle = turned.transformPoint(center);
  const Vec3d end = middle * ((std::sqrt(12) - 2) / length(middle));
  CHECK(moved.meets({end * 1.001, end * 1.001}));
  CHECK(!moved.meets({end * 0.999, end * 0.999}));
  CHECK(!WorldShape(Matrix::scale({1, 1, 1.001}), Sphere(center, 1, nullptr)).isKnown());
  const double rows[3][4] = {{1, 0.001, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
  CHECK(!WorldShape(Matrix(rows), Sphere(center, 1, nullptr)).isKnown());
  const WorldShape box{BoundingBox()};
  CHECK(box.meets(kUnitCell) && !box.surrounds(kUnitCell));
}
