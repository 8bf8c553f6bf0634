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
  in_.readCounted({"Materials", "numMaterials", kMaterialWords, kMaterialWords}, readItem,
                  [] { return false; });
  if (in_.mistakeCount() > mistakesBefore) areIndicesSure_ = false;
}

void MaterialReader::readInline() {
  currentPlace_ = materials_.size();
  add();
  current_ = materials_.back().get();
}

void MaterialReader::add() {
  notes_.materials.push_back({in_.at(), false, {}});
  materials_.push_back(read());
}

void MaterialReader::readIndex() {
  in_.advance();
  const char* const at = in_.at();
  int index = 0;
  if (in_.readWholeNumber("MaterialIndex", index)) {
    if (index >= 0 && std::size_t(index) < notes_.listedMaterials) {
      currentPlace_ = std::size_t(index);
      current_ = materials_[currentPlace_].get();
      return;
    }
    if (areIndicesSure_) {
      in_.report(at, "MaterialIndex out of range: expected one of " +
                         std::to_string(notes_.listedMaterials) +
                         " materials, counted from 0, found " + in_.quotedAt(at));
    }
  }
  isMissed_ = true;
}

const Material* MaterialReader::materialFor(std::string_view owner, const char* at) {
  if (current_) {
    notes_.materials[currentPlace_].isUsed = true;
    return current_;
  }
  if (!isMissed_) {
    in_.report(at, "expected a MaterialIndex before the first object, found " + quoted(owner));
  }
  isMissed_ = true;
  return nullptr;
}

std::unique_ptr<Material> MaterialReader::read() {
  const std::string_view owner = in_.word();
  in_.advance();
  MaterialFields common;
  std::unique_ptr<Material> material;
  if (owner == "CookTorranceMaterial") {
    material = readCookTorrance(owner, common);
  } else if (owner == "WardMaterial") {
    material = readWard(owner, common);
  } else if (owner == "OrenNayarMaterial") {
    material = readOrenNayar(owner, common);
  } else if (owner == "PhongMaterial" || owner == "Material" || owner == "BlinnPhongMaterial") {
    material = readPhong(owner, common);
  } else {
    return readTexture(owner);
  }
  material->setPriority(common.priority.value);
  return material;
}

void MaterialReader::readBlock(std::string_view owner, const FieldList& own,
                               const FieldList& common) {
  in_.readFields(owner, {own, common});
  in_.checkRanges(common);
  in_.checkRanges(own);
}

std::unique_ptr<Material> MaterialReader::readPhong(std::string_view owner,
                                                    MaterialFields& common) {
  PhongFields own;
  readBlock(owner, own, common);
  const Vec3f& specular = own.specularColor.value;
  const float exponent = own.exponent.value;
  if (own.exponent.at && exponent < 1 && anyPositive(specular)) {
    notes_.lowExponents.emplace_back(own.exponent.at, in_.quotedAt(own.exponent.at));
  }
  if (owner == "BlinnPhongMaterial") {
    return std::make_unique<BlinnPhongMaterial>(
        common.diffuseColor.value, specular, exponent, common.transparentColor.value,
        common.reflectiveColor.value, common.indexOfRefraction.value);
  }
  return std::make_unique<PhongMaterial>(
      common.diffuseColor.value, specular, exponent, common.transparentColor.value,
      common.reflectiveColor.value, common.indexOfRefraction.value);
}

std::unique_ptr<Material> MaterialReader::readCookTorrance(std::string_view owner,
                                                           MaterialFields& common) {
  using Distribution = CookTorranceMaterial::Distribution;
  CookTorranceFields own;
  readBlock(owner, own, common);
  if (own.index.at && own.specularColor.at) {
    in_.report(std::max(own.index.at, own.specularColor.at),
               "expected index or specularColor in CookTorranceMaterial, found both");
  }
  return std::make_unique<CookTorranceMaterial>(
      common.diffuseColor.value,
      own.specularColor.at ? Fresnel::ofColor(own.specularColor.value)
                           : Fresnel::ofIndex(own.index.value),
      own.roughness.value,
      own.distribution.value.index == 0 ? Distribution::ggx : Distribution::beckmann,
      common.transparentColor.value, common.reflectiveColor.value, common.indexOfRefraction.value);
}

std::unique_ptr<Material> MaterialReader::readWard(std::string_view owner, MaterialFields& common) {
  WardFields own;
  readBlock(owner, own, common);
  const WardMaterial::Grain grain = {own.roughnessX.value, own.roughnessY.value, own.tangent.value};
  return std::make_unique<WardMaterial>(common.diffuseColor.value, own.specularColor.value, grain,
                                        common.transparentColor.value, common.reflectiveColor.value,
                                        common.indexOfRefraction.value);
}

std::unique_ptr<Material> MaterialReader::readOrenNayar(std::string_view owner,
                                                        MaterialFields& common) {
  OrenNayarFields own;
  readBlock(owner, own, common);
  return std::make_unique<OrenNayarMaterial>(
      common.diffuseColor.value, own.roughness.value, common.transparentColor.value,
      common.reflectiveColor.value, common.indexOfRefraction.value);
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

/// The first component is that of the first materialIndex.
std::unique_ptr<Material> MaterialReader::readTexture(std::string_view owner) {
  const char* const start = in_.at();
  TextureWords words;
  TextureFields fields;
  CheckerboardFields checkerboard;
  NoiseFields noise;
  WaveFields wave;
  fields.transform.value = [&] { return readTextureTransform(owner, words); };
  fields.materialIndex.value = [&] { return readTextureIndex(owner, words); };
  noise.octaves.value = [&] { return readOctaves(words.octaves); };
  bool isGood = owner == "Checkerboard" ? in_.readFields(owner, {fields, checkerboard})
                : owner == "Noise"      ? in_.readFields(owner, {fields, noise})
                                        : in_.readFields(owner, {fields, noise, wave});
  if (isGood && words.parts.size() < 2) {
    in_.report(start, "expected two materialIndex in " + std::string(owner) + ", found only one");
    isGood = false;
  }
  isGood &= in_.checkRanges(checkerboard);
  if (!isGood || !words.areIndicesGood) return plainMaterial();

  const Matrix& matrix = words.toTexture;
  const SolidTexture::Component &first = words.parts[0], &second = words.parts[1];
  const double frequency = wave.frequency.value, amplitude = wave.amplitude.value;
  if (owner == "Checkerboard") {
    return std::make_unique<Checkerboard>(matrix, first, second, checkerboard.size.value);
  }
  if (owner == "Noise") return std::make_unique<Noise>(matrix, first, second, words.octaves);
  if (owner == "Marble") {
    return std::make_unique<Marble>(matrix, first, second, words.octaves, frequency, amplitude);
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
  if (!isOpen && !WordList(kStepWords).contains(in_.word())) return false;
  bool isGood = readSteps(in_, kStepWords, false, words.toTexture);
  while (WordList(kObjectWords).contains(in_.word())) {
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
  if (words.parts.size() == 2) {
    in_.report(at, "expected two materialIndex in " + std::string(owner) + ", found a third, " +
                       in_.quotedAt(at));
    return false;
  }
  if (index >= 0 && std::size_t(index) < notes_.listedMaterials) {
    const auto place = std::size_t(index);
    words.parts.push_back({materials_[place].get(), place});
    notes_.materials.back().components.push_back(place);
    return true;
  }
  if (areIndicesSure_) {
    in_.report(at, "materialIndex out of range: expected one of the " +
                       std::to_string(notes_.listedMaterials) + " materials listed before this " +
                       std::string(owner) + ", counted from 0, found " + in_.quotedAt(at));
    return false;
  }
  words.parts.push_back({nullptr, 0});
  words.areIndicesGood = false;
  return true;
}

bool MaterialReader::readOctaves(int& octaves) {
  const char* const at = in_.at();
  if (!in_.readWholeNumber("octaves", octaves)) return false;
  if (octaves >= 1 && octaves <= math::kMaxOctaves) return true;
  in_.reportFound(at, "octaves from 1 to " + std::to_string(math::kMaxOctaves));
  return false;
}
