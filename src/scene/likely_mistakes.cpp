// Warnings of what is legal in a scene and probably a mistake.
#include <typeinfo>

#include "geometry/sphere.h"
#include "geometry/triangle.h"
#include "scene/scene_builder.h"
#include "scene/scene_review.h"

namespace {

/// So many of one kind are named; the rest are counted.
constexpr std::size_t kMostNamed = 5;

std::string kindOf(const Object3D& object) {
  if (typeid(object) == typeid(Sphere)) return "Sphere";
  return typeid(object) == typeid(Triangle) ? "Triangle" : "TriangleMesh";
}

bool isAboveOne(const Vec3f& color) { return color.r() > 1 || color.g() > 1 || color.b() > 1; }

}  // namespace

/// A colour above 1 sends back more light than arrives, or cannot be shown. Those of lights often
/// are, and are not asked about.
void SceneBuilder::noteColor(const Vec3f& color, const Field& field) {
  if (!field.at || !isAboveOne(color)) return;
  brightColors_.emplace_back(field.at, std::string(field.name));
}

void SceneBuilder::noteExponent(const Vec3f& specular, float exponent, const Field& field) {
  if (field.at && exponent < 1 && anyPositive(specular)) {
    lowExponents_.emplace_back(field.at, in_.quotedAt(field.at));
  }
}

/// Gives the first items to `warnOf`, which returns their place and text, and counts the rest at
/// the place of the first of them.
template <class Item, class Warn>
void SceneBuilder::warnOfSome(const std::vector<Item>& items, const std::string& what,
                              const Warn& warnOf) {
  for (std::size_t i = 0; i < items.size() && i <= kMostNamed; ++i) {
    const std::pair<const char*, std::string> warning = warnOf(items[i]);
    if (i < kMostNamed) {
      warn(warning.first, warning.second);
    } else {
      warn(warning.first, "and " + std::to_string(items.size() - i) + " more " + what);
    }
  }
}

void SceneBuilder::warnOfLikelyMistakes() {
  using Warning = std::pair<const char*, std::string>;
  warnOfSome(brightColors_, "colours above 1", [](const auto& color) {
    return Warning(color.first, color.second + " is above 1 in a component");
  });
  warnOfSome(lowExponents_, "exponents below 1", [](const auto& exponent) {
    return Warning(exponent.first,
                   "exponent " + exponent.second + " is below 1: its highlight fills the lit side");
  });
  warnOfUnusedMaterials();
  const SceneReview review(scene_);
  warnOfUnseen(review.getBehindCamera());
  warnOfSome(review.getEnclosedLights(), "lights inside objects", [&](const auto& each) {
    const std::size_t line = in_.text().lineAt(placeOf(*each.around));
    return Warning(lightStarts_[std::size_t(each.light)],
                   "the light is inside the " + kindOf(*each.around) + " of line " +
                       std::to_string(line) + ": with shadows it lights nothing outside");
  });
}

void SceneBuilder::warnOfUnseen(const std::vector<const Object3D*>& objects) {
  warnOfSome(objects, "objects behind the camera", [this](const Object3D* object) {
    return std::pair(placeOf(*object),
                     "the " + kindOf(*object) +
                         " is wholly behind the camera, and there is no mirror to show it");
  });
}

/// Textures stand behind their parts, so that one pass from the end finds all that is used. Where
/// nothing is used, the objects are what is missing.
void SceneBuilder::warnOfUnusedMaterials() {
  for (auto note = materialNotes_.rbegin(); note != materialNotes_.rend(); ++note) {
    if (!note->isUsed) continue;
    for (const std::size_t part : note->parts) materialNotes_[part].isUsed = true;
  }
  std::vector<std::size_t> unused;
  for (std::size_t i = 0; i < materialNotes_.size(); ++i) {
    if (!materialNotes_[i].isUsed) unused.push_back(i);
  }
  if (unused.size() == materialNotes_.size()) return;
  warnOfSome(unused, "materials that no object has", [this](std::size_t i) {
    const bool isListed = i < std::size_t(listedMaterials_);
    return std::pair(materialNotes_[i].at,
                     (isListed ? "material " + std::to_string(i) : "the material") +
                         " is not used by any object");
  });
}

const char* SceneBuilder::placeOf(const Object3D& object) const {
  for (std::size_t i = 0; i < scene_.objects_.size(); ++i) {
    if (scene_.objects_[i].get() == &object) return objectStarts_[i];
  }
  return in_.text().bytes().data();
}
