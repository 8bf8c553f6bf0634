// Materials of a scene file: the list of them, and which one holds for an object.
#include <iterator>

#include "scene/scene_builder.h"
#include "scene/scene_words.h"

void SceneBuilder::readMaterials() {
  reportSecond("Materials", hasMaterials_);
  if (hasGroup_) {
    in_.report(in_.at(), "expected Materials before the first Group, found it after one");
  }
  in_.advance();
  const std::size_t mistakesBefore = in_.mistakeCount();
  const CountedBlock block{"Materials", "numMaterials", kMaterialWords, kMaterialWords};
  const auto readItem = [&] {
    areMaterialsSure_ = in_.mistakeCount() == mistakesBefore;
    materialNotes_.push_back({in_.at(), false, {}});
    scene_.materials_.push_back(readMaterial());
    ++listedMaterials_;
  };
  readCounted(block, readItem, [] { return false; });
  if (in_.mistakeCount() > mistakesBefore) areMaterialsSure_ = false;
}

std::unique_ptr<Material> SceneBuilder::readMaterial() {
  struct Kind {
    std::string_view word;
    std::unique_ptr<Material> (SceneBuilder::*read)();
  };
  static constexpr Kind kKinds[] = {{"PhongMaterial", &SceneBuilder::readPhong},
                                    {"Material", &SceneBuilder::readPhong},
                                    {"BlinnPhongMaterial", &SceneBuilder::readBlinnPhong},
                                    {"CookTorranceMaterial", &SceneBuilder::readCookTorrance},
                                    {"WardMaterial", &SceneBuilder::readWard},
                                    {"OrenNayarMaterial", &SceneBuilder::readOrenNayar},
                                    {"Checkerboard", &SceneBuilder::readTexture},
                                    {"Noise", &SceneBuilder::readTexture},
                                    {"Marble", &SceneBuilder::readTexture},
                                    {"Wood", &SceneBuilder::readTexture}};
  static_assert(std::size(kKinds) == std::size(kMaterialWords), "each word has its reader");
  const Kind* kind = kKinds;
  while (kind->word != in_.word()) ++kind;
  return (this->*kind->read)();
}

/// A material written inside a Group, as in the course's older scenes.
void SceneBuilder::readInlineMaterial() {
  materialPlace_ = scene_.materials_.size();
  materialNotes_.push_back({in_.at(), false, {}});
  scene_.materials_.push_back(readMaterial());
  material_ = scene_.materials_.back().get();
}

void SceneBuilder::readMaterialIndex() {
  in_.advance();
  const char* const at = in_.at();
  int index = 0;
  if (in_.readWholeNumber("MaterialIndex", index)) {
    if (index >= 0 && index < listedMaterials_) {
      materialPlace_ = std::size_t(index);
      material_ = scene_.materials_[materialPlace_].get();
      return;
    }
    if (areMaterialsSure_) {
      in_.report(at, "MaterialIndex out of range: expected one of " +
                         std::to_string(listedMaterials_) + " materials, counted from 0, found " +
                         in_.quotedAt(at));
    }
  }
  isMaterialMissed_ = true;
}

/// True where a material holds for the object at `at`. That there is none is said once.
bool SceneBuilder::checkMaterial(std::string_view owner, const char* at) {
  if (material_) {
    materialNotes_[materialPlace_].isUsed = true;
    return true;
  }
  if (!isMaterialMissed_) {
    in_.report(at, "expected a MaterialIndex before the first object, found " + quoted(owner));
  }
  isMaterialMissed_ = true;
  return false;
}
