// The sections of a scene file: camera, lights, background.
#include "scene/scene_builder.h"

#include <algorithm>

#include "camera/camera.h"
#include "math/functions.h"
#include "scene/directions.h"
#include "scene/scene_words.h"

SceneBuilder::SceneBuilder(const SourceText& text, MistakeLog& log, SceneParser& scene)
    : in_(text, log), scene_(scene), meshes_(text, log, scene.meshes_) {}

void SceneBuilder::build() {
  while (!in_.atEnd()) readSection();
  finish();
}

void SceneBuilder::readSection() {
  const std::string_view word = in_.word();
  if (!WordList(kSectionWords).contains(word)) return readMisplaced();
  in_.setQuiet(false);
  if (word == "OrthographicCamera" || word == "PerspectiveCamera") {
    readCamera(word == "PerspectiveCamera");
  } else if (word == "Lights") {
    readLights();
  } else if (word == "Background") {
    readBackground();
  } else if (word == "Materials") {
    readMaterials();
  } else {
    hasGroup_ = true;
    if (const Object3D* group = readObject()) scene_.group_.addObject(group);
  }
}

/// Something that is no section. What follows it up to the next section is its consequence.
void SceneBuilder::readMisplaced() {
  const std::string_view word = in_.word();
  if (word == "}") {
    in_.report(in_.at(), "expected a section, found '}' without a block to end");
    in_.advance();
  } else if (WordList(kGroupWords).contains(word)) {
    in_.report(in_.at(), "expected " + quoted(word) + " inside a Group, found it outside");
    in_.advance();
    if (in_.word() == "{") in_.skipBlock();
  } else {
    in_.skipUnknown("the scene", kSectionWords);
  }
  in_.setQuiet(true);
  hasMisplaced_ = true;
}

/// Camera, Lights, Background and Materials may stand once. The second one is read all the same.
void SceneBuilder::reportSecond(std::string_view what, bool& isSeen) {
  if (isSeen) {
    in_.report(in_.at(), "a second " + std::string(what) + ": expected only one, found " +
                             quoted(in_.word()));
  }
  isSeen = true;
}

void SceneBuilder::readCamera(bool isPerspective) {
  reportSecond("camera", hasCamera_);
  const std::string_view owner = in_.word();
  in_.advance();
  Vec3d center, direction, up;
  double extent = 0;
  Field fields[] = {{"center", &center},
                    {"direction", &direction},
                    {"up", &up},
                    {isPerspective ? "angle" : "size", &extent}};
  bool isGood = in_.readFields(owner, fields);
  isGood &= checkFrame(direction, fields[1], up, fields[2]);
  isGood &= checkAbove(0, extent, fields[3]);
  if (isPerspective && fields[3].at && !(extent < 180)) {
    in_.report(fields[3].at,
               "expected an angle below 180 degrees, found " + in_.quotedAt(fields[3].at));
    isGood = false;
  }
  if (!isGood) return;
  if (isPerspective) {
    scene_.camera_ = std::make_unique<PerspectiveCamera>(center, rescaled(direction), rescaled(up),
                                                         math::radians(extent));
  } else {
    scene_.camera_ =
        std::make_unique<OrthographicCamera>(center, rescaled(direction), rescaled(up), extent);
  }
}

bool SceneBuilder::checkFrame(const Vec3d& direction, const Field& directionField, const Vec3d& up,
                              const Field& upField) {
  const bool isDirectionGood = checkNotZero(direction, directionField);
  if (!checkNotZero(up, upField) || !isDirectionGood || !directionField.at || !upField.at) {
    return isDirectionGood;
  }
  if (!areParallel(direction, up)) return true;
  in_.report(upField.at, "expected an up that is not parallel to direction, found them parallel");
  return false;
}

void SceneBuilder::readLights() {
  reportSecond("Lights", hasLights_);
  lightsAt_ = in_.at();
  in_.advance();
  const CountedBlock block{"Lights", "numLights", kLightWords, kLightWords};
  readCounted(
      block, [this] { readLight(); }, [] { return false; });
}

void SceneBuilder::readLight() {
  const std::string_view owner = in_.word();
  const char* const at = in_.at();
  in_.advance();
  Vec3d place, attenuation(1, 0, 0);
  Vec3f color;
  if (owner == "DirectionalLight") {
    Field fields[] = {{"direction", &place}, {"color", &color}};
    const bool isGood = in_.readFields(owner, fields);
    if (!checkNotZero(place, fields[0]) || !isGood) return;
    lightStarts_.push_back(at);
    scene_.lights_.push_back(std::make_unique<DirectionalLight>(rescaled(place), color));
  } else {
    Field fields[] = {
        {"position", &place}, {"color", &color}, {"attenuation", &attenuation, false}};
    if (!in_.readFields(owner, fields)) return;
    lightStarts_.push_back(at);
    scene_.lights_.push_back(std::make_unique<PointLight>(place, color, attenuation));
  }
}

void SceneBuilder::readBackground() {
  reportSecond("Background", hasBackground_);
  in_.advance();
  Field fields[] = {{"color", &scene_.backgroundColor_, false},
                    {"ambientLight", &scene_.ambientLight_, false}};
  in_.readFields("Background", fields);
  noteColor(scene_.backgroundColor_, fields[0]);
  noteColor(scene_.ambientLight_, fields[1]);
}

/// What can only be said once everything is read.
void SceneBuilder::finish() {
  if (!hasCamera_ && !hasMisplaced_) {
    in_.reportExpected("an OrthographicCamera or a PerspectiveCamera in the scene");
  }
  if (scene_.lights_.empty()) {
    scene_.ambientLight_ = Vec3f(1, 1, 1);
    const char* const start = in_.text().bytes().data();
    warn(lightsAt_ ? lightsAt_ : start,
         "the scene has no lights: it is shown in white ambient light");
  }
  if (!hasGroup_) warn(in_.at(), "the scene has no Group: nothing will be seen");
  scene_.meshFiles_ = meshes_.files();
  warnOfMoreFlatTriangles();
  if (in_.mistakeCount() == 0) warnOfLikelyMistakes();
  std::stable_sort(warnings_.begin(), warnings_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& warning : warnings_) scene_.warnings_.push_back(std::move(warning.second));
}
