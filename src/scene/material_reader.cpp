// Materials of a scene file: the list of them, and those inside Groups; and what a material may say
// in place of one diffuse colour: a picture, or noise. (Solid textures: texture_reader.cpp.)
//
// A material that has mistakes is made all the same, so that the numbers of those behind it stay
// right. After a mistake in the list an index out of range is no news: what it means may have been
// lost there.
#include <algorithm>

#include "scene/scene_reader.h"
#include "shading/cook_torrance_material.h"
#include "shading/oren_nayar_material.h"
#include "shading/phong_material.h"
#include "shading/ward_material.h"

void MaterialReader::readSection() {
  const std::size_t mistakesBefore = in_.mistakeCount();
  const auto readItem = [&] {
    areIndicesSure_ = in_.mistakeCount() == mistakesBefore;
    add();
    ++notes_.listedMaterials;
  };
  const CountedBlock counted = {"Materials", "numMaterials", kMaterialWords, kMaterialWords};
  const CountedBlock ofNodes = {"Materials", "", kNodeMaterialWords, kNodeMaterialWords};
  in_.readCounted(in_.hasNodes() ? ofNodes : counted, readItem);
  if (in_.mistakeCount() > mistakesBefore) areIndicesSure_ = false;
}

void MaterialReader::readInline() {
  add();
  select(scene_.materials_.back().get());
}

void MaterialReader::add() {
  notes_.materials.push_back({in_.at(), false, {}});
  scene_.materials_.push_back(read());
  scene_.materials_.back()->setNumber(int(scene_.materials_.size()) - 1);
}

void MaterialReader::readIndex(std::string_view name) {
  in_.advance();
  const char* const at = in_.at();
  int index = 0;
  const bool isRead = in_.readWholeNumber(name, index);
  const Material* const material =
      isRead ? listedMaterial(index, at, std::string(name), "") : nullptr;
  if (material) select(material);
  isMissed_ |= !material;
}

void MaterialReader::selectListed(int index) {
  const bool isListed = index >= 0 && std::size_t(index) < notes_.listedMaterials;
  isListed ? select(scene_.materials_[std::size_t(index)].get()) : void(isMissed_ = true);
}

/// The listed material that `index`, which stands at `at`, means. Null where it means none; that is
/// reported, unless a material may have been lost.
const Material* MaterialReader::listedMaterial(int index, const char* at, const std::string& name,
                                               const std::string& listedWhere) {
  if (index >= 0 && std::size_t(index) < notes_.listedMaterials) {
    return scene_.materials_[std::size_t(index)].get();
  }
  if (areIndicesSure_) {
    in_.report(at, name + " out of range: expected one of " + (listedWhere.empty() ? "" : "the ") +
                       counted(notes_.listedMaterials, "material") + listedWhere +
                       ", counted from 0, found " + in_.quotedAt(at));
  }
  return nullptr;
}

const Material* MaterialReader::materialFor(std::string_view owner, const char* at) {
  if (selected_) {
    notes_.materials[std::size_t(selected_->getNumber())].isUsed = true;
    return selected_;
  }
  if (!isMissed_) {
    const std::string wanted = in_.hasNodes()
                                   ? "a Component<Material> in this Node or one around it"
                                   : "a MaterialIndex before the first object";
    in_.report(at, "expected " + wanted + ", found " + quoted(owner));
  }
  isMissed_ = true;
  return nullptr;
}

std::unique_ptr<Material> MaterialReader::read() {
  const std::string_view owner = in_.word();
  in_.advance();
  if (isOneOf(owner, kTextureWords)) return readTexture(owner);
  const bool isPhong =
      owner == "PhongMaterial" || owner == "Material" || owner == "BlinnPhongMaterial";
  const std::string_view block = in_.hasNodes() ? "node" : isPhong ? "Phong" : owner;
  const DiffuseMap* noise = nullptr;
  const Fields fields = in_.readFields(owner, {block, "any material"}, [&](std::string_view) {
    return (noise = readNoise()) != nullptr;
  });
  std::unique_ptr<Material> material =
      isPhong ? makePhong(owner, fields, noise) : make(owner, fields);
  material->setPriority(fields["priority"].whole());
  return material;
}

std::unique_ptr<Material> MaterialReader::make(std::string_view owner, const Fields& fields) {
  const Vec3f diffuse = fields["diffuseColor"].color();
  const Vec3f transparent = fields["transparentColor"].color();
  const Vec3f reflective = fields["reflectiveColor"].color();
  const float index = fields["indexOfRefraction"].single();
  if (owner == "OrenNayarMaterial") {
    return std::make_unique<OrenNayarMaterial>(diffuse, fields["roughness"].single(), transparent,
                                               reflective, index);
  }
  if (owner == "WardMaterial") {
    const WardMaterial::Grain grain = {fields["roughnessX"].single(), fields["roughnessY"].single(),
                                       fields["tangent"].direction()};
    return std::make_unique<WardMaterial>(diffuse, fields["specularColor"].color(), grain,
                                          transparent, reflective, index);
  }
  using Distribution = CookTorranceMaterial::Distribution;
  return std::make_unique<CookTorranceMaterial>(
      diffuse, fresnelOf(fields), fields["roughness"].single(),
      fields["distribution"].whole() == 0 ? Distribution::ggx : Distribution::beckmann, transparent,
      reflective, index);
}

/// Where the rules say so, the specular colour is that of mirror and glass too; what the scene
/// itself says of these comes before it.
std::unique_ptr<Material> MaterialReader::makePhong(std::string_view owner, const Fields& fields,
                                                    const DiffuseMap* noise) {
  const Vec3f diffuse = fields["diffuseColor"].color();
  Vec3f specular = fields["specularColor"].color();
  Vec3f transparent = fields["transparentColor"].color();
  Vec3f reflective = fields["reflectiveColor"].color();
  float index = fields["indexOfRefraction"].single();
  if (length(specular) > rules_.leastMirror) {
    const float glass = fields["refractionIndex"].single();
    if (!fields["reflectiveColor"].at) reflective = specular;
    if (glass > 0 && !fields["transparentColor"].at) transparent = specular;
    if (glass > 0) index = glass;
  }
  const Value& exponent = fields["exponent"];
  if (exponent.at && exponent.single() < 1 && anyPositive(specular)) {
    const std::string name(exponent.field->name);
    notes_.lowExponents.emplace_back(exponent.at, name + " " + in_.quotedAt(exponent.at));
  }
  if (!rules_.haveHighlights) specular = Vec3f();
  const auto made = [&](auto material) {
    material->setDiffuseMap(mapOf(fields, noise));
    setHighlight(*material, owner);
    return material;
  };
  if (rules_.isHighlightHalfway || owner == "BlinnPhongMaterial") {
    return made(std::make_unique<BlinnPhongMaterial>(diffuse, specular, exponent.single(),
                                                     transparent, reflective, index));
  }
  return made(std::make_unique<PhongMaterial>(diffuse, specular, exponent.single(), transparent,
                                              reflective, index));
}

/// The kind of highlight that the rules ask for.
void MaterialReader::setHighlight(PhongMaterial& material, std::string_view owner) {
  if (rules_.areHighlightsDimmed) {
    material.setHighlight(PhongMaterial::Highlight::dimmed);
  } else if (rules_.areHighlightsEverywhere && owner != "BlinnPhongMaterial") {
    material.setHighlight(PhongMaterial::Highlight::everywhere);
    scene_.hasHighlightsBehind_ |= anyPositive(material.getSpecularColor());
  }
}

/// What a CookTorranceMaterial mirrors is given by one of two fields.
Fresnel MaterialReader::fresnelOf(const Fields& fields) {
  const Value &index = fields["index"], &color = fields["specularColor"];
  if (index.at && color.at) {
    in_.report(std::max(index.at, color.at),
               "expected index or specularColor in CookTorranceMaterial, found both");
  }
  return color.at ? Fresnel::ofColor(color.color()) : Fresnel::ofIndex(index.single());
}

// What takes the place of one diffuse colour: kept apart from the materials, by the PictureLibrary
// and the scene; each material that has one is told of it.

/// Reads the block behind `Noise`. The first color is that which a NoiseMap calls so. Null after a
/// mistake.
const DiffuseMap* MaterialReader::readNoise() {
  const char* const start = in_.at();
  std::vector<Vec3f> colors;
  const Fields fields = in_.readFields("Noise", {"noise of colors"}, [&](std::string_view name) {
    const char* const at = in_.at();
    double rgb[3];
    if (!in_.readNumbers(name, rgb, 3, true)) return false;
    colors.emplace_back(Vec3d::of(rgb));
    if (colors.size() > 2) in_.reportFound(at, "two color in Noise");
    return colors.size() <= 2;
  });
  if (!fields.areGood) return nullptr;
  if (colors.size() < 2) {
    in_.report(start, "expected two color in Noise, found only one");
    return nullptr;
  }
  scene_.noiseMaps_.push_back(std::make_unique<NoiseMap>(colors[0], colors[1], wavesOf(fields)));
  return scene_.noiseMaps_.back().get();
}

math::NoisyWaves MaterialReader::wavesOf(const Fields& fields) {
  return {fields["octaves"].whole(), fields["frequency"].number(), fields["amplitude"].number()};
}

/// What of the words of a material takes the place of its diffuse colour; null where nothing does.
const DiffuseMap* MaterialReader::mapOf(const Fields& fields, const DiffuseMap* noise) {
  if (const char* const bump = fields["bump"].at) {
    notes_.warn(bump,
                "bump is passed over: surfaces are drawn without " + quoted(in_.fileNameAt(bump)));
  }
  const char* const texture = fields["texture"].at;
  if (texture && noise) {
    in_.report(texture, "expected texture or Noise in a material, found both");
  }
  return texture ? pictures_.find(in_.fileNameAt(texture)) : noise;
}
