// BoundingBox: empty boxes, growth, and the longest side.
#include "math/bounding_box.h"

#include "vectors.h"

TEST("a new box is empty and has no side") {
  CHECK(BoundingBox().isEmpty());
  CHECK_EQUAL(BoundingBox().longestSide(), 0.0);
}

TEST("a box with one point is that point") {
  BoundingBox box;
  box.extend(Vec3d(1, -2, 3));
  CHECK(!box.isEmpty());
  CHECK_EQUAL(box.low(), Vec3d(1, -2, 3));
  CHECK_EQUAL(box.high(), Vec3d(1, -2, 3));
  CHECK_EQUAL(box.longestSide(), 0.0);
}

TEST("a box grows on every side that a point lies beyond") {
  BoundingBox box(Vec3d(0, 0, 0), Vec3d(1, 1, 1));
  box.extend(Vec3d(0.5, -2, 4));
  CHECK_EQUAL(box.low(), Vec3d(0, -2, 0));
  CHECK_EQUAL(box.high(), Vec3d(1, 1, 4));
}

TEST("an empty box does not change the box that it is added to") {
  BoundingBox box(Vec3d(0, 1, 2), Vec3d(3, 4, 5));
  box.extend(BoundingBox());
  CHECK_EQUAL(box.low(), Vec3d(0, 1, 2));
  CHECK_EQUAL(box.high(), Vec3d(3, 4, 5));
  BoundingBox empty;
  empty.extend(BoundingBox());
  CHECK(empty.isEmpty());
}

TEST("two boxes join to the box around both") {
  BoundingBox box(Vec3d(0, 0, 0), Vec3d(1, 1, 1));
  box.extend(BoundingBox(Vec3d(-1, 0.5, 3), Vec3d(0, 0.75, 4)));
  CHECK_EQUAL(box.low(), Vec3d(-1, 0, 0));
  CHECK_EQUAL(box.high(), Vec3d(1, 1, 4));
}

TEST("the longest side is found along each axis") {
  CHECK_EQUAL(BoundingBox(Vec3d(-4, 0, 0), Vec3d(3, 1, 2)).longestSide(), 7.0);
  CHECK_EQUAL(BoundingBox(Vec3d(0, -4, 0), Vec3d(1, 3, 2)).longestSide(), 7.0);
  CHECK_EQUAL(BoundingBox(Vec3d(0, 0, -4), Vec3d(1, 2, 3)).longestSide(), 7.0);
}

TEST("a widened box reaches further on every side") {
  const BoundingBox box = BoundingBox(Vec3d(0, 1, 2), Vec3d(3, 4, 5)).widened(0.5);
  CHECK_EQUAL(box.low(), Vec3d(-0.5, 0.5, 1.5));
  CHECK_EQUAL(box.high(), Vec3d(3.5, 4.5, 5.5));
}

TEST("a moved box is the box of the moved corners") {
  // (x, y, z) -> (x + y, y - x, -3 z + 1): the square becomes a diamond from -2 to 3 and -2 to 3.
  const double rows[3][4] = {{1, 1, 0, 0}, {-1, 1, 0, 0}, {0, 0, -3, 1}};
  const BoundingBox box = BoundingBox(Vec3d(-1, -1, 0), Vec3d(1, 2, 4)).moved(Matrix(rows));
  CHECK_EQUAL(box.low(), Vec3d(-2, -2, -11));
  CHECK_EQUAL(box.high(), Vec3d(3, 3, 1));
}
