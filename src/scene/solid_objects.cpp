// SolidObjects: one walk through the tree of objects, which carries along how they stand in the
// world. A volume is that of the object's own space times the determinant of all Transforms.
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
constexpr double kMargin = 0x1p-20;

double determinantOf(const Matrix& matrix) {
  return dot(matrix.transformDirection({1, 0, 0}),
             cross(matrix.transformDirection({0, 1, 0}), matrix.transformDirection({0, 0, 1})));
}

}  // namespace

void visitTransparent(const Object3D& object, const Matrix& toWorld, const VisitSolid& visit) {
  if (const auto* group = exactly<Group>(&object)) {
    for (const Object3D* member : group->getObjects()) {
      if (member) visitTransparent(*member, toWorld, visit);
    }
  } else if (const auto* transform = exactly<Transform>(&object)) {
    visitTransparent(*transform->getObject(), toWorld * transform->getMatrix(), visit);
  } else if (const auto* sphere = exactly<Sphere>(&object)) {
    if (sphere->getMaterial()->isTransparent()) visit(object, nullptr, toWorld);
  } else if (const auto* mesh = exactly<TriangleMesh>(&object)) {
    if (mesh->getMaterial()->isTransparent()) visit(object, &mesh->getGeometry(), toWorld);
  }
}

SolidObjects::SolidObjects(const Object3D& root) {
  visitTransparent(
      root, Matrix(), [this](const auto& object, const auto* mesh, const auto& toWorld) {
        if (mesh && !mesh->isClosed()) return;
        const double radius = mesh ? 0 : static_cast<const Sphere&>(object).getRadius();
        const double own = mesh ? ::volumeOf(*mesh) : kBall * (radius * radius * radius);
        volumes_[&object] = std::fabs(determinantOf(toWorld)) * own;
        object.addBounds(toWorld, box_);
      });
}

double SolidObjects::volumeOf(const Object3D* object) const {
  const auto found = volumes_.find(object);
  return found != volumes_.end() ? found->second : std::numeric_limits<double>::infinity();
}

bool SolidObjects::areBeyond(const Vec3d& point, double distance) const {
  if (box_.isEmpty()) return true;
  const double rounding = kMargin * std::max(box_.extent(), maxAbs(point));
  const BoundingBox around = box_.widened(distance + rounding);
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] < around.low()[axis] || point[axis] > around.high()[axis]) return true;
  }
  return false;
}

ThinSolid findThinnestSolid(const Object3D& root, double limit,
                            const std::function<bool(const MeshGeometry&)>& isClosed) {
  ThinSolid thinnest;
  visitTransparent(root, Matrix(), [&](const auto& object, const auto* mesh, const auto& toWorld) {
    BoundingBox box;
    object.addBounds(Matrix(), box);
    double thickness = limit;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d side;
      side[axis] = box.high()[axis] - box.low()[axis];
      thickness = std::min(thickness, length(toWorld.transformDirection(side)));
    }
    if (!(thickness < limit && thickness < thinnest.thickness)) return;
    if (!mesh || isClosed(*mesh)) thinnest = {&object, thickness};
  });
  return thinnest;
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
