// The occupied cells of a grid as boxes to look at.
#include "accel/grid/grid_view.h"

#include "check.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "random_scene.h"
#include "vectors.h"

using accel_test::Owner;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Two balls of radius 0.5 in opposite corners of the cube from (-1, -1, -1) to (1, 1, 1), whose
/// grid has cells of side 0.5: each ball has a part in the eight cells around its centre, and in no
/// other.
struct TwoBalls {
  Owner owner;
  Group group;
  std::vector<const Material*> palette;

  TwoBalls() {
    for (const double at : {-0.5, 0.5}) {
      group.addObject(&owner.make<Sphere>(Vec3d(at, at, at), 0.5, owner.material(0)));
    }
    for (int i = 0; i < 3; ++i) palette.push_back(owner.material(i));
  }
  GridView view() const { return GridView(countReached(group, {4, 4, 4}), palette); }
};

void checkHit(const GridView& view, const Ray& ray, double tmin, double t, const Vec3d& normal) {
  Hit hit;
  CHECK(view.intersect(ray, hit, tmin));
  CHECK_EQUAL(hit.getT(), t);
  CHECK(hit.getNormal() == normal);
}

}  // namespace

TEST("the side by which a ray enters the first occupied cell is seen, with its normal") {
  const TwoBalls scene;
  const GridView view = scene.view();
  checkHit(view, Ray({5, 0.6, 0.6}, {-1, 0, 0}), 0, 4, {1, 0, 0});
  checkHit(view, Ray({-0.3, -5, -0.3}, {0, 2, 0}), 0, 2, {0, -1, 0});
  checkHit(view, Ray({0.6, 0.6, 5}, {0, 0, -1}), 0, 4, {0, 0, 1});
  // Through free cells of the grid to the second ball: from z = 1 down to z = 0.
  checkHit(view, Ray({-0.3, -0.3, 5}, {0, 0, -1}), 0, 5, {0, 0, 1});
  // The corner between the balls is free.
  Hit hit;
  CHECK(!view.intersect(Ray({0.6, -0.6, 5}, {0, 0, -1}), hit, 0));
}

TEST("with tmin = -infinity the first cell is found wherever the ray begins") {
  const TwoBalls scene;
  checkHit(scene.view(), Ray({0.6, 0.6, -7}, {0, 0, -1}), -kInf, -8, {0, 0, 1});
}

TEST("a ray that starts inside an occupied cell sees the side by which it leaves") {
  // From (0.6, 0.6, 0.6) up: the cell ends at z = 1.
  const TwoBalls scene;
  const GridView view = scene.view();
  checkHit(view, Ray({0.6, 0.6, 0.6}, {0, 0, 1}), 0, 1 - 0.6, {0, 0, 1});
  // From a free cell inside the grid: (0.6, 0.6, -0.6) up to z = 0.
  checkHit(view, Ray({0.6, 0.6, -0.6}, {0, 0, 1}), 0, 0.6, {0, 0, -1});
}

TEST("a ray that leaves a cell does not meet it again") {
  const TwoBalls scene;
  const GridView view = scene.view();
  Hit hit;
  CHECK(view.intersect(Ray({5, 0.6, 0.6}, {-1, 0, 0}), hit, 0));
  Ray away({0.99, 0.6, 0.6}, {1, 0, 0});  // as if rounding had put the point inside
  away.setSource(hit.getObject(), hit.getFace());
  Hit next;
  CHECK(!view.intersect(away, next, 0));
}

TEST("only what is nearer than the hit so far is found") {
  const TwoBalls scene;
  Hit near(4);
  CHECK(!scene.view().intersect(Ray({5, 0.6, 0.6}, {-1, 0, 0}), near, 0));
  CHECK(near.getMaterial() == nullptr);
}

TEST("a cell counts the objects that have a part in it, and its colour follows") {
  Owner owner;
  Group group;
  group.addObject(&owner.make<Plane>(Vec3d(0, 1, 0), -1.0, owner.material(0)));  // has no place
  Random random(5);
  std::vector<Sphere> spheres;
  for (int i = 0; i < 60; ++i) {
    const Vec3d center = random.inCube(-3, 3);
    spheres.emplace_back(center, random.uniform(0.05, 1), owner.material(0));
  }
  for (const Sphere& sphere : spheres) group.addObject(&sphere);
  const CellCounts cells = countReached(group, {7, 9, 5});
  const GridFrame& frame = cells.frame;
  int most = 0, free = 0;
  GridSize at;
  for (at[0] = 0; at[0] < 7; ++at[0]) {
    for (at[1] = 0; at[1] < 9; ++at[1]) {
      for (at[2] = 0; at[2] < 5; ++at[2]) {
        int expected = 0;
        for (const Sphere& sphere : spheres) {
          // The square of the distance from the centre to the nearest point of the cell.
          double squared = 0;
          for (int axis = 0; axis < 3; ++axis) {
            const double c = sphere.getCenter()[axis];
            const double below = frame.plane(axis, at[axis]) - c;
            const double above = c - frame.plane(axis, at[axis] + 1);
            const double apart = std::max({0.0, below, above});
            squared += apart * apart;
          }
          const bool inside = squared < sphere.getRadius() * sphere.getRadius();
          expected += inside;
        }
        CHECK_EQUAL(int(cells.at(at)), expected);
        most = std::max(most, expected);
        free += expected == 0;
      }
    }
  }
  CHECK(most > 3 && free > 3);
}

TEST("a face counts in the cells that it has a part in, and a squashed ball with its whole box") {
  // A square in the plane of sides of cells, of two triangles that meet along the diagonal: both
  // are in the cells on the diagonal, and one is in each of the others.
  Owner owner;
  const Vec3d a(-2, -2, 0), b(2, -2, 0), c(2, 2, 0), d(-2, 2, 0);
  Group square;
  square.addObject(&owner.make<Triangle>(a, b, c, owner.material(0)));
  square.addObject(&owner.make<Triangle>(a, c, d, owner.material(0)));
  square.addObject(&owner.make<Sphere>(Vec3d(0, 0, -1.5), 0.5, owner.material(0)));
  const CellCounts cells = countReached(square, {4, 4, 2});
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      CHECK_EQUAL(cells.at({i, j, 1}), i == j ? 2u : 1u);
      const bool isMiddle = (i == 1 || i == 2) && (j == 1 || j == 2);
      CHECK_EQUAL(cells.at({i, j, 0}), isMiddle ? 1u : 0u);
    }
  }
  // The corners of a round ball's box are free, those of an egg's are not.
  const auto& ball = owner.make<Sphere>(Vec3d(0, 0, 0), 1.0, owner.material(0));
  for (const double height : {1.0, 1.5}) {
    Group moved;
    moved.addObject(&owner.make<Transform>(
        Matrix::translation({3, 4, 5}) * Matrix::scale({-1, 1, height}), &ball));
    const CellCounts inMoved = countReached(moved, {8, 8, 8});
    CHECK_EQUAL(inMoved.at({0, 0, 7}), height == 1 ? 0u : 1u);
    CHECK_EQUAL(inMoved.at({3, 3, 7}), 1u);
  }
}

TEST("where tests of cells would take too long, boxes count") {
  Owner owner;
  Group group;
  group.addObject(&owner.make<Sphere>(Vec3d(), 1.0, owner.material(0)));
  CHECK_EQUAL(countReached(group, {8, 8, 8}, 512).at({0, 0, 0}), 0u);
  CHECK_EQUAL(countReached(group, {8, 8, 8}, 511).at({0, 0, 0}), 1u);
}

TEST("cells of many objects share the last colour") {
  Owner owner;
  Group group;
  for (int i = 0; i < 5; ++i) {
    group.addObject(&owner.make<Sphere>(Vec3d(), 1.0, owner.material(3)));
  }
  for (int colors = 1; colors <= 4; ++colors) {
    std::vector<const Material*> palette;
    for (int i = 0; i < colors; ++i) palette.push_back(owner.material(i));
    Hit hit;
    const GridView view(countReached(group, {1, 1, 1}), palette);
    CHECK(view.intersect(Ray({0, 0, 5}, {0, 0, -1}), hit, 0));
    CHECK(hit.getMaterial() == palette.back());
  }
}

TEST("nothing is seen of a scene without bounded objects") {
  Owner owner;
  Group group;
  group.addObject(&owner.make<Plane>(Vec3d(0, 1, 0), -1.0, owner.material(0)));
  const GridView view(countReached(group, {3, 3, 3}), {owner.material(0)});
  Hit hit;
  CHECK_EQUAL(view.cells().frame.cellCount(), 0u);
  CHECK_EQUAL(countTouched(group, {3, 3, 3}).frame.cellCount(), 0u);
  CHECK(!view.intersect(Ray({0, 5, 0}, {0, -1, 0}), hit, 0));
}

TEST("a plain sphere touches the cells whose centres are within its radius and half a diagonal") {
  // Cells of side 1 from -4 to 4: half a diagonal is 0.866. The sphere of radius 1 in a corner of
  // cells reaches centres up to 1.866 away: (0.5, 0.5, 0.5) is 0.866 away, (1.5, 0.5, 0.5) 1.658,
  // (1.5, 1.5, 0.5) 2.179. So 8 cells around it and 24 beside these.
  Owner owner;
  Group group;
  group.addObject(&owner.make<Sphere>(Vec3d(0, 0, 0), 1.0, owner.material(0)));
  for (const double at : {-3.5, 3.5}) {  // they make the box of the grid
    group.addObject(&owner.make<Sphere>(Vec3d(at, at, at), 0.5, owner.material(0)));
  }
  const CellCounts cells = countTouched(group, {8, 8, 8});
  int count = 0;
  for (int x = 2; x < 6; ++x) {
    for (int y = 2; y < 6; ++y) {
      for (int z = 2; z < 6; ++z) count += int(cells.at({x, y, z}));
    }
  }
  CHECK_EQUAL(count, 32);
  CHECK_EQUAL(cells.at({2, 3, 4}), 1u);
  CHECK_EQUAL(cells.at({2, 2, 4}), 0u);
}

TEST("a sphere under a Transform and a turned triangle touch all cells that their boxes touch") {
  Owner owner;
  const auto& ball = owner.make<Sphere>(Vec3d(), 1.0, owner.material(0));
  // Turned by 45 degrees about z, the cube around the ball has corners at sqrt(2) along x and y.
  const Matrix turn = Matrix::rotation({0, 0, 1}, 45);
  Group turned;
  turned.addObject(&owner.make<Transform>(turn, &ball));
  const CellCounts cells = countTouched(turned, {4, 4, 2});
  CHECK_NEAR(cells.frame.plane(0, 0), -std::sqrt(2.0), 1e-12);
  CHECK_NEAR(cells.frame.plane(1, 4), std::sqrt(2.0), 1e-12);
  CHECK_NEAR(cells.frame.plane(2, 2), 1, 1e-12);
  CHECK_EQUAL(cells.at({0, 0, 0}), 1u);  // a corner, where nothing of the ball is
  // The triangle (0, 0), (2, 0), (0, 2), turned: (0, 0), (1.41, 1.41), (-1.41, 1.41). In a grid of
  // cells of side 1 from -4 to 4 its box touches the columns 2 to 5 of x, and of y 4 and 5; y = 0
  // and z = 0 are sides of cells: row 3 and the layers 3 and 4 are touched too.
  const auto& triangle =
      owner.make<Triangle>(Vec3d(0, 0, 0), Vec3d(2, 0, 0), Vec3d(0, 2, 0), owner.material(0));
  Group far;
  far.addObject(&owner.make<Transform>(turn, &triangle));
  for (const double at : {-3.5, 3.5}) {  // they make the box of the grid
    far.addObject(&owner.make<Sphere>(Vec3d(at, at, at), 0.5, owner.material(0)));
  }
  const CellCounts around = countTouched(far, {8, 8, 8});
  for (int x = 2; x < 6; ++x) {
    for (int y = 2; y < 6; ++y) {
      for (int z = 2; z < 6; ++z) {
        const bool isTouched = y >= 3 && (z == 3 || z == 4);
        CHECK_EQUAL(around.at({x, y, z}), isTouched ? 1u : 0u);
      }
    }
  }
}
