// WorldShape: distances for balls, separating axes for triangles.
//
// A ball meets a cell whose nearest point is nearer than the radius, and surrounds one whose
// farthest point is. A triangle and a cell are apart exactly if they are so seen along one of 13
// axes: the cell's three, along which their boxes are known to overlap; the triangle's normal; and
// the nine cross products of an edge with a side of the cell. Along each axis the triangle's three
// corners are compared with half the cell's extent.
#include "accel/grid/world_shape.h"

#include <algorithm>
#include <cmath>

namespace accel {
namespace {

constexpr double kTiny = 1e-9;

/// How much a map stretches all directions; 0 where it stretches them differently.
double similarityOf(const Matrix& matrix) {
  const Vec3d columns[3] = {matrix.transformDirection({1, 0, 0}),
                            matrix.transformDirection({0, 1, 0}),
                            matrix.transformDirection({0, 0, 1})};
  const double squared = dot(columns[0], columns[0]);
  for (int i = 0; i < 3; ++i) {
    const Vec3d& next = columns[(i + 1) % 3];
    const bool isEqual = std::fabs(dot(next, next) - squared) <= 1e-12 * squared;
    if (!isEqual || std::fabs(dot(columns[i], next)) > 1e-12 * squared) return 0;
  }
  return std::sqrt(squared);
}

/// True for the zero vector and where all components but one vanish beside that one.
bool isCellAxis(const Vec3d& axis) {
  int large = 0;
  for (int i = 0; i < 3; ++i) large += std::fabs(axis[i]) > kTiny * maxAbs(axis);
  return large <= 1;
}

}  // namespace

WorldShape WorldShape::ball(const Matrix& toWorld, const Vec3d& center, double radius) {
  const double stretch = similarityOf(toWorld);
  if (!(radius * stretch > 0)) return {};
  return {Kind::ball, {toWorld.transformPoint(center), {}, {}}, radius * stretch};
}

WorldShape WorldShape::triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return {Kind::triangle, {a, b, c}, 0};
}

bool WorldShape::meets(const BoundingBox& cell) const {
  if (kind_ == Kind::box) return true;
  if (kind_ == Kind::ball) {
    Vec3d apart;
    for (int axis = 0; axis < 3; ++axis) {
      const double c = points_[0][axis];
      apart[axis] = c - std::clamp(c, cell.low()[axis], cell.high()[axis]);
    }
    return dot(apart, apart) < radius_ * radius_;
  }
  const Vec3d &a = points_[0], &b = points_[1], &c = points_[2];
  if (isSeparated(cross(b - a, c - b), cell)) return false;
  for (const Vec3d& side : {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}) {
    for (const Vec3d& edge : {b - a, c - b, a - c}) {
      if (isSeparated(cross(side, edge), cell)) return false;
    }
  }
  return true;
}

/// Whether triangle and cell, seen along `axis`, are beside each other. Along the cell's own axes
/// they are not, since their boxes overlap.
bool WorldShape::isSeparated(const Vec3d& axis, const BoundingBox& cell) const {
  if (isCellAxis(axis)) return false;
  const Vec3d middle = (cell.low() + cell.high()) * 0.5, half = (cell.high() - cell.low()) * 0.5;
  const double reach =
      (1 - kTiny) * (std::fabs(axis.x()) * half.x() + std::fabs(axis.y()) * half.y() +
                     std::fabs(axis.z()) * half.z());
  const double a = dot(axis, points_[0] - middle), b = dot(axis, points_[1] - middle),
               c = dot(axis, points_[2] - middle);
  return std::min({a, b, c}) >= reach || std::max({a, b, c}) <= -reach;
}

bool WorldShape::surrounds(const BoundingBox& cell) const {
  if (kind_ != Kind::ball) return false;
  Vec3d farthest;
  for (int axis = 0; axis < 3; ++axis) {
    const double c = points_[0][axis];
    farthest[axis] = std::max(std::fabs(cell.low()[axis] - c), std::fabs(cell.high()[axis] - c));
  }
  return dot(farthest, farthest) < radius_ * radius_;
}

}  // namespace accel
