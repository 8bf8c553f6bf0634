// The tree of one ray as text, and the words of all reports: numbers as people read them, and what
// the objects, materials and lights of a scene are called. The same text on every machine.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "math/vec3.h"
#include "render/watched_tracer.h"
#include "scene/object_places.h"

/// The fewest digits that give the same float back. Minus zero is 0; a NaN has no sign.
std::string textOf(float number);
/// Up to 9 significant digits.
std::string textOf(double number);
/// Three numbers with blanks between.
template <class T>
std::string textOf(const Vec3<T>& v) {
  return textOf(v.x()) + " " + textOf(v.y()) + " " + textOf(v.z());
}

class SceneNames {
 public:
  /// `places` has been filled while the scene was read. Neither is owned.
  SceneNames(const SceneParser& scene, const ObjectPlaces& places)
      : scene_(scene), places_(places) {}

  /// "Group 1 > Sphere 2, scene.txt:12"; with `face`, counted from 0, a mesh's triangle too, there
  /// counted from 1.
  std::string ofObject(const Object3D* object, std::optional<std::uint32_t> face) const;
  /// "material 0, PhongMaterial".
  std::string ofMaterial(const Material& material) const;
  /// "light 0, PointLight"; 0 <= index < scene.getNumLights().
  std::string ofLight(int index) const;

 private:
  const SceneParser& scene_;
  const ObjectPlaces& places_;
};

/// An observer that writes the tree of rays as text: a line for each fact, in plain ASCII, two
/// blanks for each step down. `writeLine` takes one line after the other, each with its end.
/// The rays are traced as by `tracer`; neither that nor `names` is owned.
std::unique_ptr<RayObserver> makeRayReport(const RayTracer& tracer, const SceneNames& names,
                                           std::function<void(const std::string& line)> writeLine);
