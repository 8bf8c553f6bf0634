// Solid textures of a scene file, which are mixed from materials listed before them: where they
// lie, what they are mixed from, and their numbers.
//
// One that could not be read is replaced by a plain material, so that the numbers of those behind
// it stay right. A component that may have been lost by a mistake before is taken for good.
#include "scene/scene_reader.h"
#include "shading/phong_material.h"

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
  TextureWords words;
  const auto readOwn = [&](std::string_view name) {
    return name == "Transform" ? readTextureTransform(owner, words)
                               : readTextureIndex(owner, words);
  };
  const Fields fields =
      in_.readFields(owner, {"any texture", isWave ? "any wave" : owner}, readOwn);
  const auto& components = words.components;
  if (fields.areGood && components.size() < 2) {
    in_.report(start, "expected two materialIndex in " + std::string(owner) + ", found only one");
  }
  const bool areTwo = components.size() == 2 && components[0] && components[1];
  return fields.areGood && areTwo ? makeTexture(owner, fields, words) : plainMaterial();
}

std::unique_ptr<Material> MaterialReader::makeTexture(std::string_view owner, const Fields& fields,
                                                      const TextureWords& words) {
  const Matrix& matrix = words.toTexture;
  const Material *const first = words.components[0], *const second = words.components[1];
  if (owner == "Checkerboard") {
    return std::make_unique<Checkerboard>(matrix, first, second, fields["size"].number());
  }
  if (owner == "Noise") {
    return std::make_unique<Noise>(matrix, first, second, fields["octaves"].whole(),
                                   rules_.noiseSlope);
  }
  math::NoisyWaves waves = wavesOf(fields);
  if (owner == "Marble") {
    waves.height = rules_.marbleHeight;
    return std::make_unique<Marble>(matrix, first, second, waves);
  }
  if (rules_.isWoodGrained) return std::make_unique<GrainedWood>(matrix, first, second, waves);
  return std::make_unique<Wood>(matrix, first, second, waves);
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
  const std::string where = " listed before this " + std::string(owner);
  const Material* const component = listedMaterial(index, at, "materialIndex", where);
  if (!component && areIndicesSure_) return false;
  words.components.push_back(component);
  if (component) notes_.materials.back().components.push_back(std::size_t(index));
  return true;
}
