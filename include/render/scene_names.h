// SceneNames: what the objects, materials and lights of a scene are called in a report.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>

#include "scene/object_places.h"
#include "scene/scene_parser.h"

class SceneNames {
 public:
  /// `places` has been filled while the scene was read. Neither is owned.
  SceneNames(const SceneParser& scene, const ObjectPlaces& places);

  /// "Group 1 > Sphere 2, scene.txt:12"; with `part` a mesh's triangle too, counted from 1.
  std::string ofObject(const Object3D* object, std::optional<std::uint32_t> part) const;
  /// "material 0, PhongMaterial".
  std::string ofMaterial(const Material& material) const;
  /// "light 0, PointLight"; 0 <= index < scene.getNumLights().
  std::string ofLight(int index) const;

 private:
  const SceneParser& scene_;
  const ObjectPlaces& places_;
  std::unordered_map<const Material*, int> materials_;  // only looked up
};
