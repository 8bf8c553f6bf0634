// Vec3: arithmetic by component, products, lengths and the two ways of conversion.
#include "math/vec3.h"

#include <type_traits>

#include "random.h"
#include "vectors.h"

TEST("a vector starts as zero and gives its components under every name") {
  CHECK_EQUAL(Vec3d(), Vec3d(0, 0, 0));
  const Vec3f v(1, 2, 3);
  CHECK_EQUAL(v.x(), 1.0f);
  CHECK_EQUAL(v.y(), 2.0f);
  CHECK_EQUAL(v.z(), 3.0f);
  CHECK_EQUAL(v.r(), 1.0f);
  CHECK_EQUAL(v.g(), 2.0f);
  CHECK_EQUAL(v.b(), 3.0f);
  for (int axis = 0; axis < 3; ++axis) CHECK_EQUAL(v[axis], float(axis + 1));
}

TEST("vectors add, subtract and multiply by component") {
  const Vec3d a(1, 2, 3), b(10, -20, 40);
  CHECK_EQUAL(a + b, Vec3d(11, -18, 43));
  CHECK_EQUAL(a - b, Vec3d(-9, 22, -37));
  CHECK_EQUAL(-a, Vec3d(-1, -2, -3));
  CHECK_EQUAL(a * b, Vec3d(10, -40, 120));
  CHECK_EQUAL(a * 2.0, Vec3d(2, 4, 6));
  CHECK_EQUAL(2.0 * a, Vec3d(2, 4, 6));
  CHECK_EQUAL(b / 10.0, Vec3d(1, -2, 4));
}

TEST("assigning operators change the vector itself") {
  Vec3d a(1, 2, 3);
  a += Vec3d(1, 1, 1);
  CHECK_EQUAL(a, Vec3d(2, 3, 4));
  a -= Vec3d(0, 1, 2);
  CHECK_EQUAL(a, Vec3d(2, 2, 2));
  a *= Vec3d(1, 2, 3);
  CHECK_EQUAL(a, Vec3d(2, 4, 6));
  a *= 0.5;
  CHECK_EQUAL(a, Vec3d(1, 2, 3));
  a[1] = 7;
  CHECK_EQUAL(a, Vec3d(1, 7, 3));
}

TEST("vectors that differ in any one component are not equal") {
  const Vec3d a(1, 2, 3);
  CHECK(a == Vec3d(1, 2, 3));
  CHECK(a != Vec3d(0, 2, 3));
  CHECK(a != Vec3d(1, 0, 3));
  CHECK(a != Vec3d(1, 2, 0));
}

TEST("the scalar product is the sum of products") {
  CHECK_EQUAL(dot(Vec3d(1, 2, 3), Vec3d(4, -5, 6)), 12.0);  // 4 - 10 + 18
}

TEST("the cross product is right-handed") {
  const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  CHECK_EQUAL(cross(x, y), z);
  CHECK_EQUAL(cross(y, z), x);
  CHECK_EQUAL(cross(z, x), y);
  // (2x6 - 3x5, 3x4 - 1x6, 1x5 - 2x4)
  CHECK_EQUAL(cross(Vec3d(1, 2, 3), Vec3d(4, 5, 6)), Vec3d(-3, 6, -3));
}

TEST("exchanging the factors of a cross product changes the sign exactly") {
  Random random(11);
  check::Cases cases;
  for (int i = 0; i < 20000; ++i) {
    const double sizeA = random.logUniform(1e-9, 1e9), sizeB = random.logUniform(1e-9, 1e9);
    const Vec3d a = random.inCube(-1, 1) * sizeA, b = random.inCube(-1, 1) * sizeB;
    cases.expect(cross(a, b) == -cross(b, a),
                 [&] { return check::show(a) + " x " + check::show(b); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("length and normalize follow Pythagoras") {
  CHECK_EQUAL(length(Vec3d(2, -3, 6)), 7.0);  // 4 + 9 + 36 = 49
  CHECK_EQUAL(length(Vec3d()), 0.0);
  CHECK_NEAR_VECTOR(normalize(Vec3d(2, -3, 6)), Vec3d(2.0 / 7, -3.0 / 7, 6.0 / 7), 1e-16);
  CHECK_EQUAL(normalize(Vec3f(0, 0, -5)), Vec3f(0, 0, -1));
  CHECK(std::isnan(normalize(Vec3d()).x()));
}

TEST("the largest absolute component counts negatives") {
  CHECK_EQUAL(maxAbs(Vec3d(1, -7, 3)), 7.0);
  CHECK_EQUAL(maxAbs(Vec3d(8, -7, 3)), 8.0);
  CHECK_EQUAL(maxAbs(Vec3d(0, 0, -1e-300)), 1e-300);
  CHECK_EQUAL(maxAbs(Vec3d()), 0.0);
}

TEST("the smaller and the larger of two vectors are taken component by component") {
  CHECK_EQUAL(least(Vec3d(1, -7, 3), Vec3d(0, 2, 3)), Vec3d(0, -7, 3));
  CHECK_EQUAL(largest(Vec3d(1, -7, 3), Vec3d(0, 2, 3)), Vec3d(1, 2, 3));
  // What a box has grown to is not lost by a point that is no number.
  const Vec3d none(std::nan(""), std::nan(""), std::nan(""));
  CHECK_EQUAL(least(Vec3d(1, 2, 3), none), Vec3d(1, 2, 3));
  CHECK_EQUAL(largest(Vec3d(1, 2, 3), none), Vec3d(1, 2, 3));
}

TEST("a colour is positive where any component is above zero") {
  CHECK(anyPositive(Vec3f(0.1f, 0, 0)));
  CHECK(anyPositive(Vec3f(0, 0.1f, 0)));
  CHECK(anyPositive(Vec3f(0, 0, 0.1f)));
  CHECK(anyPositive(Vec3f(-1, 0.1f, 0)));
  CHECK(!anyPositive(Vec3f(0, 0, 0)));
  CHECK(!anyPositive(Vec3f(-1, 0, 0)));
}

TEST("widening is implicit and exact, narrowing must be asked for and rounds to nearest") {
  static_assert(std::is_convertible_v<Vec3f, Vec3d>);
  static_assert(!std::is_convertible_v<Vec3d, Vec3f>);
  static_assert(std::is_constructible_v<Vec3f, Vec3d>);
  const Vec3d wide = Vec3f(0.1f, 0.2f, 0.3f);
  CHECK_EQUAL(wide, Vec3d(double(0.1f), double(0.2f), double(0.3f)));
  // Floats near 1 are 2^-23 apart: 1 + 0.75 x 2^-23 lies nearer to 1 + 2^-23.
  CHECK_EQUAL(Vec3f(Vec3d(1 + 0.75 * 0x1p-23, 1 + 0.25 * 0x1p-23, -0.1)),
              Vec3f(1 + 0x1p-23f, 1, -0.1f));
}

TEST("a point on the image plane keeps its two components and widens exactly") {
  const Vec2d p = Vec2f(0.1f, -0.25f);
  CHECK_EQUAL(p.x(), double(0.1f));
  CHECK_EQUAL(p.y(), -0.25);
  CHECK_EQUAL(Vec2d().x(), 0.0);
  CHECK_EQUAL(Vec2d().y(), 0.0);
}

TEST("the longest axis has the largest component by size, the first of equal ones") {
  CHECK_EQUAL(longestAxis(Vec3d(1, -2, 1.5)), 1);
  CHECK_EQUAL(longestAxis(Vec3d(-3, 2, 2.5)), 0);
  CHECK_EQUAL(longestAxis(Vec3d(0, 1, -4)), 2);
  CHECK_EQUAL(longestAxis(Vec3d(2, -2, 2)), 0);
  CHECK_EQUAL(longestAxis(Vec3d(1, -2, 2)), 1);
}

TEST("what is nearest within 0 to 1: the number itself, an end, and 0 for NaN") {
  CHECK_EQUAL(withinUnit(0.25), 0.25);
  CHECK_EQUAL(withinUnit(-3), 0.0);
  CHECK_EQUAL(withinUnit(1e300), 1.0);
  CHECK_EQUAL(withinUnit(std::nan("")), 0.0);
}
