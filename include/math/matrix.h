// Matrix: an affine map of space, three rows of four; the fourth row is always 0 0 0 1.
// Column vectors: (A * B) applies B first, and the translation is the last column.
#pragma once
#include "math/vec3.h"

class Matrix {
  /// Not for float: what is stored in single precision is moved in double, and so converted first.
  template <class Number>
  using Moved = std::enable_if_t<!std::is_same_v<Number, float>, Vec3<Number>>;

 public:
  /// The identity.
  Matrix() : m_{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}} {}
  /// From rows of three linear factors and one translation each.
  explicit Matrix(const double (&rows)[3][4]);

  /// Moves points by `offset`; directions stay.
  static Matrix translation(const Vec3d& offset);
  /// Multiplies each coordinate by its factor. A negative one mirrors; with a factor of 0 the map
  /// is flat: it has no inverse.
  static Matrix scale(const Vec3d& factors);
  /// Rotation by `degrees` about `axis`, counter-clockwise for one who looks against it. The axis
  /// need not be a unit vector but must not be zero. Source: Goldman, "Matrices and
  /// Transformations", Graphics Gems, 1990.
  static Matrix rotation(const Vec3d& axis, double degrees);

  /// The map that applies b first, then a. Each element is a sum in a fixed order.
  friend Matrix operator*(const Matrix& a, const Matrix& b);

  /// Element in row 0..2, column 0..3.
  double at(int row, int column) const { return m_[row][column]; }

  template <class Number = double>
  Moved<Number> transformPoint(const Vec3<Number>& p) const {
    return {m_[0][0] * p.x() + m_[0][1] * p.y() + m_[0][2] * p.z() + m_[0][3],
            m_[1][0] * p.x() + m_[1][1] * p.y() + m_[1][2] * p.z() + m_[1][3],
            m_[2][0] * p.x() + m_[2][1] * p.y() + m_[2][2] * p.z() + m_[2][3]};
  }
  /// The translation does not move a direction; its length is not kept.
  template <class Number = double>
  Moved<Number> transformDirection(const Vec3<Number>& d) const {
    return {m_[0][0] * d.x() + m_[0][1] * d.y() + m_[0][2] * d.z(),
            m_[1][0] * d.x() + m_[1][1] * d.y() + m_[1][2] * d.z(),
            m_[2][0] * d.x() + m_[2][1] * d.y() + m_[2][2] * d.z()};
  }
  /// Multiplies by the transpose of the linear part. Called on the inverse of a map it takes
  /// normals along with that map; the result is not a unit vector.
  template <class Number = double>
  Moved<Number> transposeTransformDirection(const Vec3<Number>& n) const {
    return {m_[0][0] * n.x() + m_[1][0] * n.y() + m_[2][0] * n.z(),
            m_[0][1] * n.x() + m_[1][1] * n.y() + m_[2][1] * n.z(),
            m_[0][2] * n.x() + m_[1][2] * n.y() + m_[2][2] * n.z()};
  }

  /// Stores the inverse in `result` and returns true; returns false, and leaves `result` as it
  /// was, where the map is singular or its inverse is not finite.
  bool inverse(Matrix& result) const;

  /// The largest sum of absolute terms of any row at point p: what the rounding error of
  /// transformPoint(p) is proportional to.
  template <class Number = double>
  Number magnitudeAt(const Vec3<Number>& p) const {
    Number most = 0;
    for (const auto& row : m_) {
      const Number sum = absolute(row[0] * p.x()) + absolute(row[1] * p.y()) +
                         absolute(row[2] * p.z()) + (row[3] < 0 ? -row[3] : row[3]);
      most = larger(most, sum);
    }
    return most;
  }

 private:
  double m_[3][4];
};
