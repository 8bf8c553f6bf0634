// GridObjects: walks the tree of objects, and bounds what rounding can do to a hit.
//
// The margin, how far beyond its surface a hit may seem to lie, is kSlack of the scene. Half of it
// is for the walk through the cells, and for rays that strike a triangle so flat that t loses
// digits: down to an angle of some 2^-34. The other half is for the errors of the double functions:
//   - in the world 64 roundings of the largest number, where proofs need some 30;
//   - what each Transform above the object adds (TransformError), as much larger as the Transforms
//     around that one stretch.
// An object whose errors are larger than that has no place in a grid, nor has one whose numbers are
// so large or small that their squares and cubes leave the range.
#include "accel/grid/grid_objects.h"

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
bool isMeasurable(const BoundingBox& box) {
  const double largest = std::max(maxAbs(box.low()), maxAbs(box.high()));
  return largest < kLargest && box.longestSide() > kSmallest;
}

}  // namespace

bool GridObject::intersect(std::uint32_t face, const Ray& ray, Hit& hit, double tmin) const {
  if (!mesh) return object->intersect(ray, hit, tmin);
  double t;
  if (!mesh->nearestRoot(face, ray, tmin, hit.getT(), t)) return false;
  mesh->setHit(face, ray, t, hit);
  return true;
}

bool GridObject::occluded(std::uint32_t face, const Ray& ray, double tmin, double tmax) const {
  double t;
  return mesh ? mesh->nearestRoot(face, ray, tmin, tmax, t) : object->occluded(ray, tmin, tmax);
}

void GridObject::visitCrossings(std::uint32_t face, const Ray& ray,
                                CrossingVisitor& visitor) const {
  mesh ? mesh->visitFace(face, ray, visitor) : object->visitCrossings(ray, visitor);
}

GridObjects::GridObjects(const Object3D& root) {
  add(&root, GridTransform::kWorld);
  keepPlaced([&](const GridObject& object) {
    BoundingBox own;
    object.object->addBounds(Matrix(), own);
    return object.object->isBounded() && isMeasurable(own) &&
           isMeasurable(boxOf(object, 0, object.faceCount()));
  });
  for (const GridObject& object : placed_) box_.extend(boxOf(object, 0, object.faceCount()));
  if (!placed_.empty()) findErrors();
}

/// The depth of recursion is the scene's nesting.
void GridObjects::add(const Object3D* object, int transform) {
  if (const auto* group = exactly<Group>(object)) {
    for (const Object3D* member : group->getObjects()) {
      if (member) add(member, transform);
    }
  } else if (const auto* inner = exactly<Transform>(object)) {
    transforms_.push_back({inner, transform, transformAt(transform).toWorld * inner->getMatrix()});
    add(inner->getObject(), int(transforms_.size()) - 1);
  } else {
    const auto order = std::uint32_t(placed_.size());
    placed_.push_back({object, exactly<TriangleMesh>(object), transform, order});
  }
}

/// Moves the placed objects for which hasPlace(object) is false beside, both in scene order.
template <class Predicate>
void GridObjects::keepPlaced(const Predicate& hasPlace) {
  const auto end = std::stable_partition(placed_.begin(), placed_.end(), hasPlace);
  beside_.insert(beside_.end(), end, placed_.end());
  placed_.erase(end, placed_.end());
}

void GridObjects::findErrors() {
  const double size = box_.longestSide();
  margin_ = size * kSlack;
  reach_ = size * kReach + std::max(maxAbs(box_.low()), maxAbs(box_.high()));
  transforms_[GridTransform::kWorld].largest = 4 * reach_;
  transforms_[GridTransform::kWorld].error = 4 * reach_ * kUnit;
  for (std::size_t i = 1; i < transforms_.size(); ++i) {  // the outer ones come first
    GridTransform& each = transforms_[i];
    const GridTransform& parent = transformAt(each.parent);
    const double x = parent.largest;
    const TransformError own = errorThrough(*each.transform, {});
    each.largest = each.transform->getInverse().magnitudeAt({x, x, x});
    each.error = parent.error + stretchOf(parent.toWorld) * kUnit * (own.perSize * x + own.fixed);
  }
  keepPlaced([&](const GridObject& object) {
    const GridTransform& inside = transformAt(object.transform);
    return inside.error < margin_ / 2 && inside.largest < kLargest &&
           stretchOf(inside.toWorld) < kLargest;
  });
}

BoundingBox GridObjects::boxOf(const GridObject& object, std::uint32_t first,
                               std::uint32_t last) const {
  const Matrix& matrix = transformAt(object.transform).toWorld;
  BoundingBox box;
  if (last - first == object.faceCount()) {  // all of it, which a mesh knows more quickly
    object.object->addBounds(matrix, box);
    return box;
  }
  for (std::uint32_t face = first; face < last; ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      box.extend(matrix.transformPoint(object.mesh->getGeometry().corner(face, corner)));
    }
  }
  return box;
}

WorldShape GridObjects::shapeOf(const GridObject& object, std::uint32_t face) const {
  const Matrix& matrix = transformAt(object.transform).toWorld;
  if (const auto* sphere = exactly<Sphere>(object.object)) {
    return WorldShape::ball(matrix, sphere->getCenter(), sphere->getRadius());
  }
  const auto* triangle = exactly<Triangle>(object.object);
  if (!object.mesh && !triangle) return {};
  const auto corner = [&](int number) {
    return matrix.transformPoint(triangle ? triangle->getVertex(number)
                                          : object.mesh->getGeometry().corner(face, number));
  };
  return WorldShape::triangle(corner(0), corner(1), corner(2));
}

}  // namespace accel
