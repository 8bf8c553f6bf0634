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
/// between them is below 1e-14, some 50 times the rounding error of the test. Their lengths are
/// near 1 (Value::direction); one that is 0 is parallel to none.
bool areParallel(const Vec3d& a, const Vec3d& b) {
  return length(cross(a, b)) < 1e-14 * length(a) * length(b);
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
      materials_(in_, notes_, scene, pictures_, rules),
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
  struct Section {
    std::string_view word;
    std::string_view once;  // what may stand once
    void (SceneReader::*read)();
  };
  static constexpr Section kSections[] = {
      {"OrthographicCamera", "camera", &SceneReader::readCamera},
      {"PerspectiveCamera", "camera", &SceneReader::readCamera},
      {"Camera", "camera", &SceneReader::readCamera},
      {"Lights", "Lights", &SceneReader::readLights},
      {"Background", "Background", &SceneReader::readBackground},
      {"Materials", "Materials", &SceneReader::readMaterials},
      {"Group", "", &SceneReader::readGroup},
      {"Scene", "Scene", &SceneReader::readNodes},
  };
  const std::string_view word = in_.word();
  if (!isOneOf(word, in_.sectionWords())) return readMisplaced();
  in_.setQuiet(false);
  const Section* section = kSections;
  while (section->word != word) ++section;
  if (!section->once.empty() && !seen_.insert(section->once).second) {
    in_.report(in_.at(), "a second " + std::string(section->once) + ": expected only one, found " +
                             quoted(word));
  }
  (this->*section->read)();
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
    in_.skipUnknown("the scene", in_.sectionWords());
  }
  in_.setQuiet(true);
  hasMisplaced_ = true;
}

void SceneReader::readCamera() {
  const std::string_view owner = in_.word();
  in_.advance();
  const Fields fields = in_.readFields(owner, {"any camera", owner});
  const Value &direction = fields["direction"], &up = fields["up"];
  if (direction.at && up.at && areParallel(direction.direction(), up.direction())) {
    in_.report(up.at, "expected an up that is not parallel to direction, found them parallel");
    return;
  }
  if (!fields.areGood) return;
  const Vec3d center = fields["center"].vector();
  const CameraFrame frame = frameOf(direction, up);
  if (owner == "OrthographicCamera") {
    scene_.camera_ = std::make_unique<OrthographicCamera>(center, frame, fields["size"].number());
    return;
  }
  const double angle = math::radians(fields["angle"].number());
  scene_.camera_ = std::make_unique<PerspectiveCamera>(center, frame, angle);
  scene_.pictureSize_ = {fields["width"].whole(), fields["height"].whole()};
}

/// Right and up as the rules make them of the `up` that is given, whose length may count.
CameraFrame SceneReader::frameOf(const Value& direction, const Value& up) const {
  using Up = SceneRules::CameraUp;
  CameraFrame frame = CameraFrame::turned(direction.direction(), up.direction());
  if (rules_.cameraUp == Up::turned) return frame;
  frame.up = rules_.cameraUp == Up::unit ? normalize(up.vector()) : up.vector();
  if (rules_.cameraUp != Up::unscaled) return frame;
  frame.right = cross(frame.direction, up.vector());
  frame.up = cross(frame.right, frame.direction);
  return frame;
}

void SceneReader::readLights() {
  lightsAt_ = in_.at();
  in_.advance();
  in_.readCounted({"Lights", "numLights", kLightWords, kLightWords}, [this] {
    const std::string_view owner = in_.word();
    const char* const at = in_.at();
    in_.advance();
    const Fields fields = in_.readFields(owner, {owner});
    if (fields.areGood) addLight(at, fields, nullptr);
  });
}

void SceneReader::addLight(const char* at, const Fields& fields, const Matrix* toWorld) {
  notes_.lightStarts.push_back(at);
  const Vec3f color = fields["color"].color();
  if (fields.has("direction")) {
    const Vec3d direction = fields["direction"].direction();
    scene_.lights_.push_back(std::make_unique<DirectionalLight>(
        toWorld ? toWorld->transformDirection(direction) : direction, color));
    return;
  }
  const Vec3d place = toWorld ? toWorld->transformPoint(Vec3d()) : fields["position"].vector();
  const Vec3d attenuation = fields.has("falloff")
                                ? Vec3d(rules_.nearFalloff, 0, fields["falloff"].number())
                                : fields["attenuation"].vector();
  scene_.lights_.push_back(std::make_unique<PointLight>(place, color, attenuation));
}

void SceneReader::readBackground() {
  in_.advance();
  const Fields fields = in_.readFields("Background", {"Background"});
  std::optional<CubeMap> cubeMap;
  if (const char* const folder = fields["cubeMap"].at) {
    cubeMap = pictures_.findCube(in_.fileNameAt(folder), rules_.cubeMapEnding);
  }
  scene_.background_ = Background(fields["color"].color(), cubeMap);
  scene_.ambientLight_ = fields["ambientLight"].color();
}

void SceneReader::readMaterials() {
  if (hasGroup_) {
    in_.report(in_.at(), std::string("Materials must come before ") +
                             (in_.hasNodes() ? "Scene" : "the first Group"));
  }
  in_.advance();
  materials_.readSection();
}

void SceneReader::readGroup() {
  hasGroup_ = true;
  if (const Object3D* group = objects_.read()) scene_.group_.addObject(group);
}

/// The Scene of 2020, in which objects and lights stand in nodes.
void SceneReader::readNodes() {
  hasGroup_ = true;
  lightsAt_ = in_.at();
  NodeReader nodes(in_, materials_, objects_, *this);
  if (const Object3D* scene = nodes.read()) scene_.group_.addObject(scene);
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
