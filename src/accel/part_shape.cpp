// PartShape: distances for balls, separating axes for triangles.
#include "accel/part_shape.h"

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

PartShape PartShape::ball(const Matrix& toWorld, const Vec3d& center, double radius) {
  PartShape shape;
  shape.radius_ = radius * similarityOf(toWorld);
  shape.points_[0] = toWorld.transformPoint(center);
  if (shape.radius_ > 0) shape.kind_ = Kind::ball;
  return shape;
}

PartShape PartShape::triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  PartShape shape;
  shape.kind_ = Kind::triangle;
  shape.points_[0] = a;
  shape.points_[1] = b;
  shape.points_[2] = c;
  return shape;
}

bool PartShape::meets(const BoundingBox& cell) const {
  if (kind_ == Kind::box) return true;
  if (kind_ == Kind::ball) {
    Vec3d apart;
    for (int axis = 0; axis < 3; ++axis) {
      const double c = points_[0][axis];
      apart[axis] = c - std::clamp(c, cell.low()[axis], cell.high()[axis]);
    }
    return dot(apart, apart) < radius_ * radius_;
  }
  const Vec3d edges[3] = {points_[1] - points_[0], points_[2] - points_[1],
                          points_[0] - points_[2]};
  if (isSeparated(cross(edges[0], edges[1]), cell)) return false;
  for (const Vec3d& edge : edges) {
    if (isSeparated({0, -edge.z(), edge.y()}, cell) ||
        isSeparated({edge.z(), 0, -edge.x()}, cell) ||
        isSeparated({-edge.y(), edge.x(), 0}, cell)) {
      return false;
    }
  }
  return true;
}

/// Whether triangle and cell, seen along `axis`, are beside each other. Along the cell's own axes
/// they are not, since their boxes overlap.
bool PartShape::isSeparated(const Vec3d& axis, const BoundingBox& cell) const {
  if (isCellAxis(axis)) return false;
  const Vec3d middle = (cell.low() + cell.high()) * 0.5, half = (cell.high() - cell.low()) * 0.5;
  const double reach =
      (1 - kTiny) * (std::fabs(axis.x()) * half.x() + std::fabs(axis.y()) * half.y() +
                     std::fabs(axis.z()) * half.z());
  const double a = dot(axis, points_[0] - middle), b = dot(axis, points_[1] - middle),
               c = dot(axis, points_[2] - middle);
  return std::min({a, b, c}) >= reach || std::max({a, b, c}) <= -reach;
}

bool PartShape::surrounds(const BoundingBox& cell) const {
  if (kind_ != Kind::ball) return false;
  Vec3d farthest;
  for (int axis = 0; axis < 3; ++axis) {
    const double c = points_[0][axis];
    farthest[axis] = std::max(std::fabs(cell.low()[axis] - c), std::fabs(cell.high()[axis] - c));
  }
  return dot(farthest, farthest) < radius_ * radius_;
}

}  // namespace accel
