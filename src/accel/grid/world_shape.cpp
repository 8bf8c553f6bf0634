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
#include <utility>

namespace accel {
namespace {

constexpr double kTiny = 1e-9;

/// How much a map stretches all directions; 0 where it stretches them differently.
double similarityOf(const Matrix& matrix) {
  const Vec3d sides[3] = {matrix.transformDirection({1, 0, 0}),
                          matrix.transformDirection({0, 1, 0}),
                          matrix.transformDirection({0, 0, 1})};
  const double squared = dot(sides[0], sides[0]);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      const double wanted = i == j ? squared : 0;
      if (!(std::fabs(dot(sides[i], sides[j]) - wanted) <= 1e-12 * squared)) return 0;
    }
  }
  return std::sqrt(squared);
}

/// The squares of the distances from a point to the nearest and to the farthest point of a cell.
std::pair<double, double> squaredDistances(const Vec3d& point, const BoundingBox& cell) {
  Vec3d nearest, farthest;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = cell.low()[axis] - point[axis], high = cell.high()[axis] - point[axis];
    nearest[axis] = std::max({0.0, low, -high});
    farthest[axis] = std::max(std::fabs(low), std::fabs(high));
  }
  return {dot(nearest, nearest), dot(farthest, farthest)};
}

}  // namespace

WorldShape WorldShape::ball(const Matrix& toWorld, const Vec3d& center, double radius) {
  WorldShape shape;
  shape.radius_ = radius * similarityOf(toWorld);
  if (shape.radius_ > 0) shape.kind_ = Kind::ball;
  shape.points_[0] = toWorld.transformPoint(center);
  return shape;
}

WorldShape WorldShape::triangle(const Matrix& toWorld, const std::array<Vec3d, 3>& corners) {
  WorldShape shape;
  shape.kind_ = Kind::triangle;
  for (std::size_t i = 0; i < 3; ++i) shape.points_[i] = toWorld.transformPoint(corners[i]);
  return shape;
}

bool WorldShape::meets(const BoundingBox& cell) const {
  if (kind_ == Kind::box) return true;
  if (kind_ == Kind::ball) return squaredDistances(points_[0], cell).first < radius_ * radius_;
  const Vec3d &a = points_[0], &b = points_[1], &c = points_[2];
  if (isSeparated(cross(b - a, c - b), cell)) return false;
  for (const Vec3d& side : {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}) {
    for (const Vec3d& edge : {b - a, c - b, a - c}) {
      if (isSeparated(cross(side, edge), cell)) return false;
    }
  }
  return true;
}

bool WorldShape::surrounds(const BoundingBox& cell) const {
  return kind_ == Kind::ball && squaredDistances(points_[0], cell).second < radius_ * radius_;
}

/// Whether triangle and cell, seen along `axis`, are beside each other. Along the cell's own axes
/// they are not, since their boxes overlap; nor is anything along the zero vector.
bool WorldShape::isSeparated(const Vec3d& axis, const BoundingBox& cell) const {
  int components = 0;  // beside which others do not vanish
  for (int i = 0; i < 3; ++i) components += std::fabs(axis[i]) > kTiny * maxAbs(axis);
  if (components <= 1) return false;
  const Vec3d middle = (cell.low() + cell.high()) * 0.5, half = (cell.high() - cell.low()) * 0.5;
  const double reach =
      (1 - kTiny) * (std::fabs(axis.x()) * half.x() + std::fabs(axis.y()) * half.y() +
                     std::fabs(axis.z()) * half.z());
  const double a = dot(axis, points_[0] - middle), b = dot(axis, points_[1] - middle),
               c = dot(axis, points_[2] - middle);
  return std::min({a, b, c}) >= reach || std::max({a, b, c}) <= -reach;
}

}  // namespace accel
