// FlatScene: walks the tree of objects, and bounds what rounding can do to a hit.
//
// The margin, how far beyond its surface a hit may seem to lie, is kSlack of the scene. Half of it
// is for the walk through the cells, and for rays that strike a triangle so flat that t loses
// digits: down to an angle of some 2^-34. The other half is for the errors of the double functions:
//   - in the world 64 roundings of the largest number, where proofs need some 30;
//   - what each Transform above the object adds (TransformError), as much larger as the Transforms
//     around that one stretch.
// An object whose errors are larger than that has no place in a grid, nor has one whose numbers are
// so large or small that their squares and cubes leave the range.
//
// A ball meets a cell whose nearest point is nearer than the radius, and surrounds one whose
// farthest point is. A triangle and a cell are apart exactly if they are so seen along one of 13
// axes: the cell's three, along which their boxes are known to overlap; the triangle's normal; and
// the nine cross products of an edge with a side of the cell. Along each axis the triangle's three
// corners are compared with half the cell's extent.
#include "accel/grid/flat_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "accel/transform_range.h"
#include "geometry/group.h"
#include "geometry/triangle.h"

namespace accel {
namespace {

constexpr double kUnit = 0x1p-47;   // 64 roundings of 2^-53
constexpr double kSlack = 0x1p-14;  // of the scene's longest side
constexpr double kReach = 0x1p10;   // of the scene's longest side
constexpr double kLargest = 0x1p200, kSmallest = 0x1p-200;

/// True where squares and cubes of a box's numbers neither overflow nor underflow; false for an
/// empty box.
bool areCubesInRange(const BoundingBox& box) {
  return box.extent() < kLargest && box.longestSide() > kSmallest;
}

constexpr double kTiny = 1e-9;  // of a part of a vector beside the others
constexpr Vec3d kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// How much a map stretches all directions; 0 where it stretches them differently. The transpose
/// undoes a rotation, and of a map that stretches by s besides it leaves s squared.
double similarityOf(const Matrix& matrix) {
  const Vec3d side = matrix.transformDirection(kAxes[0]);
  const double squared = dot(side, side);
  for (const Vec3d& axis : kAxes) {
    const Vec3d back = matrix.transposeTransformDirection(matrix.transformDirection(axis));
    if (!(maxAbs(back - axis * squared) <= 1e-12 * squared)) return 0;
  }
  return std::sqrt(squared);
}

}  // namespace

WorldShape::WorldShape(const Matrix& toWorld, const Sphere& sphere)
    : points_{toWorld.transformPoint(sphere.getCenter())},
      radius_(sphere.getRadius() * similarityOf(toWorld)) {
  sphere.addBounds(toWorld, box_);
}

WorldShape::WorldShape(const Matrix& toWorld, const std::array<Vec3d, 3>& corners)
    : isTriangle_(true) {
  for (std::size_t i = 0; i < 3; ++i) {
    points_[i] = toWorld.transformPoint(corners[i]);
    box_.extend(points_[i]);
  }
}

bool WorldShape::meets(const BoundingBox& cell) const {
  if (!isKnown()) return true;
  const Vec3d &a = points_[0], &b = points_[1], &c = points_[2];
  if (!isTriangle_) {
    const Vec3d nearest = largest(Vec3d(), largest(cell.low() - a, a - cell.high()));
    return dot(nearest, nearest) < radius_ * radius_;
  }
  if (isSeparated(cross(b - a, c - b), cell)) return false;
  for (const Vec3d& side : kAxes) {
    for (const Vec3d& edge : {b - a, c - b, a - c}) {
      if (isSeparated(cross(side, edge), cell)) return false;
    }
  }
  return true;
}

bool WorldShape::surrounds(const BoundingBox& cell) const {
  const Vec3d farthest =
      largest(absolute(cell.low() - points_[0]), absolute(cell.high() - points_[0]));
  return dot(farthest, farthest) < radius_ * radius_;
}

/// Whether triangle and cell, seen along `axis`, are beside each other. Along the cell's own axes
/// they are not, since their boxes overlap; nor is anything along the zero vector.
bool WorldShape::isSeparated(const Vec3d& axis, const BoundingBox& cell) const {
  const Vec3d parts = absolute(axis);
  if (parts.x() + parts.y() + parts.z() <= (1 + kTiny) * maxAbs(axis)) return false;
  const Vec3d middle = (cell.low() + cell.high()) * 0.5, half = (cell.high() - cell.low()) * 0.5;
  const double reach = (1 - kTiny) * dot(parts, half);
  const double a = dot(axis, points_[0] - middle), b = dot(axis, points_[1] - middle),
               c = dot(axis, points_[2] - middle);
  return std::min({a, b, c}) >= reach || std::max({a, b, c}) <= -reach;
}

WorldShape FlatObject::shapeOf(std::uint32_t face) const {
  const Matrix& toWorld = around->toWorld;
  if (mesh) return {toWorld, mesh->getGeometry().corners(face)};
  if (const auto* sphere = exactly<Sphere>(object)) return {toWorld, *sphere};
  if (const auto* triangle = exactly<Triangle>(object)) {
    return {toWorld, {triangle->getVertex(0), triangle->getVertex(1), triangle->getVertex(2)}};
  }
  BoundingBox box;
  object->addBounds(toWorld, box);
  return WorldShape(box);
}

Ray FlatTransform::rayInside(const Ray& world) const {
  return outer ? transform->toObject(outer->rayInside(world)) : world;
}

/// The way in once more, to know the rays outside; then each step out needs the one before it.
void FlatTransform::restate(const Ray& world, Hit& hit) const {
  std::vector<std::pair<const Transform*, Ray>> steps;  // and the ray outside, the innermost first
  for (const FlatTransform* each = this; each->outer; each = each->outer) {
    steps.emplace_back(each->transform, world);
  }
  for (std::size_t i = steps.size(); i-- > 1;) {
    steps[i - 1].second = steps[i].first->toObject(steps[i].second);
  }
  for (const auto& [each, outside] : steps) each->toParent(outside, hit);
}

FlatScene::FlatScene(const Object3D& root) {
  cornerBox = add(root, transforms.emplace_back());
  for (FlatObject& each : objects) {
    BoundingBox placed;
    each.object->addBounds(each.around->toWorld, placed);
    each.isPlaced &= areCubesInRange(placed);
    if (each.isPlaced) box.extend(placed);
  }
  if (!box.isEmpty()) boundErrors();
}

/// Returns the box of what it has added, inside `around`. The depth of recursion is the scene's
/// nesting.
BoundingBox FlatScene::add(const Object3D& object, const FlatTransform& around) {
  BoundingBox added;
  if (const auto* group = exactly<Group>(&object)) {
    for (const Object3D* member : group->getObjects()) {
      if (member) added.extend(add(*member, around));
    }
  } else if (const auto* inner = exactly<Transform>(&object)) {
    const Matrix toWorld = around.toWorld * inner->getMatrix();
    const auto& own = transforms.emplace_back(FlatTransform{inner, &around, toWorld});
    const BoundingBox inside = add(*inner->getObject(), own);
    if (!inside.isEmpty()) added = inside.moved(inner->getMatrix());
  } else {
    const auto* mesh = exactly<TriangleMesh>(&object);
    const std::uint32_t faceCount = mesh ? mesh->getGeometry().faceCount() : 1;
    const auto order = std::uint32_t(objects.size());
    if (object.isBounded()) object.addBounds(Matrix(), added);
    objects.push_back({&object, mesh, &around, order, faceCount, areCubesInRange(added)});
  }
  return added;
}

/// Finds the margin, and takes away the place of what needs a larger one.
void FlatScene::boundErrors() {
  margin = box.longestSide() * kSlack;
  reach = box.longestSide() * kReach + box.extent();
  transforms.front().largest = 4 * reach;
  transforms.front().error = 4 * reach * kUnit;
  for (FlatTransform& each : transforms) {
    if (!each.outer) continue;
    const double x = each.outer->largest;
    const TransformError own = errorThrough(*each.transform, {});
    each.largest = each.transform->getInverse().magnitudeAt({x, x, x});
    each.error =
        each.outer->error + stretchOf(each.outer->toWorld) * kUnit * (own.perSize * x + own.fixed);
  }
  for (FlatObject& each : objects) {
    const FlatTransform& around = *each.around;
    each.isPlaced &= around.error < margin / 2 && around.largest < kLargest &&
                     stretchOf(around.toWorld) < kLargest;
  }
}

}  // namespace accel
