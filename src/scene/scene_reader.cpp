// The sections of a scene file, and the small ones themselves: camera, lights, background.
//
// Sections may come in any order, but Materials before the first Group. Each is read by its name up
// to the `}` that ends it; what is no section is reported once, and passed over up to the next one.
// At the end comes what can only be said of the whole: what is missing, given twice, or probably
// not meant so.
#include "scene/scene_reader.h"

#include <algorithm>

#include "camera/camera.h"
#include "math/functions.h"

namespace {

/// True when the two are parallel as far as decimal numbers can tell: the sine of the angle
/// between them is below 1e-14, some 50 times the rounding error of the test. Both have been
/// brought to lengths near 1 (Range::direction).
bool areParallel(const Vec3d& a, const Vec3d& b) {
  return length(cross(a, b)) <= 1e-14 * length(a) * length(b);
}

}  // namespace

SceneReader::SceneReader(const SourceText& text, MistakeLog& log, SceneParser& scene,
                         ObjectPlaces* places, const SceneRules& rules)
    : in_(text, log, rules.language),
      rules_(rules),
      notes_(text),
      scene_(scene),
      meshes_(text, log, scene.meshes_, rules),
      pictures_(text, log, scene.pictures_),
      materials_(in_, notes_, scene.materials_, pictures_, scene.noiseMaps_, rules),
      objects_(in_, notes_, materials_, meshes_, scene.objects_, places) {}

void SceneReader::read() {
  if (isWideText(in_.text().bytes())) {
    in_.report(in_.text().bytes().data(), "expected text in UTF-8, found what looks like UTF-16");
    return;
  }
  while (!in_.atEnd()) readSection();
  finish();
}

void SceneReader::readSection() {
  if (in_.hasNodes()) return readNodeSection();
  const std::string_view word = in_.word();
  if (!isOneOf(word, kSectionWords)) return readMisplaced();
  in_.setQuiet(false);
  if (word == "Lights") {
    readLights();
  } else if (word == "Background") {
    readBackground();
  } else if (word == "Materials") {
    reportSecond("Materials");
    if (hasGroup_) {
      in_.report(in_.at(), "Materials must come before the first Group");
    }
    in_.advance();
    materials_.readSection();
  } else if (word == "Group") {
    hasGroup_ = true;
    if (const Object3D* group = objects_.read()) scene_.group_.addObject(group);
  } else {
    readCamera();
  }
}

/// A section of 2020, where objects and lights stand in one Scene of nodes.
void SceneReader::readNodeSection() {
  const std::string_view word = in_.word();
  if (!isOneOf(word, kNodeSectionWords)) return readMisplaced();
  in_.setQuiet(false);
  if (word == "Camera") return readCamera();
  if (word == "Background") return readBackground();
  reportSecond(word);
  if (word == "Materials") {
    if (hasGroup_) in_.report(in_.at(), "Materials must come before Scene");
    in_.advance();
    return materials_.readNodeMaterials();
  }
  hasGroup_ = true;
  lightsAt_ = in_.at();
  NodeReader nodes(
      in_, materials_, objects_, rules_.nearFalloff,
      [this](const char* at, std::unique_ptr<Light> light) { addLight(at, std::move(light)); });
  if (const Object3D* scene = nodes.read()) scene_.group_.addObject(scene);
}

/// Something that is no section. What follows it up to the next section is its consequence.
void SceneReader::readMisplaced() {
  const std::string_view word = in_.word();
  if (in_.isAt('}')) {
    in_.report(in_.at(), "expected a section, found '}' without a block to end");
    in_.advance();
  } else if (isOneOf(word, kGroupWords) && !in_.hasNodes()) {
    in_.report(in_.at(), "expected " + quoted(word) + " inside a Group, found it outside");
    in_.skipWordAndBlock();
  } else {
    in_.skipUnknown("the scene", in_.hasNodes() ? WordList(kNodeSectionWords) : kSectionWords);
  }
  in_.setQuiet(true);
  hasMisplaced_ = true;
}

/// Camera, Lights, Background and Materials may stand once. The second one is read all the same.
void SceneReader::reportSecond(std::string_view what) {
  if (seen_.insert(what).second) return;
  in_.report(in_.at(),
             "a second " + std::string(what) + ": expected only one, found " + quoted(in_.word()));
}

void SceneReader::readCamera() {
  reportSecond("camera");
  const std::string_view owner = in_.word();
  in_.advance();
  Fields fields(in_.language(), {"any camera", owner});
  const bool areFieldsGood = in_.readFields(owner, fields);
  const Value &direction = fields["direction"], &up = fields["up"];
  const Vec3d writtenUp = up.vector();  // whose length may count
  const bool areBothGiven = in_.checkRanges("any camera", fields) && direction.at && up.at;
  const bool isParallel = areBothGiven && areParallel(direction.vector(), up.vector());
  if (isParallel) {
    in_.report(up.at, "expected an up that is not parallel to direction, found them parallel");
  }
  if (!in_.checkRanges(owner, fields) || !areFieldsGood || !areBothGiven || isParallel) return;
  const Vec3d center = fields["center"].vector();
  CameraFrame frame = CameraFrame::turned(direction.vector(), up.vector());
  setUp(frame, writtenUp);
  if (owner == "OrthographicCamera") {
    scene_.camera_ = std::make_unique<OrthographicCamera>(center, frame, fields["size"].number());
    return;
  }
  const double angle = fields[owner == "Camera" ? "fov" : "angle"].number();
  scene_.camera_ = std::make_unique<PerspectiveCamera>(center, frame, math::radians(angle));
  if (fields.has("width")) {
    scene_.pictureSize_ = {fields["width"].whole(), fields["height"].whole()};
  }
}

/// Right and up as the rules make them of `up`; `frame` has them turned.
void SceneReader::setUp(CameraFrame& frame, const Vec3d& up) const {
  using Up = SceneRules::CameraUp;
  if (rules_.cameraUp == Up::turned) return;
  frame.up = rules_.cameraUp == Up::unit ? normalize(up) : up;
  if (rules_.cameraUp != Up::unscaled) return;
  frame.right = cross(frame.direction, up);
  frame.up = cross(frame.right, frame.direction);
}

void SceneReader::readLights() {
  reportSecond("Lights");
  lightsAt_ = in_.at();
  in_.advance();
  in_.readCounted({"Lights", "numLights", kLightWords, kLightWords}, [this] { readLight(); });
}

void SceneReader::readLight() {
  const std::string_view owner = in_.word();
  const char* const at = in_.at();
  in_.advance();
  Fields fields(in_.language(), {owner});
  const bool isRead = in_.readFields(owner, fields);
  if (!in_.checkRanges(owner, fields) || !isRead) return;
  const Vec3f color = fields["color"].color();
  if (owner == "DirectionalLight") {
    addLight(at, std::make_unique<DirectionalLight>(fields["direction"].vector(), color));
    return;
  }
  Vec3d attenuation(1, 0, 0);
  if (fields.has("attenuation")) {
    attenuation = fields["attenuation"].vector();
  } else if (fields.has("falloff")) {
    attenuation = {rules_.nearFalloff, 0, fields["falloff"].number()};
  }
  addLight(at, std::make_unique<PointLight>(fields["position"].vector(), color, attenuation));
}

void SceneReader::addLight(const char* at, std::unique_ptr<Light> light) {
  notes_.lightStarts.push_back(at);
  scene_.lights_.push_back(std::move(light));
}

void SceneReader::readBackground() {
  reportSecond("Background");
  in_.advance();
  Fields fields(in_.language(), {"Background"});
  in_.readFields("Background", fields);
  in_.checkRanges("Background", fields);
  std::optional<CubeMap> cubeMap;
  if (fields.has("cubeMap") && fields["cubeMap"].at) {
    cubeMap = pictures_.findCube(in_.fileNameAt(fields["cubeMap"].at), rules_.cubeMapEnding);
  }
  scene_.background_ = Background(fields["color"].color(), cubeMap);
  if (fields.has("ambientLight")) scene_.ambientLight_ = fields["ambientLight"].color();
}

/// What can only be said once everything is read.
void SceneReader::finish() {
  if (seen_.count("camera") == 0 && !hasMisplaced_) {
    in_.reportExpected(in_.hasNodes()
                           ? "a Camera in the scene"
                           : "an OrthographicCamera or a PerspectiveCamera in the scene");
  }
  if (scene_.lights_.empty()) scene_.ambientLight_ = Vec3f(1, 1, 1);
  warnOfEmptiness();
  tellRepeats();
  scene_.inputFiles_ = meshes_.files().paths();
  for (std::string& path : pictures_.files().paths()) {
    scene_.inputFiles_.push_back(std::move(path));
  }
  scene_.hasHighlightsBehind_ = materials_.haveHighlightsBehind();
  if (in_.mistakeCount() == 0) review();
  scene_.warnings_ = notes_.inOrder();
}

/// Of what is legal, and leaves little or nothing to be seen.
void SceneReader::warnOfEmptiness() {
  if (scene_.lights_.empty()) {
    notes_.warn(lightsAt_ ? lightsAt_ : in_.text().bytes().data(),
                "the scene has no lights: it is shown in white ambient light");
  }
  if (!hasGroup_) {
    notes_.warn(in_.at(), std::string("the scene has no ") + (in_.hasNodes() ? "Scene" : "Group") +
                              ": nothing will be seen");
  }
  if (notes_.flatTriangles > ObjectReader::kFlatTrianglesNamed) {
    notes_.warn(in_.at(), std::to_string(notes_.flatTriangles - ObjectReader::kFlatTrianglesNamed) +
                              " more triangles have no area: they will not be seen");
  }
}

/// For -check a field that is given twice is a mistake, else worth a warning.
void SceneReader::tellRepeats() {
  const auto textOf = [this](const FieldReader::Repeat& repeat) {
    return std::string(repeat.name) + " is given a second time, first in line " +
           std::to_string(in_.text().lineAt(repeat.before)) + "; the last one holds";
  };
  if (in_.isChecking()) {
    for (const auto& repeat : in_.repeats()) in_.report(repeat.at, textOf(repeat));
  } else {
    notes_.warnOfSome(in_.repeats(), "fields given a second time", [&](const auto& repeat) {
      return FieldReader::Note(repeat.at, textOf(repeat));
    });
  }
}

/// Only of a whole scene can be said what is probably meant otherwise.
void SceneReader::review() {
  notes_.review(scene_, in_.brightColors());
  const auto isGlass = [](const auto& material) { return material->isTransparent(); };
  if (std::none_of(scene_.materials_.begin(), scene_.materials_.end(), isGlass)) return;
  const auto isClosed = [this](const MeshGeometry& geometry) {
    for (const auto& mesh : scene_.meshes_) {
      if (mesh.get() == &geometry) mesh->findWhetherClosed();
    }
    return geometry.isClosed();
  };
  ThinSolid& thinnest = scene_.thinnest_;
  thinnest = findThinnestSolid(scene_.group_, SceneParser::kThinSolid, isClosed);
  if (thinnest.object) thinnest.line = notes_.lineOf(thinnest.object);
}
