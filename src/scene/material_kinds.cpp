// The kinds of material of a scene file: one reader for each.
#include <algorithm>

#include "scene/directions.h"
#include "scene/scene_builder.h"
#include "shading/cook_torrance_material.h"
#include "shading/oren_nayar_material.h"
#include "shading/phong_material.h"
#include "shading/ward_material.h"

namespace {

constexpr std::size_t kCommonFields = 5;  // of materials of every kind

/// A material with what no constructor takes.
std::unique_ptr<Material> withPriority(std::unique_ptr<Material> material, int priority) {
  material->setPriority(priority);
  return material;
}

}  // namespace

/// Reads the block whose name is the current word: a kind's own `fields` and those of every kind,
/// which go to `base` and are checked. Returns all fields, its own first and in order.
std::vector<Field> SceneBuilder::readMaterialFields(MaterialBase& base, std::vector<Field> fields) {
  const std::string_view owner = in_.word();
  in_.advance();
  fields.push_back({"diffuseColor", &base.diffuseColor, false});
  fields.push_back({"transparentColor", &base.transparentColor, false});
  fields.push_back({"reflectiveColor", &base.reflectiveColor, false});
  fields.push_back({"indexOfRefraction", &base.indexOfRefraction, false});
  fields.push_back({"priority", &base.priority, false});
  in_.readFields(owner, fields);
  const Field* const common = fields.data() + fields.size() - kCommonFields;
  noteColor(base.diffuseColor, common[0]);
  noteColor(base.transparentColor, common[1]);
  noteColor(base.reflectiveColor, common[2]);
  checkAbove(0, double(base.indexOfRefraction), common[3]);
  return fields;
}

std::unique_ptr<Material> SceneBuilder::readPhong() {
  MaterialBase base;
  Vec3f specular;
  float exponent = 1;
  const std::vector<Field> fields = readMaterialFields(
      base, {{"specularColor", &specular, false}, {"exponent", &exponent, false}});
  checkAtLeast(0, double(exponent), fields[1]);
  noteColor(specular, fields[0]);
  noteExponent(specular, exponent, fields[1]);
  return withPriority(
      std::make_unique<PhongMaterial>(base.diffuseColor, specular, exponent, base.transparentColor,
                                      base.reflectiveColor, base.indexOfRefraction),
      base.priority);
}

std::unique_ptr<Material> SceneBuilder::readBlinnPhong() {
  MaterialBase base;
  Vec3f specular;
  float exponent = 1;
  const std::vector<Field> fields = readMaterialFields(
      base, {{"specularColor", &specular, false}, {"exponent", &exponent, false}});
  checkAtLeast(0, double(exponent), fields[1]);
  noteColor(specular, fields[0]);
  noteExponent(specular, exponent, fields[1]);
  return withPriority(std::make_unique<BlinnPhongMaterial>(
                          base.diffuseColor, specular, exponent, base.transparentColor,
                          base.reflectiveColor, base.indexOfRefraction),
                      base.priority);
}

std::unique_ptr<Material> SceneBuilder::readCookTorrance() {
  static constexpr std::string_view kDistributions[] = {"GGX", "Beckmann"};
  using Distribution = CookTorranceMaterial::Distribution;
  MaterialBase base;
  Vec3f specular;
  float roughness = 0.2f, index = 1.5f;
  std::size_t distribution = 0;
  const std::vector<Field> fields = readMaterialFields(
      base, {{"roughness", &roughness, false},
             {"index", &index, false},
             {"specularColor", &specular, false},
             {"distribution", WordChoice{kDistributions, &distribution}, false}});
  checkAbove(0, double(roughness), fields[0]);
  checkAbove(0, double(index), fields[1]);
  checkReflectance(specular, fields[2]);
  if (fields[1].at && fields[2].at) {
    const char* const second = std::max(fields[1].at, fields[2].at);
    in_.report(second, "expected index or specularColor in CookTorranceMaterial, found both");
  }
  return withPriority(
      std::make_unique<CookTorranceMaterial>(
          base.diffuseColor, fields[2].at ? Fresnel::ofColor(specular) : Fresnel::ofIndex(index),
          roughness, distribution == 0 ? Distribution::ggx : Distribution::beckmann,
          base.transparentColor, base.reflectiveColor, base.indexOfRefraction),
      base.priority);
}

std::unique_ptr<Material> SceneBuilder::readWard() {
  MaterialBase base;
  Vec3f specular;
  WardMaterial::Grain grain;
  const std::vector<Field> fields =
      readMaterialFields(base, {{"specularColor", &specular, false},
                                {"roughnessX", &grain.roughnessX, false},
                                {"roughnessY", &grain.roughnessY, false},
                                {"tangent", &grain.tangent, false}});
  checkAbove(0, double(grain.roughnessX), fields[1]);
  checkAbove(0, double(grain.roughnessY), fields[2]);
  checkNotZero(grain.tangent, fields[3]);
  noteColor(specular, fields[0]);
  grain.tangent = rescaled(grain.tangent);
  return withPriority(
      std::make_unique<WardMaterial>(base.diffuseColor, specular, grain, base.transparentColor,
                                     base.reflectiveColor, base.indexOfRefraction),
      base.priority);
}

std::unique_ptr<Material> SceneBuilder::readOrenNayar() {
  MaterialBase base;
  float roughness = 0.5f;
  const std::vector<Field> fields = readMaterialFields(base, {{"roughness", &roughness, false}});
  checkAtLeast(0, double(roughness), fields[0]);
  return withPriority(
      std::make_unique<OrenNayarMaterial>(base.diffuseColor, roughness, base.transparentColor,
                                          base.reflectiveColor, base.indexOfRefraction),
      base.priority);
}
