// Warnings of what is legal in a scene and probably a mistake: materials that nothing has, colours
// and exponents out of the usual, objects that the camera cannot see, lights that objects enclose.
//
// The last two take one walk over all objects, with little to do at each (SceneWalk). It carries
// the half-space in front of the camera and the points that matter (the eye and the point lights)
// into the space of each Transform. A sphere, triangle or mesh wholly outside of that half-space is
// behind the camera, which only a mirror could show. A point light inside an opaque closed object
// lights nothing outside, unless the camera is in there too; of a mesh, the sum of the solid angles
// of its faces tells what is inside.
//
// Of one kind of warning only some are named and the rest counted.
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <typeinfo>

#include "geometry/group.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"
#include "geometry/triangle_mesh.h"
#include "scene/scene_reader.h"

namespace {

/// What looking for lights inside objects may take: some hundredths of a second.
constexpr std::size_t kMostSteps = 4'000'000;
constexpr std::size_t kStepsPerFace = 8;

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

/// The name of the object whose text this is.
std::string kindAt(std::string_view start) { return std::string(Tokenizer(start).next()); }

class SceneWalk {
 public:
  struct EnclosedLight {
    int light;               // its number in the scene
    const Object3D* around;  // not owned
  };

  /// Looks over a scene that is read without a mistake.
  explicit SceneWalk(const SceneParser& scene) {
    const Camera& camera = *scene.getCamera();
    isPerspective_ = typeid(camera) == typeid(PerspectiveCamera);
    Points points = {camera.getCenter()};
    for (int i = 0; i < scene.getNumLights(); ++i) {
      const auto* light = dynamic_cast<const PointLight*>(scene.getLight(i));
      if (!light) continue;
      lights_.push_back({i, nullptr});
      points.push_back(light->getPosition());
    }
    const Vec3d& direction = camera.getDirection();
    visit(scene.getGroup(), {direction, -dot(direction, camera.getCenter()), 1}, points);
    if (hasMirror_) behind_.clear();
    const auto isFree = [](const EnclosedLight& light) { return !light.around; };
    lights_.erase(std::remove_if(lights_.begin(), lights_.end(), isFree), lights_.end());
  }

  /// Spheres, triangles and meshes wholly behind a perspective camera, in scene order. None where
  /// any object is a mirror, which may show them.
  const std::vector<const Object3D*>& behindCamera() const { return behind_; }

  /// Point lights inside an opaque closed object (a sphere, a closed mesh) in which the camera is
  /// not, in the order of the lights, with the first such object. Lights are not looked for where
  /// there are too many pairs of light and object, or of light and mesh triangle.
  const std::vector<EnclosedLight>& enclosedLights() const { return lights_; }

 private:
  /// Where normal . p + offset > 0, the camera may see.
  struct View {
    Vec3d normal;
    double offset = 0, length = 0;  // of the normal
  };
  using Points = std::vector<Vec3d>;  // of the eye, then the point lights, in the object's space

  void visit(const Object3D* object, const View& view, const Points& points) {
    if (const auto* sphere = exactly<Sphere>(object)) return visitSphere(*sphere, view, points);
    if (const auto* triangle = exactly<Triangle>(object)) return visitTriangle(*triangle, view);
    if (const auto* moved = exactly<Transform>(object)) return visitMoved(*moved, view, points);
    if (const auto* mesh = exactly<TriangleMesh>(object)) return visitMesh(*mesh, view, points);
    if (const auto* plane = exactly<Plane>(object)) return note(*plane, false);
    if (const auto* group = exactly<Group>(object)) {
      for (const Object3D* each : group->getObjects()) {
        if (each) visit(each, view, points);
      }
    }
  }

  /// Takes the view and the points into the object's space: n . (A q + t) + offset is
  /// (A^T n) . q + n . t + offset.
  void visitMoved(const Transform& transform, const View& view, const Points& points) {
    const Matrix &matrix = transform.getMatrix(), &inverse = transform.getInverse();
    const Vec3d origin = matrix.transformPoint(Vec3d());
    const Vec3d normal = matrix.transposeTransformDirection(view.normal);
    const View inside = {normal, dot(view.normal, origin) + view.offset, length(normal)};
    if (lights_.empty()) return visit(transform.getObject(), inside, points);
    Points moved;
    moved.reserve(points.size());
    for (const Vec3d& point : points) moved.push_back(inverse.transformPoint(point));
    steps_ += points.size();
    visit(transform.getObject(), inside, moved);
  }

  void visitSphere(const Sphere& sphere, const View& view, const Points& points) {
    const Vec3d& center = sphere.getCenter();
    const double radius = sphere.getRadius();
    note(sphere, dot(view.normal, center) + view.offset + radius * view.length <= 0);
    if (!mayEnclose(*sphere.getMaterial())) return;
    findEnclosed(sphere, points, [&](const Vec3d& p) {
      const Vec3d apart = p - center;
      return dot(apart, apart) < radius * radius;
    });
  }

  void visitTriangle(const Triangle& triangle, const View& view) {
    bool isBehind = true;
    for (int i = 0; i < 3; ++i) {
      isBehind &= dot(view.normal, triangle.getVertex(i)) + view.offset <= 0;
    }
    note(triangle, isBehind);
  }

  void visitMesh(const TriangleMesh& mesh, const View& view, const Points& points) {
    BoundingBox box;
    mesh.getGeometry().addBounds(Matrix(), box);
    const Vec3d reach = largest(view.normal * box.low(), view.normal * box.high());
    const double farthest = view.offset + reach.x() + reach.y() + reach.z();
    note(mesh, farthest <= 0 && !box.isEmpty());
    if (box.isEmpty() || !mayEnclose(*mesh.getMaterial())) return;
    findEnclosed(mesh, points, [&](const Vec3d& p) {
      constexpr double kAlmostAll = 0.999;  // rounding is far less, and so is no hole of any size
      if (!box.contains({p, p})) return false;
      steps_ += kStepsPerFace * mesh.getGeometry().faceCount();
      return steps_ <= kMostSteps && std::fabs(windingNumber(mesh.getGeometry(), p)) > kAlmostAll;
    });
  }

  /// What there is to know of every shape.
  template <class Shape>
  void note(const Shape& shape, bool isBehind) {
    if (isPerspective_ && isBehind) behind_.push_back(&shape);
    if (shape.getMaterial() == lastMaterial_) return;
    lastMaterial_ = shape.getMaterial();
    hasMirror_ |= anyPositive(lastMaterial_->getReflectiveColor());
  }

  /// True where the object is opaque and there are lights to look for in it.
  bool mayEnclose(const Material& material) {
    if (lights_.empty() || steps_ > kMostSteps) return false;
    steps_ += lights_.size();
    return !material.isTransparent();
  }

  /// An eye in the same object sees what the lights in there shine on.
  template <class IsInside>
  void findEnclosed(const Object3D& object, const Points& points, const IsInside& isInside) {
    for (std::size_t i = 0; i < lights_.size(); ++i) {
      if (lights_[i].around || !isInside(points[i + 1])) continue;
      if (isPerspective_ && isInside(points[0])) return;
      lights_[i].around = &object;
    }
  }

  bool isPerspective_ = false, hasMirror_ = false;
  const Material* lastMaterial_ = nullptr;
  std::size_t steps_ = 0;
  std::vector<EnclosedLight> lights_;  // at first all point lights, with null around them
  std::vector<const Object3D*> behind_;
};

}  // namespace

void SceneNotes::warn(const char* at, const std::string& message) {
  warnings_.emplace(at, text_.name() + ":" + std::to_string(text_.lineAt(at)) + ": " + message);
}

std::vector<std::string> SceneNotes::inOrder() const {
  std::vector<std::string> texts;
  for (const auto& [place, text] : warnings_) texts.push_back(text);
  return texts;
}

void SceneNotes::review(const SceneParser& scene, const std::vector<Note>& brightColors) {
  // More light comes back from such a colour than arrives, or it cannot be shown. Those of lights
  // often are above 1, and are not asked about.
  warnOfSome(brightColors, "colours above 1", [](const Note& color) {
    return Note(color.first, color.second + " is above 1 in a component");
  });
  warnOfSome(lowExponents, "exponents below 1", [](const Note& exponent) {
    return Note(exponent.first, exponent.second + " is below 1: its highlight fills the lit side");
  });
  warnOfUnusedMaterials();
  warnOfDarkLights(scene);
  const SceneWalk walk(scene);
  warnOfSome(walk.behindCamera(), "objects behind the camera", [this](const Object3D* object) {
    const std::string_view start = fromStartOf(object);
    return Note(
        start.data(),
        "the " + kindAt(start) + " is wholly behind the camera, and there is no mirror to show it");
  });
  warnOfSome(walk.enclosedLights(), "lights inside objects", [this](const auto& each) {
    const std::string_view start = fromStartOf(each.around);
    return Note(lightStarts[std::size_t(each.light)],
                "the light is inside the " + kindAt(start) + " of line " +
                    std::to_string(text_.lineAt(start.data())) +
                    ": with shadows it lights nothing outside");
  });
}

namespace {

/// The least distance at which a0 + a1 s + a2 s^2 is not above 0, that of the light itself left
/// out; infinity where there is none.
double darkDistance(const Vec3d& a) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const bool isDarkAtOnce = a.x() < 0 || (a.x() == 0 && (a.y() < 0 || (a.y() == 0 && a.z() <= 0)));
  if (isDarkAtOnce) return 0;
  const double squared = a.y() * a.y() - 4 * a.x() * a.z();
  if (a.z() == 0) return a.y() < 0 ? -a.x() / a.y() : kNever;
  if (squared < 0) return kNever;
  double least = kNever;
  for (const double sign : {-1.0, 1.0}) {
    const double root = (-a.y() + sign * std::sqrt(squared)) / (2 * a.z());
    if (root > 0) least = std::min(least, root);
  }
  return least;
}

}  // namespace

/// Of point lights whose attenuation turns the light off, or would make it negative, somewhere in
/// the scene.
void SceneNotes::warnOfDarkLights(const SceneParser& scene) {
  std::vector<Note> notes;
  for (int i = 0; i < scene.getNumLights(); ++i) {
    const auto* const light = dynamic_cast<const PointLight*>(scene.getLight(i));
    if (!light) continue;
    const double distance = darkDistance(light->getAttenuation());
    if (!std::isfinite(distance)) continue;
    // Seldom: only then are all objects walked through.
    BoundingBox box;
    scene.getGroup()->addBounds(Matrix(), box);
    const Vec3d place = light->getPosition();
    const double farthest = length(largest(box.high() - place, place - box.low()));
    if (!box.isEmpty() && distance > farthest) continue;
    std::ostringstream text;
    text << "the light's attenuation is not above 0 "
         << (distance == 0 ? "near it" : "at a distance of ");
    if (distance > 0) text << distance;
    text << ": it adds nothing there";
    notes.emplace_back(lightStarts[std::size_t(i)], text.str());
  }
  warnOfSome(notes, "lights that add nothing somewhere", [](const Note& note) { return note; });
}

/// Textures stand behind their components, so that one pass from the end finds all that is used.
/// Where nothing is used, the objects are what is missing.
void SceneNotes::warnOfUnusedMaterials() {
  for (auto note = materials.rbegin(); note != materials.rend(); ++note) {
    if (!note->isUsed) continue;
    for (const std::size_t component : note->components) materials[component].isUsed = true;
  }
  std::vector<std::size_t> unused;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (!materials[i].isUsed) unused.push_back(i);
  }
  if (unused.size() == materials.size()) return;
  warnOfSome(unused, "materials that no object has", [this](std::size_t i) {
    const bool isListed = i < listedMaterials;
    return Note(materials[i].at, (isListed ? "material " + std::to_string(i) : "the material") +
                                     " is not used by any object");
  });
}

/// The text from the object's name on.
std::string_view SceneNotes::fromStartOf(const Object3D* object) const {
  const auto found = std::find_if(objectStarts.begin(), objectStarts.end(),
                                  [&](const auto& each) { return each.first == object; });
  return text_.from(found->second);
}
