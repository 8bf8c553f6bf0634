// Solid textures of a scene file: where they lie, what they are made of, and their numbers.
#include <cmath>

#include "math/perlin_noise.h"
#include "scene/scene_builder.h"
#include "scene/scene_words.h"
#include "shading/phong_material.h"
#include "shading/solid_texture.h"

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

/// Reads the texture whose name is the current word, one of the four kinds.
std::unique_ptr<Material> SceneBuilder::readTexture() {
  const std::string_view owner = in_.word();
  in_.advance();
  const char* const start = in_.at();
  TextureWords words;
  const std::function<bool()> readMatrix = [&] { return readTextureTransform(owner, words); };
  const std::function<bool()> readIndex = [&] { return readPart(owner, words); };
  const std::function<bool()> readCount = [&] { return readOctaves(words.octaves); };
  std::vector<Field> fields = {{"Transform", &readMatrix, false}, {"materialIndex", &readIndex}};
  if (owner == "Checkerboard") {
    fields.push_back({"size", &words.size, false});
  } else {
    fields.push_back({"octaves", &readCount});
  }
  if (owner == "Marble" || owner == "Wood") {
    fields.push_back({"frequency", &words.frequency});
    fields.push_back({"amplitude", &words.amplitude});
  }
  bool isGood = in_.readFields(owner, fields);
  if (isGood && words.parts.size() < 2) {
    in_.report(start, "expected two materialIndex in " + std::string(owner) + ", found only one");
    isGood = false;
  }
  isGood &= checkAbove(0, words.size, fields[2]);
  return isGood && words.areIndicesGood ? makeTexture(owner, words) : plainMaterial();
}

/// The first part is that of the first materialIndex.
std::unique_ptr<Material> SceneBuilder::makeTexture(std::string_view owner,
                                                    const TextureWords& words) {
  const Matrix& matrix = words.toTexture;
  const SolidTexture::Component &first = words.parts[0], &second = words.parts[1];
  if (owner == "Checkerboard") {
    return std::make_unique<Checkerboard>(matrix, first, second, words.size);
  }
  if (owner == "Noise") return std::make_unique<Noise>(matrix, first, second, words.octaves);
  if (owner == "Marble") {
    return std::make_unique<Marble>(matrix, first, second, words.octaves, words.frequency,
                                    words.amplitude);
  }
  return std::make_unique<Wood>(matrix, first, second, words.octaves, words.frequency,
                                words.amplitude);
}

/// The Transform of a texture holds steps alone. The product need not have an inverse: points are
/// only taken into the texture's space, and a flat pattern is one that forgets a coordinate.
bool SceneBuilder::readTextureTransform(std::string_view owner, TextureWords& words) {
  const char* const at = in_.at();
  if (words.hasTransform) {
    in_.report(at, "expected one Transform in " + std::string(owner) + ", found a second");
  }
  const bool isFirst = !words.hasTransform;
  words.hasTransform = true;
  const bool isOpen = in_.openBlock("Transform");
  if (!isOpen && !WordList(kStepWords).contains(in_.word())) return false;
  bool isGood = readSteps(words.toTexture, kStepWords, false);
  while (WordList(kObjectWords).contains(in_.word())) {
    in_.report(in_.at(), "expected only steps in the Transform of " + std::string(owner) + " (" +
                             listed(kStepWords) + "), found " + quoted(in_.word()));
    in_.advance();
    if (in_.word() == "{") in_.skipBlock();
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
bool SceneBuilder::readPart(std::string_view owner, TextureWords& words) {
  const char* const at = in_.at();
  int index = 0;
  if (!in_.readWholeNumber("materialIndex", index)) return false;
  if (words.parts.size() == 2) {
    in_.report(at, "expected two materialIndex in " + std::string(owner) + ", found a third, " +
                       in_.quotedAt(at));
    return false;
  }
  if (index >= 0 && index < listedMaterials_) {
    const auto place = std::size_t(index);
    words.parts.push_back({scene_.materials_[place].get(), place});
    materialNotes_.back().parts.push_back(place);
    return true;
  }
  if (areMaterialsSure_) {
    in_.report(at, "materialIndex out of range: expected one of the " +
                       std::to_string(listedMaterials_) + " materials listed before this " +
                       std::string(owner) + ", counted from 0, found " + in_.quotedAt(at));
    return false;
  }
  words.parts.push_back({nullptr, 0});
  words.areIndicesGood = false;
  return true;
}

bool SceneBuilder::readOctaves(int& octaves) {
  const char* const at = in_.at();
  if (!in_.readWholeNumber("octaves", octaves)) return false;
  if (octaves >= 1 && octaves <= math::kMaxOctaves) return true;
  in_.report(at, "expected octaves from 1 to " + std::to_string(math::kMaxOctaves) + ", found " +
                     in_.quotedAt(at));
  return false;
}
