// The words of reports: numbers as people read them, and what the objects, materials and lights of
// a scene are called. The same text on every machine.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>

#include "math/vec3.h"
#include "scene/object_places.h"
#include "scene/scene_parser.h"

/// The fewest digits that give the same float back. Minus zero is 0; a NaN has no sign.
std::string textOf(float number);
/// Up to 9 significant digits.
std::string textOf(double number);
/// Three numbers with blanks between.
std::string textOf(const Vec3f& vector);
std::string textOf(const Vec3d& vector);

class SceneNames {
 public:
  /// `places` has been filled while the scene was read. Neither is owned.
  SceneNames(const SceneParser& scene, const ObjectPlaces& places);

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
  std::unordered_map<const Material*, int> materials_;  // only looked up
};
