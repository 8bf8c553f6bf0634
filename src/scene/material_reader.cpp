// Materials of a scene file: the list of them, those inside Groups, and solid textures, which are
// mixed from materials listed before them.
//
// A material that has mistakes is made all the same, so that the numbers of those behind it stay
// right. After a mistake in the list an index out of range is no news: what it means may have been
// lost there.
#include <algorithm>

#include "math/perlin_noise.h"
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
  in_.readCounted({"Materials", "numMaterials", kMaterialWords, kMaterialWords}, readItem);
  if (in_.mistakeCount() > mistakesBefore) areIndicesSure_ = false;
}

/// In 2020: without a count.
void MaterialReader::readNodeMaterials() {
  if (!in_.openBlock("Materials")) return;
  while (!in_.atEnd() && !in_.isAt('}') && !isOneOf(in_.word(), kNodeSectionWords)) {
    if (!isOneOf(in_.word(), kNodeMaterialWords)) {
      in_.skipUnknown("Materials", kNodeMaterialWords);
      continue;
    }
    add();
    ++notes_.listedMaterials;
  }
  in_.closeBlock("Materials");
}

void MaterialReader::readInline() {
  const std::size_t number = materials_.size();
  add();
  current_ = {materials_.back().get(), number};
}

void MaterialReader::add() {
  notes_.materials.push_back({in_.at(), false, {}});
  materials_.push_back(read());
  materials_.back()->setNumber(int(materials_.size()) - 1);
}

void MaterialReader::readIndex(std::string_view name) {
  in_.advance();
  const char* const at = in_.at();
  int index = 0;
  if (in_.readWholeNumber(name, index)) {
    if (index >= 0 && std::size_t(index) < notes_.listedMaterials) {
      current_ = {materials_[std::size_t(index)].get(), std::size_t(index)};
      return;
    }
    if (areIndicesSure_) {
      in_.report(at, std::string(name) + " out of range: expected one of " +
                         counted(notes_.listedMaterials, "material") + ", counted from 0, found " +
                         in_.quotedAt(at));
    }
  }
  isMissed_ = true;
}

const Material* MaterialReader::materialFor(std::string_view owner, const char* at) {
  if (current_.material) {
    notes_.materials[current_.number].isUsed = true;
    return current_.material;
  }
  if (!isMissed_) {
    in_.report(at, std::string("expected a ") +
                       (in_.hasNodes() ? "Component<Material>" : "MaterialIndex") +
                       " before the first object, found " + quoted(owner));
  }
  isMissed_ = true;
  return nullptr;
}

std::unique_ptr<Material> MaterialReader::read() {
  const std::string_view owner = in_.word();
  in_.advance();
  if (in_.hasNodes()) return readNodeMaterial(owner);
  if (isOneOf(owner, kTextureWords)) return readTexture(owner);
  const bool isPhong =
      owner == "PhongMaterial" || owner == "Material" || owner == "BlinnPhongMaterial";
  const std::string_view kind = isPhong ? "PhongMaterial" : owner;
  Fields fields(in_.language(), {kind, "any material"});
  OwnWords own;
  in_.readFields(owner, fields, [&](std::string_view name) {
    return name == "Noise" ? readNoise(own.noise)
                           : in_.readChoice(name, kDistributionWords, own.distribution);
  });
  in_.checkRanges("any material", fields);
  in_.checkRanges(kind, fields);
  std::unique_ptr<Material> material = make(owner, fields, own);
  material->setPriority(fields["priority"].whole());
  return material;
}

/// A Material of 2020, from behind its name: the same with shorter words.
std::unique_ptr<Material> MaterialReader::readNodeMaterial(std::string_view owner) {
  Fields fields(in_.language(), {"node material"});
  in_.readFields(owner, fields);
  in_.checkRanges("node material", fields);
  PhongWords words = {fields["diffuse"].color(), fields["specular"].color(), {}, {}};
  words.exponent = &fields["shininess"];
  if (length(words.specular) > rules_.leastMirror) words.reflective = words.specular;
  return makePhong(owner, words);
}

std::unique_ptr<Material> MaterialReader::make(std::string_view owner, const Fields& fields,
                                               OwnWords& own) {
  const Vec3f diffuse = fields["diffuseColor"].color();
  const Vec3f transparent = fields["transparentColor"].color();
  const Vec3f reflective = fields["reflectiveColor"].color();
  const float index = fields["indexOfRefraction"].single();
  if (owner == "OrenNayarMaterial") {
    return std::make_unique<OrenNayarMaterial>(diffuse, fields["roughness"].single(), transparent,
                                               reflective, index);
  }
  const Vec3f specular = fields["specularColor"].color();
  if (owner == "WardMaterial") {
    const WardMaterial::Grain grain = {fields["roughnessX"].single(), fields["roughnessY"].single(),
                                       fields["tangent"].vector()};
    return std::make_unique<WardMaterial>(diffuse, specular, grain, transparent, reflective, index);
  }
  if (owner == "CookTorranceMaterial") {
    using Distribution = CookTorranceMaterial::Distribution;
    return std::make_unique<CookTorranceMaterial>(
        diffuse, fresnelOf(fields), fields["roughness"].single(),
        own.distribution == 0 ? Distribution::ggx : Distribution::beckmann, transparent, reflective,
        index);
  }
  // Where the rules say so, the specular colour is that of mirror and glass too; what the scene
  // itself says of these comes before it.
  PhongWords words = {diffuse, specular, transparent, reflective, index};
  words.exponent = &fields[fields.has("shininess") ? "shininess" : "exponent"];
  words.map = mapOf(fields, std::move(own.noise));
  if (length(specular) > rules_.leastMirror) {
    if (!fields["reflectiveColor"].at) words.reflective = specular;
    const bool refracts = fields.has("refractionIndex") && fields["refractionIndex"].single() > 0;
    if (refracts && !fields["transparentColor"].at) words.transparent = specular;
    if (refracts) words.index = fields["refractionIndex"].single();
  }
  return makePhong(owner, words);
}

/// The kind of material, and the kind of highlight, that the rules ask for.
std::unique_ptr<Material> MaterialReader::makePhong(std::string_view owner, PhongWords& words) {
  using Highlight = PhongMaterial::Highlight;
  const float exponent = words.exponent->single();
  const char* const exponentAt = words.exponent->at;
  if (exponentAt && exponent < 1 && anyPositive(words.specular)) {
    const std::string name(words.exponent->field->name);
    notes_.lowExponents.emplace_back(exponentAt, name + " " + in_.quotedAt(exponentAt));
  }
  if (!rules_.haveHighlights) words.specular = Vec3f();
  std::unique_ptr<PhongMaterial> material;
  if (rules_.isHighlightHalfway || owner == "BlinnPhongMaterial") {
    material = std::make_unique<BlinnPhongMaterial>(
        words.diffuse, words.specular, exponent, words.transparent, words.reflective, words.index);
  } else {
    material = std::make_unique<PhongMaterial>(words.diffuse, words.specular, exponent,
                                               words.transparent, words.reflective, words.index);
  }
  material->setDiffuseMap(words.map);
  if (rules_.areHighlightsDimmed) {
    material->setHighlight(Highlight::dimmed);
  } else if (rules_.areHighlightsEverywhere && owner != "BlinnPhongMaterial") {
    material->setHighlight(Highlight::everywhere);
    haveHighlightsBehind_ |= anyPositive(words.specular);
  }
  return material;
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

// Solid textures: where they lie, what they are mixed from, and their numbers.

namespace {

bool isFinite(const Matrix& matrix) {
  double sum = 0;  // 0 times anything finite is 0
  for (int i = 0; i < 12; ++i) sum += 0 * matrix.at(i / 4, i % 4);
  return sum == 0;
}

/// What takes the place of a texture that could not be read.
std::unique_ptr<Material> plainMaterial() {
  return std::make_unique<PhongMaterial>(Vec3f(1, 1, 1), Vec3f(), 1.0f, Vec3f(), Vec3f(), 1.0f);
}

}  // namespace

/// Reads a texture from behind its name. The first component is that of the first materialIndex.
std::unique_ptr<Material> MaterialReader::readTexture(std::string_view owner) {
  const char* const start = in_.at();
  const bool isWave = owner == "Marble" || owner == "Wood";
  const std::string_view kind = isWave ? "any wave" : owner;
  Fields fields(in_.language(), {"any texture", kind});
  TextureWords words;
  bool isGood = in_.readFields(owner, fields, [&](std::string_view name) {
    if (name == "octaves") return readOctaves(words.octaves);
    return name == "Transform" ? readTextureTransform(owner, words)
                               : readTextureIndex(owner, words);
  });
  if (isGood && words.components.size() < 2) {
    in_.report(start, "expected two materialIndex in " + std::string(owner) + ", found only one");
    isGood = false;
  }
  isGood &= in_.checkRanges(kind, fields);
  return isGood && words.areIndicesGood ? makeTexture(owner, fields, words) : plainMaterial();
}

std::unique_ptr<Material> MaterialReader::makeTexture(std::string_view owner, const Fields& fields,
                                                      const TextureWords& words) {
  const Matrix& matrix = words.toTexture;
  const SolidTexture::Component &first = words.components[0], &second = words.components[1];
  if (owner == "Checkerboard") {
    return std::make_unique<Checkerboard>(matrix, first, second, fields["size"].number());
  }
  if (owner == "Noise") {
    return std::make_unique<Noise>(matrix, first, second, words.octaves, rules_.noiseSlope);
  }
  const double frequency = fields["frequency"].number(), amplitude = fields["amplitude"].number();
  if (owner == "Marble") {
    return std::make_unique<Marble>(matrix, first, second, words.octaves, frequency, amplitude,
                                    rules_.marbleHeight);
  }
  if (rules_.isWoodGrained) {
    return std::make_unique<GrainedWood>(matrix, first, second, words.octaves, frequency,
                                         amplitude);
  }
  return std::make_unique<Wood>(matrix, first, second, words.octaves, frequency, amplitude);
}

/// The Transform of a texture holds steps alone. The product need not have an inverse: points are
/// only taken into the texture's space, and a flat pattern is one that forgets a coordinate.
bool MaterialReader::readTextureTransform(std::string_view owner, TextureWords& words) {
  const char* const at = in_.at();
  if (words.hasTransform) {
    in_.report(at, "expected one Transform in " + std::string(owner) + ", found a second");
  }
  const bool isFirst = !words.hasTransform;
  words.hasTransform = true;
  const bool isOpen = in_.openBlock("Transform");
  if (!isOpen && !isOneOf(in_.word(), kStepWords)) return false;
  bool isGood = readSteps(in_, kStepWords, false, words.toTexture);
  while (isOneOf(in_.word(), kObjectWords)) {
    in_.report(in_.at(), "expected only steps in the Transform of " + std::string(owner) + " (" +
                             listed(kStepWords) + "), found " + quoted(in_.word()));
    in_.skipWordAndBlock();
    isGood = false;
  }
  in_.closeBlock("Transform");
  if (isGood && !isFinite(words.toTexture)) {
    in_.report(at, "expected steps whose product is finite, found it out of range");
    isGood = false;
  }
  return isGood && isFirst;
}

/// Textures refer only to what is listed before them, so that none can hold itself.
bool MaterialReader::readTextureIndex(std::string_view owner, TextureWords& words) {
  const char* const at = in_.at();
  int index = 0;
  if (!in_.readWholeNumber("materialIndex", index)) return false;
  if (words.components.size() == 2) {
    in_.report(at, "expected two materialIndex in " + std::string(owner) + ", found a third, " +
                       in_.quotedAt(at));
    return false;
  }
  if (index >= 0 && std::size_t(index) < notes_.listedMaterials) {
    const auto number = std::size_t(index);
    words.components.push_back({materials_[number].get(), number});
    notes_.materials.back().components.push_back(number);
    return true;
  }
  if (areIndicesSure_) {
    in_.report(at, "materialIndex out of range: expected one of the " +
                       counted(notes_.listedMaterials, "material") + " listed before this " +
                       std::string(owner) + ", counted from 0, found " + in_.quotedAt(at));
    return false;
  }
  words.components.push_back({nullptr, 0});
  words.areIndicesGood = false;
  return true;
}

bool MaterialReader::readOctaves(int& octaves) {
  const char* const at = in_.at();
  if (!in_.readWholeNumber("octaves", octaves)) return false;
  if (octaves >= 0 && octaves <= math::kMaxOctaves) return true;
  in_.reportFound(at, "octaves from 0 to " + std::to_string(math::kMaxOctaves));
  return false;
}
