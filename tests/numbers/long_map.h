// Affine maps in long double, and those that a Transform's steps stand for.
#pragma once
#include <cmath>

#include "plain_scene.h"

namespace numbers {

using Real = long double;
using Vec = Vec3<Real>;

template <class T>
Vec wide(const Vec3<T>& v) {
  return {Real(v.x()), Real(v.y()), Real(v.z())};
}
inline Real radians(Real degrees) { return degrees * (std::acos(Real(-1)) / 180); }

/// p -> rows . p + shift.
struct Map {
  Vec rows[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vec shift;

  Vec column(int k) const { return {rows[0][k], rows[1][k], rows[2][k]}; }
  Vec direction(const Vec& v) const { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }
  Vec point(const Vec& p) const { return direction(p) + shift; }
  /// The transposed linear part times v.
  Vec transposed(const Vec& v) const { return rows[0] * v.x() + rows[1] * v.y() + rows[2] * v.z(); }

  /// First `inner`, then this one.
  Map after(const Map& inner) const {
    Map map;
    for (int i = 0; i < 3; ++i) map.rows[i] = inner.transposed(rows[i]);
    map.shift = point(inner.shift);
    return map;
  }
  /// By cross products of the columns: the rows of the adjugate, over the determinant.
  Map inverse() const {
    const Vec a = column(0), b = column(1), c = column(2);
    const Real determinant = dot(a, cross(b, c));
    Map map;
    map.rows[0] = cross(b, c) / determinant;
    map.rows[1] = cross(c, a) / determinant;
    map.rows[2] = cross(a, b) / determinant;
    map.shift = -map.direction(shift);
    return map;
  }
};

/// Turns by `degrees` about `axis`, counterclockwise for who looks against it: each unit vector e
/// becomes e cos + (axis x e) sin + axis (axis.e) (1 - cos). Source: O. Rodrigues, 1840.
inline Map rotation(const Vec& axis, Real degrees) {
  const Vec u = normalize(axis);
  const Real c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  Map map;
  for (int k = 0; k < 3; ++k) {
    Vec e;
    e[k] = 1;
    const Vec turned = e * c + cross(u, e) * s + u * (u[k] * (1 - c));
    for (int i = 0; i < 3; ++i) map.rows[i][k] = turned[i];
  }
  return map;
}

inline Map scaling(const Vec& factors) {
  Map map;
  for (int i = 0; i < 3; ++i) map.rows[i] *= factors[i];
  return map;
}

inline Map mapOf(const PlainStep& step) {
  Map map;
  switch (step.kind) {
    case PlainStep::Kind::translate:
      map.shift = wide(step.v);
      return map;
    case PlainStep::Kind::scale:
      return scaling(wide(step.v));
    case PlainStep::Kind::uniformScale:
      return scaling(Vec(step.f, step.f, step.f));
    case PlainStep::Kind::xRotate:
      return rotation({1, 0, 0}, step.f);
    case PlainStep::Kind::yRotate:
      return rotation({0, 1, 0}, step.f);
    case PlainStep::Kind::zRotate:
      return rotation({0, 0, 1}, step.f);
    case PlainStep::Kind::rotate:
      return rotation(wide(step.v), step.f);
    case PlainStep::Kind::matrix:
      break;
  }
  for (int i = 0; i < 3; ++i) {
    const double* row = step.rows + 4 * i;
    map.rows[i] = Vec(row[0], row[1], row[2]);
    map.shift[i] = row[3];
  }
  return map;
}

/// The first step listed is the last one applied.
inline Map mapOf(const std::vector<PlainStep>& steps) {
  Map map;
  for (const PlainStep& step : steps) map = map.after(mapOf(step));
  return map;
}

}  // namespace numbers
