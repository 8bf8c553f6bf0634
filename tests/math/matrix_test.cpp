// Matrix: points, directions, normals, products, rotations and inverses.
#include "math/matrix.h"

#include <limits>

#include "random.h"
#include "vectors.h"

namespace {

Matrix sample() { return Matrix({{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 12, 14}}); }

bool isSame(const Matrix& a, const Matrix& b) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      if (a.at(row, column) != b.at(row, column)) return false;
  return true;
}

double largestDifference(const Matrix& a, const Matrix& b) {
  double worst = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      worst = std::max(worst, std::fabs(a.at(row, column) - b.at(row, column)));
  return worst;
}

}  // namespace

TEST("a new matrix is the identity") {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      CHECK_EQUAL(Matrix().at(row, column), row == column ? 1.0 : 0.0);
  CHECK_EQUAL(Matrix().transformPoint({1, 2, 3}), Vec3d(1, 2, 3));
}

TEST("points take the translation along, directions do not") {
  // 1 + 2x10 + 3x100 = 321, 5 + 60 + 700 = 765, 9 + 100 + 1200 = 1309
  CHECK_EQUAL(sample().transformDirection({1, 10, 100}), Vec3d(321, 765, 1309));
  CHECK_EQUAL(sample().transformPoint({1, 10, 100}), Vec3d(325, 773, 1323));
}

TEST("the transposed product goes down the columns") {
  // 1 + 5x10 + 9x100 = 951, 2 + 60 + 1000 = 1062, 3 + 70 + 1200 = 1273
  CHECK_EQUAL(sample().transposeTransformDirection({1, 10, 100}), Vec3d(951, 1062, 1273));
}

TEST("translation and scale do what they say") {
  CHECK_EQUAL(Matrix::translation({1, 2, 3}).transformPoint({10, 20, 30}), Vec3d(11, 22, 33));
  CHECK_EQUAL(Matrix::translation({1, 2, 3}).transformDirection({10, 20, 30}), Vec3d(10, 20, 30));
  CHECK_EQUAL(Matrix::scale({2, -3, 4}).transformPoint({10, 20, 30}), Vec3d(20, -60, 120));
}

TEST("a product applies its right factor first") {
  const Matrix move = Matrix::translation({1, 0, 0}), grow = Matrix::scale({2, 2, 2});
  CHECK_EQUAL((move * grow).transformPoint({5, 0, 0}), Vec3d(11, 0, 0));
  CHECK_EQUAL((grow * move).transformPoint({5, 0, 0}), Vec3d(12, 0, 0));
  CHECK(isSame(Matrix() * sample(), sample()));
  CHECK(isSame(sample() * Matrix(), sample()));
}

TEST("quarter turns are exact and counter-clockwise for one who looks against the axis") {
  CHECK_EQUAL(Matrix::rotation({0, 0, 1}, 90).transformPoint({1, 0, 0}), Vec3d(0, 1, 0));
  CHECK_EQUAL(Matrix::rotation({1, 0, 0}, 90).transformPoint({0, 1, 0}), Vec3d(0, 0, 1));
  CHECK_EQUAL(Matrix::rotation({0, 1, 0}, 90).transformPoint({0, 0, 1}), Vec3d(1, 0, 0));
  CHECK_EQUAL(Matrix::rotation({0, 0, 1}, -90).transformPoint({1, 0, 0}), Vec3d(0, -1, 0));
  CHECK_EQUAL(Matrix::rotation({0, 0, 2}, 180).transformPoint({1, 2, 3}), Vec3d(-1, -2, 3));
  CHECK(isSame(Matrix::rotation({0, -3, 0}, 360), Matrix()));
}

TEST("a third of a turn about the space diagonal exchanges the axes") {
  const Matrix turn = Matrix::rotation({1, 1, 1}, 120);
  CHECK_NEAR_VECTOR(turn.transformPoint({1, 0, 0}), Vec3d(0, 1, 0), 1e-15);
  CHECK_NEAR_VECTOR(turn.transformPoint({0, 1, 0}), Vec3d(0, 0, 1), 1e-15);
  CHECK_NEAR_VECTOR(turn.transformPoint({0, 0, 1}), Vec3d(1, 0, 0), 1e-15);
}

TEST("the length of a rotation's axis does not matter") {
  const Matrix unit = Matrix::rotation(normalize(Vec3d(1, -2, 3)), 37);
  CHECK(largestDifference(Matrix::rotation(Vec3d(1, -2, 3) * 1e-6, 37), unit) < 1e-15);
  CHECK(largestDifference(Matrix::rotation(Vec3d(1, -2, 3) * 1e6, 37), unit) < 1e-15);
}

TEST("random rotations keep their axis, lengths and handedness") {
  Random random(21);
  check::Cases cases;
  for (int i = 0; i < 5000; ++i) {
    const Vec3d axis = random.inCube(-5, 5), a = random.unitVector(), b = random.unitVector();
    const double degrees = random.uniform(-720, 720);
    const Matrix turn = Matrix::rotation(axis, degrees);
    const Vec3d turnedA = turn.transformDirection(a), turnedB = turn.transformDirection(b);
    const bool ok = length(turn.transformPoint(axis) - axis) < 1e-14 &&
                    std::fabs(length(turnedA) - 1) < 2e-15 &&
                    length(cross(turnedA, turnedB) - turn.transformDirection(cross(a, b))) < 4e-15;
    cases.expect(ok, [&] { return check::show(axis) + " by " + check::show(degrees); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("the inverse of a known matrix has the known elements") {
  // x' = 2x + 6, y' = z - 1, z' = -4y + 8; so x = x'/2 - 3, y = 2 - z'/4, z = y' + 1.
  const Matrix m({{2, 0, 0, 6}, {0, 0, 1, -1}, {0, -4, 0, 8}});
  Matrix inverse;
  CHECK(m.inverse(inverse));
  CHECK(isSame(inverse, Matrix({{0.5, 0, 0, -3}, {0, 0, -0.25, 2}, {0, 1, 0, 1}})));
}

TEST("random matrices times their inverses are the identity") {
  Random random(22);
  check::Cases cases;
  for (int i = 0; i < 5000; ++i) {
    const Matrix turn = random.rotation(), before = random.rotation();
    const Matrix scale = Matrix::scale(random.inCube(0.1, 10));
    const Matrix m = Matrix::translation(random.inCube(-10, 10)) * turn * scale * before;
    Matrix inverse;
    const bool ok = m.inverse(inverse) && largestDifference(m * inverse, Matrix()) < 1e-12 &&
                    largestDifference(inverse * m, Matrix()) < 1e-12;
    cases.expect(ok, [&] { return "matrix " + std::to_string(i); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("very small and very large maps have inverses") {
  for (double factor : {1e-90, 1e-30, 1e30, 1e90}) {
    Matrix inverse;
    CHECK(Matrix::scale({factor, factor, factor}).inverse(inverse));
    CHECK_NEAR(inverse.at(0, 0) * factor, 1, 1e-15);
    CHECK_NEAR(inverse.at(2, 2) * factor, 1, 1e-15);
  }
}

TEST("a singular matrix has no inverse and leaves the result alone") {
  const Matrix flat = Matrix::scale({1, 0, 1});
  const Matrix dependent({{1, 2, 3, 0}, {2, 4, 6, 0}, {0, 0, 1, 0}});
  for (const Matrix& m : {flat, dependent}) {
    Matrix result = sample();
    CHECK(!m.inverse(result));
    CHECK(isSame(result, sample()));
  }
}

TEST("a map whose inverse is not finite has none") {
  Matrix result = sample();
  CHECK(!Matrix::scale({std::numeric_limits<double>::denorm_min(), 1, 1}).inverse(result));
  CHECK(isSame(result, sample()));
}

TEST("the magnitude at a point is the largest row sum of absolute terms") {
  // Rows at (1, -10, 2): 2 + 30 + 8 + 1 = 41, 0 + 10 + 0 + 50 = 60, 0 + 0 + 14 + 3 = 17.
  const Matrix m({{2, 3, -4, 1}, {0, 1, 0, -50}, {0, 0, 7, 3}});
  CHECK_EQUAL(m.magnitudeAt({1, -10, 2}), 60.0);
}
