// SceneParser: reading from outside, and questions about the scene as a whole.
//
// Reading to render and reading to check are one path, SceneReader: for the one its log throws the
// first mistake, for the other it collects them. What a scene does not keep (where things stand in
// its text) is gone when the reader is.
#include "scene/scene_parser.h"

#include <set>

#include "scene/input_error.h"
#include "scene/number_reader.h"
#include "scene/scene_reader.h"
#include "scene/source_text.h"

SceneParser::SceneParser(const char* filename, ObjectPlaces* places, const SceneRules& rules)
    : SceneParser(SourceText::read(filename), places, rules) {}

SceneParser::SceneParser(const SourceText& text, ObjectPlaces* places, const SceneRules& rules) {
  MistakeLog log(MistakeLog::Mode::throwFirst);
  if (places) *places = ObjectPlaces(text.name(), text.bytes().data());
  SceneReader(text, log, *this, places, rules).read();
}

SceneParser::~SceneParser() = default;

std::vector<InputError> SceneParser::check(const char* filename, std::vector<std::string>* warnings,
                                           const SceneRules& rules) {
  MistakeLog log(MistakeLog::Mode::collect);
  try {
    const SourceText text = SourceText::read(filename);
    SceneParser scene;
    SceneReader(text, log, scene, nullptr, rules).read();
    if (warnings && log.count() == 0) *warnings = scene.getWarnings();
  } catch (const InputError& unreadable) {
    return {unreadable};
  } catch (const MistakeLog::Full&) {
    // There are more, but those found are enough to go on with.
  }
  return log.inOrder();
}

std::size_t SceneParser::getPictureBytes() const {
  std::size_t bytes = 0;
  for (const auto& picture : pictures_) bytes += picture->byteCount();
  return bytes;
}

bool SceneParser::hasGlass(const SourceText& text) {
  Tokenizer words(text.bytes());
  double index = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    const bool isIndex = isWord(word, "refractionIndex");
    if (isIndex && readNumber(words.next(), index) && index != 0) return true;
  }
  return false;
}

double SceneParser::getSpan() const {
  BoundingBox box;
  group_.addBounds(Matrix(), box);
  return box.longestSide();
}

void SceneParser::findSolids() {
  std::set<const MeshGeometry*> wanted;
  visitTransparent(group_, Matrix(), [&](const Object3D&, const MeshGeometry* mesh, const Matrix&) {
    wanted.insert(mesh);
  });
  for (const auto& mesh : meshes_) {
    if (wanted.count(mesh.get()) > 0) mesh->findWhetherClosed();
  }
  solids_.emplace(group_);
}
