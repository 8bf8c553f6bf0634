// SceneReview: one walk over all objects.
#include "scene/scene_review.h"

#include <cmath>
#include <typeinfo>

#include "geometry/group.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"

namespace {

/// What looking for lights inside objects may take: some hundredths of a second.
constexpr std::size_t kMostSteps = 4'000'000;
constexpr std::size_t kStepsPerFace = 8;

bool isIn(const BoundingBox& box, const Vec3d& p) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.low()[axis] <= p[axis] && p[axis] <= box.high()[axis])) return false;
  }
  return true;
}

/// The solid angle of a face as seen from the origin, its corners given, with the sign of its
/// side. Source: van Oosterom and Strackee, "The Solid Angle of a Plane Triangle", 1983. (The
/// arctangent may be the system's: nothing of it reaches a pixel.)
double solidAngle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double la = length(a), lb = length(b), lc = length(c);
  return 2 * std::atan2(dot(a, cross(b, c)),
                        la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

/// How often the mesh winds around p: 1 or -1 inside a closed surface, 0 outside, and something
/// between around open ones.
double windingNumber(const MeshGeometry& mesh, const Vec3d& p) {
  constexpr double kWhole = 4 * 3.14159265358979323846;
  double sum = 0;
  for (std::uint32_t face = 0; face < mesh.faceCount(); ++face) {
    sum += solidAngle(mesh.corner(face, 0) - p, mesh.corner(face, 1) - p, mesh.corner(face, 2) - p);
  }
  return sum / kWhole;
}

}  // namespace

SceneReview::SceneReview(const SceneParser& scene) {
  const Camera& camera = *scene.getCamera();
  isPerspective_ = typeid(camera) == typeid(PerspectiveCamera);
  Points points = {camera.getCenter()};
  for (int i = 0; i < scene.getNumLights(); ++i) {
    const auto* light = dynamic_cast<const PointLight*>(scene.getLight(i));
    if (!light) continue;
    pointLights_.push_back(i);
    points.push_back(light->getPosition());
  }
  enclosed_.resize(pointLights_.size());
  const Vec3d& direction = camera.getDirection();
  visit(*scene.getGroup(), {direction, -dot(direction, camera.getCenter()), 1}, points);
  if (hasMirror_) behind_.clear();
}

std::vector<SceneReview::EnclosedLight> SceneReview::getEnclosedLights() const {
  std::vector<EnclosedLight> lights;
  for (std::size_t i = 0; i < enclosed_.size(); ++i) {
    if (enclosed_[i]) lights.push_back({pointLights_[i], enclosed_[i]});
  }
  return lights;
}

void SceneReview::visit(const Object3D& object, const View& view, const Points& points) {
  const std::type_info& kind = typeid(object);
  if (kind == typeid(Sphere)) {
    visitSphere(static_cast<const Sphere&>(object), view, points);
  } else if (kind == typeid(Triangle)) {
    visitTriangle(static_cast<const Triangle&>(object), view);
  } else if (kind == typeid(Transform)) {
    visitMoved(static_cast<const Transform&>(object), view, points);
  } else if (kind == typeid(TriangleMesh)) {
    visitMesh(static_cast<const TriangleMesh&>(object), view, points);
  } else if (kind == typeid(Plane)) {
    noteMaterial(*static_cast<const Plane&>(object).getMaterial());
  } else if (kind == typeid(Group)) {
    for (const Object3D* each : static_cast<const Group&>(object).getObjects()) {
      if (each) visit(*each, view, points);
    }
  }
}

/// Takes the view and the points into the object's space: n . (A q + t) + offset is
/// (A^T n) . q + n . t + offset.
void SceneReview::visitMoved(const Transform& transform, const View& view, const Points& points) {
  const Matrix &matrix = transform.getMatrix(), &inverse = transform.getInverse();
  const Vec3d origin = matrix.transformPoint(Vec3d());
  const Vec3d normal = matrix.transposeTransformDirection(view.normal);
  const View inside = {normal, dot(view.normal, origin) + view.offset, length(normal)};
  if (pointLights_.empty()) return visit(*transform.getObject(), inside, points);
  Points moved;
  moved.reserve(points.size());
  for (const Vec3d& point : points) moved.push_back(inverse.transformPoint(point));
  steps_ += points.size();
  visit(*transform.getObject(), inside, moved);
}

void SceneReview::visitSphere(const Sphere& sphere, const View& view, const Points& points) {
  noteMaterial(*sphere.getMaterial());
  const Vec3d& center = sphere.getCenter();
  const double radius = sphere.getRadius();
  if (isPerspective_ && dot(view.normal, center) + view.offset + radius * view.length <= 0) {
    behind_.push_back(&sphere);
  }
  if (!mayEnclose(*sphere.getMaterial())) return;
  findEnclosed(sphere, points, [&](const Vec3d& p) {
    const Vec3d apart = p - center;
    return dot(apart, apart) < radius * radius;
  });
}

void SceneReview::visitTriangle(const Triangle& triangle, const View& view) {
  noteMaterial(*triangle.getMaterial());
  if (!isPerspective_) return;
  for (int i = 0; i < 3; ++i) {
    if (!(dot(view.normal, triangle.getVertex(i)) + view.offset <= 0)) return;
  }
  behind_.push_back(&triangle);
}

void SceneReview::visitMesh(const TriangleMesh& mesh, const View& view, const Points& points) {
  noteMaterial(*mesh.getMaterial());
  BoundingBox box;
  mesh.getGeometry().addBounds(Matrix(), box);
  if (box.isEmpty()) return;
  double farthest = view.offset;
  for (int axis = 0; axis < 3; ++axis) {
    const double n = view.normal[axis];
    farthest += n * (n > 0 ? box.high() : box.low())[axis];
  }
  if (isPerspective_ && farthest <= 0) behind_.push_back(&mesh);
  if (!mayEnclose(*mesh.getMaterial())) return;
  findEnclosed(mesh, points, [&](const Vec3d& p) {
    constexpr double kAlmostAll = 0.999;  // rounding is far less, and so is no hole of any size
    if (!isIn(box, p)) return false;
    steps_ += kStepsPerFace * mesh.getGeometry().faceCount();
    return steps_ <= kMostSteps && std::fabs(windingNumber(mesh.getGeometry(), p)) > kAlmostAll;
  });
}

void SceneReview::noteMaterial(const Material& material) {
  if (&material == lastMaterial_) return;
  lastMaterial_ = &material;
  hasMirror_ |= anyPositive(material.getReflectiveColor());
}

bool SceneReview::mayEnclose(const Material& material) {
  if (pointLights_.empty() || steps_ > kMostSteps) return false;
  steps_ += pointLights_.size();
  return !anyPositive(material.getTransparentColor());
}

/// An eye in the same object sees what the lights in there shine on.
template <class IsInside>
void SceneReview::findEnclosed(const Object3D& object, const Points& points,
                               const IsInside& isInside) {
  for (std::size_t i = 0; i < enclosed_.size(); ++i) {
    if (enclosed_[i] || !isInside(points[i + 1])) continue;
    if (isPerspective_ && isInside(points[0])) return;
    enclosed_[i] = &object;
  }
}
