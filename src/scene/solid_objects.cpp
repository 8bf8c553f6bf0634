// SolidObjects: one walk through the tree of objects.
#include "scene/solid_objects.h"

#include <algorithm>
#include <limits>

#include "geometry/group.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"
#include "shading/material.h"

namespace {

constexpr double kBall = 4.1887902047863909846;  // 4 pi / 3
/// Of the largest coordinate: far above what rounding does to a place.
constexpr double kRounding = 0x1p-20;

double determinantOf(const Matrix& matrix) {
  return dot(matrix.transformDirection({1, 0, 0}),
             cross(matrix.transformDirection({0, 1, 0}), matrix.transformDirection({0, 0, 1})));
}

}  // namespace

SolidObjects::SolidObjects(const Object3D& root) { add(root, Matrix()); }

/// The depth of recursion is the scene's nesting.
void SolidObjects::add(const Object3D& object, const Matrix& toWorld) {
  if (const auto* group = dynamic_cast<const Group*>(&object)) {
    for (const Object3D* member : group->getObjects()) {
      if (member) add(*member, toWorld);
    }
    return;
  }
  if (const auto* transform = dynamic_cast<const Transform*>(&object)) {
    return add(*transform->getObject(), toWorld * transform->getMatrix());
  }
  double own = -1;  // not solid
  if (const auto* sphere = dynamic_cast<const Sphere*>(&object)) {
    const double radius = sphere->getRadius();
    if (sphere->getMaterial()->isTransparent()) own = kBall * (radius * radius * radius);
  } else if (const auto* mesh = dynamic_cast<const TriangleMesh*>(&object)) {
    const MeshGeometry& geometry = mesh->getGeometry();
    if (geometry.isClosed() && mesh->getMaterial()->isTransparent()) own = ::volumeOf(geometry);
  }
  if (own < 0) return;
  volumes_[&object] = std::fabs(determinantOf(toWorld)) * own;
  object.addBounds(toWorld, box_);
}

double SolidObjects::volumeOf(const Object3D* object) const {
  const auto found = volumes_.find(object);
  return found != volumes_.end() ? found->second : std::numeric_limits<double>::infinity();
}

bool SolidObjects::areBeyond(const Vec3d& point, double distance) const {
  if (box_.isEmpty()) return true;
  const double margin =
      distance + kRounding * std::max({maxAbs(box_.low()), maxAbs(box_.high()), maxAbs(point)});
  for (int axis = 0; axis < 3; ++axis) {
    const double x = point[axis];
    if (x < box_.low()[axis] - margin || x > box_.high()[axis] + margin) return true;
  }
  return false;
}

double volumeOf(const MeshGeometry& mesh) {
  double sum = 0;
  for (std::uint32_t face = 0; face < mesh.faceCount(); ++face) {
    const Vec3d origin = mesh.corner(0, 0), a = mesh.corner(face, 0) - origin,
                b = mesh.corner(face, 1) - origin, c = mesh.corner(face, 2) - origin;
    sum += dot(a, cross(b, c));
  }
  return std::fabs(sum) / 6;
}
