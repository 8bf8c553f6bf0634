// Names from the scene file.
#include "render/scene_names.h"

#include "geometry/triangle_mesh.h"

SceneNames::SceneNames(const SceneParser& scene, const ObjectPlaces& places)
    : scene_(scene), places_(places) {
  for (int i = 0; i < scene.getNumMaterials(); ++i) materials_.emplace(scene.getMaterial(i), i);
}

std::string SceneNames::ofObject(const Object3D* object, std::optional<std::uint32_t> part) const {
  const std::size_t line = places_.lineOf(object);
  if (line == 0) return "an object that is not in the scene file";
  const bool isMesh = dynamic_cast<const TriangleMesh*>(object) != nullptr;
  return places_.pathOf(object) + ", " + places_.file() + ":" + std::to_string(line) +
         (isMesh && part ? ", triangle " + std::to_string(std::uint64_t(*part) + 1) : "");
}

std::string SceneNames::ofMaterial(const Material& material) const {
  const auto found = materials_.find(&material);
  if (found == materials_.end()) return "a material that is not in the scene file";
  return "material " + std::to_string(found->second) + ", " + material.getKind();
}

std::string SceneNames::ofLight(int index) const {
  const bool isPoint = dynamic_cast<const PointLight*>(scene_.getLight(index)) != nullptr;
  return "light " + std::to_string(index) + (isPoint ? ", PointLight" : ", DirectionalLight");
}
