// The cells of a grid, and the walk through them.
#include "accel/grid/grid_frame.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "check.h"
#include "random.h"
#include "vectors.h"

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;  // far above the walk's own rounding for numbers up to 1000

BoundingBox boxOf(const Vec3d& low, const Vec3d& high) { return {low, high}; }

/// True where the ray is, for some t >= tmin, in cell `at` grown by `grown` on every side: one
/// interval of t for each axis, cut with each other.
bool passes(const GridFrame& frame, const GridSize& at, const Ray& ray, double tmin, double grown) {
  double from = tmin, to = kInf;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = frame.plane(axis, at[axis]) - grown;
    const double high = frame.plane(axis, at[axis] + 1) + grown;
    const double o = ray.getOrigin()[axis], d = ray.getDirection()[axis];
    if (d == 0 && (o < low || o > high)) return false;
    if (d == 0) continue;
    from = std::max(from, std::min((low - o) / d, (high - o) / d));
    to = std::min(to, std::max((low - o) / d, (high - o) / d));
  }
  return from <= to;
}

std::string describe(const Ray& ray, double tmin) {
  return "ray " + check::show(ray.getOrigin()) + " " + check::show(ray.getDirection()) + ", tmin " +
         check::show(tmin);
}

/// What is wrong with the walk, by the brute-force test of every cell; "" where nothing is.
std::string mistakeOf(const GridFrame& frame, const Ray& ray, double tmin) {
  std::vector<bool> visited(frame.cellCount());
  double last = tmin;
  GridSize before{};
  int steps = 0;
  for (CellWalk walk(frame, ray, tmin); !walk.isAtEnd(); walk.advance(), ++steps) {
    const GridSize& at = walk.cell();
    if (visited[walk.index()]) return "a cell comes twice";
    visited[walk.index()] = true;
    if (!(walk.enterT() >= last)) return "a cell is entered before the last one is left";
    last = walk.enterT();
    const int moved =
        std::abs(at[0] - before[0]) + std::abs(at[1] - before[1]) + std::abs(at[2] - before[2]);
    if (steps > 0 && moved != 1) return "two cells in a row do not share a side";
    before = at;
    if (!passes(frame, at, ray, tmin, kRounding)) return "a cell is visited that the ray misses";
  }
  GridSize at;
  for (at[2] = 0; at[2] < frame.size()[2]; ++at[2]) {
    for (at[1] = 0; at[1] < frame.size()[1]; ++at[1]) {
      for (at[0] = 0; at[0] < frame.size()[0]; ++at[0]) {
        if (!visited[frame.indexOf(at)] && passes(frame, at, ray, tmin, -kRounding)) {
          return "a cell that the ray passes is not visited";
        }
      }
    }
  }
  return "";
}

/// A corner of a cell, or any point in and around the frame.
Vec3d somePoint(Random& random, const GridFrame& frame) {
  Vec3d point;
  const bool isCorner = random.index(2) == 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int size = frame.size()[axis];
    const double low = frame.plane(axis, 0), high = frame.plane(axis, size);
    point[axis] = isCorner ? frame.plane(axis, random.index(size + 1))
                           : random.uniform(2 * low - high, 2 * high - low);
  }
  return point;
}

Vec3d someDirection(Random& random, const GridFrame& frame, const Vec3d& from) {
  Vec3d direction = somePoint(random, frame) - from;
  const int kind = random.index(4);
  if (kind == 0) direction[random.index(3)] = random.index(2) ? 0.0 : -0.0;
  if (kind == 1) {  // along an axis
    direction = Vec3d();
    direction[random.index(3)] = random.index(2) ? 1 : -1;
  }
  return direction == Vec3d() ? Vec3d(0, 0, 1) : direction;
}

}  // namespace

TEST("a walk visits the cells that a brute-force test of every cell finds, in order") {
  Random random(1987);
  check::Cases cases;
  for (const GridSize& size : {GridSize{1, 1, 1}, GridSize{5, 5, 5}, GridSize{9, 2, 4}}) {
    const GridFrame frame(boxOf({-1, 0, 2}, {3, 1, 7}), size);
    for (int i = 0; i < 5000; ++i) {
      const Vec3d from = somePoint(random, frame);
      const Ray ray(from, someDirection(random, frame, from));
      const double tmin = i % 3 == 0 ? -kInf : i % 3 == 1 ? 0 : random.uniform(-1, 1);
      const std::string mistake = mistakeOf(frame, ray, tmin);
      cases.expect(mistake.empty(), [&] { return describe(ray, tmin) + ": " + mistake; });
    }
  }
  CHECK_EQUAL(cases.tried(), 15000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("a walk along an axis enters and leaves each cell where its sides stand") {
  // Four cells of side 2 from x = -4 to 4; the ray starts at x = 10 and looks back, at speed 2:
  // the sides at 4, 2, 0, -2, -4 come at t = 3, 4, 5, 6, 7.
  const GridFrame frame(boxOf({-4, -1, -1}, {4, 1, 1}), {4, 1, 1});
  CellWalk walk(frame, Ray({10, 0.5, 0.5}, {-2, 0, 0}), 0);
  for (int cell = 3; cell >= 0; --cell, walk.advance()) {
    CHECK(!walk.isAtEnd());
    CHECK_EQUAL(walk.cell()[0], cell);
    CHECK_EQUAL(walk.enterT(), 6 - cell);
    CHECK_EQUAL(walk.exitT(), 7 - cell);
    CHECK_EQUAL(walk.enterAxis(), 0);
    CHECK_EQUAL(walk.exitAxis(), 0);
  }
  CHECK(walk.isAtEnd());
}

TEST("a walk that starts inside begins at tmin, in the cell of that place, across no side") {
  const GridFrame frame(boxOf({0, 0, 0}, {4, 4, 4}), {4, 4, 4});
  // At t = -1 the ray is at (1.5, 2.5, 3.5).
  const CellWalk inside(frame, Ray({1.5, 2.5, 2.5}, {0, 0, -1}), -1);
  CHECK(inside.cell() == (GridSize{1, 2, 3}));
  CHECK_EQUAL(inside.enterT(), -1);
  CHECK_EQUAL(inside.enterAxis(), -1);
  CHECK_EQUAL(inside.exitT(), -0.5);
  // From -infinity on, the ray comes in through the upper side, z = 4 at t = -1.5.
  const CellWalk endless(frame, Ray({1.5, 2.5, 2.5}, {0, 0, -1}), -kInf);
  CHECK_EQUAL(endless.enterT(), -1.5);
  CHECK_EQUAL(endless.enterAxis(), 2);
}

TEST("a ray that passes by, looks away or has passed before tmin visits nothing") {
  const GridFrame frame(boxOf({0, 0, 0}, {4, 4, 4}), {4, 4, 4});
  CHECK(CellWalk(frame, Ray({5, 1, 1}, {0, 1, 0}), -kInf).isAtEnd());
  CHECK(CellWalk(frame, Ray({5, 1, 1}, {1, 0, 0}), 0).isAtEnd());
  CHECK(CellWalk(frame, Ray({-1, 1, 1}, {1, 0, 0}), 6).isAtEnd());
  CHECK(CellWalk(frame, Ray({-1, 5, 1}, {1, -0.1, 0}), 0).isAtEnd());
  CHECK(!CellWalk(frame, Ray({-1, 1, 1}, {1, 0, 0}), 4).isAtEnd());
  const double nan = std::nan("");
  CHECK(CellWalk(frame, Ray({nan, nan, nan}, {nan, nan, nan}), 0).isAtEnd());
}

TEST("of an empty box there are no cells, and no ray passes any") {
  const GridFrame frame(BoundingBox(), {3, 3, 3});
  CHECK_EQUAL(frame.cellCount(), 0u);
  for (const Vec3d& direction : {Vec3d(1, 0, 0), Vec3d(0, 0, -1), Vec3d(1, -2, 3)}) {
    CHECK(CellWalk(frame, Ray({0, 0, 0}, direction), -kInf).isAtEnd());
    CHECK(CellWalk(frame, Ray({5, 5, 5}, direction), 0).isAtEnd());
  }
}

TEST("a box overlaps the cells that it reaches into, not those that it only touches") {
  const GridFrame frame(boxOf({0, 0, 0}, {8, 8, 8}), {8, 8, 8});
  const BoundingBox box = boxOf({1, 2.5, 4}, {3, 2.75, 4});
  const CellRange cells = frame.overlappedBy(box);
  CHECK(cells.first == (GridSize{1, 2, 4}) && cells.last == (GridSize{2, 2, 4}));
  CHECK_EQUAL(cells.count(), 2);
  // What stands out is held by the outermost cells.
  const CellRange all = frame.overlappedBy(boxOf({-9, -9, -9}, {99, 99, 99}));
  CHECK(all.first == (GridSize{0, 0, 0}) && all.last == (GridSize{7, 7, 7}));
}

TEST("a flat box gets cells with some thickness, and a point some size") {
  const GridFrame flat(boxOf({-4, 3, -4}, {4, 3, 4}), {2, 2, 2});
  // Sides thinner than 2^-10 of the longest, 8, are widened to that, evenly.
  CHECK_EQUAL(flat.plane(1, 2) - flat.plane(1, 0), 0x1p-7);
  CHECK_EQUAL(flat.plane(1, 1), 3);
  const GridFrame point(boxOf({0, 0, 0}, {0, 0, 0}), {1, 1, 1});
  CHECK(point.plane(0, 1) > point.plane(0, 0));
}
