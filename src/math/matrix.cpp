// Matrix: products, rotations and the inverse.
//
// The inverse is taken by Cramer's rule: with columns a, b, c its rows are b x c, c x a and a x b,
// over the determinant a . (b x c). For three by three this is short, and takes the axes alike; a
// determinant of 0 shows in rows that are not finite. The translation o becomes -(row . o).
#include "math/matrix.h"

#include <algorithm>
#include <cmath>

#include "math/functions.h"

Matrix::Matrix(const double (&rows)[3][4]) {
  for (int row = 0; row < 3; ++row) std::copy(rows[row], rows[row] + 4, m_[row]);
}

Matrix Matrix::translation(const Vec3d& offset) {
  return Matrix({{1, 0, 0, offset.x()}, {0, 1, 0, offset.y()}, {0, 0, 1, offset.z()}});
}

Matrix Matrix::scale(const Vec3d& factors) {
  return Matrix({{factors.x(), 0, 0, 0}, {0, factors.y(), 0, 0}, {0, 0, factors.z(), 0}});
}

/// With c, s the angle's cosine and sine and a the unit axis: c I + (1 - c) a a^T + s [a]x, which
/// leaves what lies along the axis and turns what lies across it.
Matrix Matrix::rotation(const Vec3d& axis, double degrees) {
  // Divided first, so that the square of no axis is out of range.
  const Vec3d a = normalize(axis / maxAbs(axis));
  const double c = math::cosDegrees(degrees), s = math::sinDegrees(degrees), t = 1 - c;
  const double x = a.x(), y = a.y(), z = a.z();
  return Matrix({{t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0},
                 {t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0},
                 {t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0}});
}

/// The fourth column starts from that of a: b's translation is moved as a point.
Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      double sum = column == 3 ? a.m_[row][3] : 0;
      for (int k = 0; k < 3; ++k) sum += a.m_[row][k] * b.m_[k][column];
      product.m_[row][column] = sum;
    }
  }
  return product;
}

bool Matrix::inverse(Matrix& result) const {
  // The columns a, b, c and the translation; then b x c, c x a, a x b.
  const Vec3d columns[3] = {{m_[0][0], m_[1][0], m_[2][0]},
                            {m_[0][1], m_[1][1], m_[2][1]},
                            {m_[0][2], m_[1][2], m_[2][2]}};
  const Vec3d offset(m_[0][3], m_[1][3], m_[2][3]);
  const Vec3d cofactors[3] = {cross(columns[1], columns[2]), cross(columns[2], columns[0]),
                              cross(columns[0], columns[1])};
  const double determinant = dot(columns[0], cofactors[0]);
  // Row by row. Of a singular map, or one whose inverse is out of range, a row is not finite.
  Matrix inverted;
  for (int row = 0; row < 3; ++row) {
    const Vec3d linear = cofactors[row] / determinant;
    const double moved = -dot(linear, offset);
    if (!std::isfinite(linear.x() + linear.y() + linear.z() + moved)) return false;
    for (int column = 0; column < 3; ++column) inverted.m_[row][column] = linear[column];
    inverted.m_[row][3] = moved;
  }
  result = inverted;
  return true;
}
