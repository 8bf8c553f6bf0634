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
#include "accel/grid/flat_scene.h"

#include <algorithm>

#include "accel/transform_range.h"
#include "geometry/group.h"
#include "geometry/sphere.h"
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
  const double largest = std::max(maxAbs(box.low()), maxAbs(box.high()));
  return largest < kLargest && box.longestSide() > kSmallest;
}

}  // namespace

bool FlatObject::intersect(std::uint32_t face, const Ray& ray, Hit& hit, double tmin) const {
  if (!mesh) return object->intersect(ray, hit, tmin);
  double t;
  if (!mesh->nearestRoot(face, ray, tmin, hit.getT(), t)) return false;
  mesh->setHit(face, ray, t, hit);
  return true;
}

bool FlatObject::occluded(std::uint32_t face, const Ray& ray, double tmin, double tmax) const {
  double t;
  return mesh ? mesh->nearestRoot(face, ray, tmin, tmax, t) : object->occluded(ray, tmin, tmax);
}

void FlatObject::visitCrossings(std::uint32_t face, const Ray& ray,
                                CrossingVisitor& visitor) const {
  mesh ? mesh->visitFace(face, ray, visitor) : object->visitCrossings(ray, visitor);
}

FlatScene::FlatScene(const Object3D& root) {
  add(&root, kWorld);
  for (FlatObject& each : objects_) {
    BoundingBox own;
    each.object->addBounds(Matrix(), own);
    const BoundingBox box = boxOf(each, 0, each.faceCount());
    each.isPlaced = each.object->isBounded() && areCubesInRange(own) && areCubesInRange(box);
    if (each.isPlaced) box_.extend(box);
  }
  boundErrors();
}

/// The depth of recursion is the scene's nesting.
void FlatScene::add(const Object3D* object, int transform) {
  if (const auto* group = exactly<Group>(object)) {
    for (const Object3D* member : group->getObjects()) {
      if (member) add(member, transform);
    }
  } else if (const auto* inner = exactly<Transform>(object)) {
    transforms_.push_back({inner, transform, transformAt(transform).toWorld * inner->getMatrix()});
    add(inner->getObject(), int(transforms_.size()) - 1);
  } else {
    objects_.push_back({object, exactly<TriangleMesh>(object), transform});
  }
}

/// Finds the margin, and takes away the place of what needs a larger one.
void FlatScene::boundErrors() {
  if (box_.isEmpty()) return;
  const double size = box_.longestSide();
  margin_ = size * kSlack;
  reach_ = size * kReach + std::max(maxAbs(box_.low()), maxAbs(box_.high()));
  transforms_[kWorld].largest = 4 * reach_;
  transforms_[kWorld].error = 4 * reach_ * kUnit;
  for (std::size_t i = 1; i < transforms_.size(); ++i) {  // the outer ones come first
    FlatTransform& each = transforms_[i];
    const FlatTransform& parent = transformAt(each.parent);
    const double x = parent.largest;
    const TransformError own = errorThrough(*each.transform, {});
    each.largest = each.transform->getInverse().magnitudeAt({x, x, x});
    each.error = parent.error + stretchOf(parent.toWorld) * kUnit * (own.perSize * x + own.fixed);
  }
  for (FlatObject& each : objects_) {
    const FlatTransform& inside = transformAt(each.transform);
    const bool isExact = inside.error < margin_ / 2 && inside.largest < kLargest &&
                         stretchOf(inside.toWorld) < kLargest;
    each.isPlaced = each.isPlaced && isExact;
  }
}

/// The depth of recursion is the scene's nesting.
Ray FlatScene::rayInside(int transform, const Ray& world) const {
  if (transform == kWorld) return world;
  const FlatTransform& inner = transformAt(transform);
  return inner.transform->toObject(rayInside(inner.parent, world));
}

/// The way in once more, to know the rays outside; then each step out needs the one before it.
void FlatScene::restate(int transform, const Ray& world, Hit& hit) const {
  std::vector<const Transform*> path;  // the innermost first
  for (int n = transform; n != kWorld; n = transformAt(n).parent) {
    path.push_back(transformAt(n).transform);
  }
  std::vector<Ray> outsides;  // of the outermost first
  for (std::size_t i = path.size(); i-- > 0;) {
    outsides.push_back(outsides.empty() ? world : path[i + 1]->toObject(outsides.back()));
  }
  for (const Transform* each : path) {
    each->toParent(outsides.back(), hit);
    outsides.pop_back();
  }
}

BoundingBox FlatScene::boxOf(const FlatObject& object, std::uint32_t first,
                             std::uint32_t last) const {
  const Matrix& matrix = transformAt(object.transform).toWorld;
  BoundingBox box;
  if (last - first == object.faceCount()) {  // all of it, which a mesh knows more quickly
    object.object->addBounds(matrix, box);
    return box;
  }
  for (std::uint32_t face = first; face < last; ++face) {
    for (const Vec3d& corner : object.mesh->getGeometry().corners(face)) {
      box.extend(matrix.transformPoint(corner));
    }
  }
  return box;
}

WorldShape FlatScene::shapeOf(const FlatObject& object, std::uint32_t face) const {
  const Matrix& matrix = transformAt(object.transform).toWorld;
  if (const auto* sphere = exactly<Sphere>(object.object)) {
    return WorldShape::ball(matrix, sphere->getCenter(), sphere->getRadius());
  }
  if (const auto* triangle = exactly<Triangle>(object.object)) {
    return WorldShape::triangle(
        matrix, {triangle->getVertex(0), triangle->getVertex(1), triangle->getVertex(2)});
  }
  if (!object.mesh) return {};
  return WorldShape::triangle(matrix, object.mesh->getGeometry().corners(face));
}

}  // namespace accel
