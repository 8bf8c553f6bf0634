// Numbers and names in reports.
//
// Numbers go through printf, which rounds to the nearest decimal number. For a float the digits are
// added one by one until reading them back gives the same float: 9 tell any two floats apart.
#include "render/report_words.h"

#include <cstdio>
#include <cstdlib>

#include "geometry/triangle_mesh.h"

namespace {

constexpr int kFewestDigits = 1, kMostDigits = 9;

std::string printed(double number, int digits) {
  if (number != number) return "nan";  // printf may give it a sign
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, number == 0 ? 0.0 : number);
  return text;
}

template <class T>
std::string textOfThree(const Vec3<T>& v) {
  return textOf(v.x()) + " " + textOf(v.y()) + " " + textOf(v.z());
}

}  // namespace

std::string textOf(float number) {
  int digits = kFewestDigits;
  while (digits < kMostDigits &&
         std::strtof(printed(double(number), digits).c_str(), nullptr) != number) {
    ++digits;
  }
  return printed(double(number), digits);
}

std::string textOf(double number) { return printed(number, kMostDigits); }
std::string textOf(const Vec3f& vector) { return textOfThree(vector); }
std::string textOf(const Vec3d& vector) { return textOfThree(vector); }

SceneNames::SceneNames(const SceneParser& scene, const ObjectPlaces& places)
    : scene_(scene), places_(places) {
  for (int i = 0; i < scene.getNumMaterials(); ++i) materials_.emplace(scene.getMaterial(i), i);
}

std::string SceneNames::ofObject(const Object3D* object, std::optional<std::uint32_t> face) const {
  const std::size_t line = places_.lineOf(object);
  if (line == 0) return "an object that is not in the scene file";
  const bool isMesh = dynamic_cast<const TriangleMesh*>(object) != nullptr;
  return places_.pathOf(object) + ", " + places_.file() + ":" + std::to_string(line) +
         (isMesh && face ? ", triangle " + std::to_string(std::uint64_t(*face) + 1) : "");
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
