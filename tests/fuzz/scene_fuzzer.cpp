// Fuzz target: the scene reader, and small pictures of the scenes that it takes.
// The last byte chooses the options. What follows a line "@@" is a mesh that the scene can call
// m.obj. Demands: reading and checking agree on whether the scene is good; a mistake has a line of
// the file, but for a mesh that is no OBJ file; the tree, and every instruction set, give the bytes
// that the plain objects give.
#include <algorithm>
#include <memory>

#include "fuzz.h"
#include "pictures.h"

namespace {

void checkMistake(const InputError& mistake, std::size_t lines) {
  fuzz::demand(fuzz::isPlainLine(mistake.what()), "a mistake is one line that prints");
  const std::string text = mistake.what();
  const bool isOfWholeFile = text.find("m.obj: expected an OBJ file, found what ") != text.npos;
  fuzz::demand(isOfWholeFile ? mistake.getLine() == 0
                             : mistake.getLine() >= 1 && mistake.getLine() <= lines,
               "a mistake has a line of the file: " + text);
}

std::size_t linesOf(const std::string& text) {
  std::size_t lines = 1;
  for (const char c : text) lines += c == '\n';
  return lines;
}

/// The scene, or nothing where the reader finds a mistake.
std::unique_ptr<SceneParser> read(const std::string& path, std::size_t lines) {
  try {
    return std::make_unique<SceneParser>(path.c_str());
  } catch (const InputError& mistake) {
    checkMistake(mistake, lines);
    return nullptr;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Scratch scratch;
  if (size == 0) return 0;
  const std::string all(data, data + size - 1);
  const std::size_t cut = all.find("\n@@\n");
  const std::string mesh = cut == std::string::npos ? "" : all.substr(cut + 4);
  scratch.write("m.obj", mesh);
  const std::string text = all.substr(0, cut);
  const std::string path = scratch.write("scene.txt", text);
  const std::size_t lines = std::max(linesOf(text), linesOf(mesh));

  const std::vector<InputError> mistakes = SceneParser::check(path.c_str());
  for (const InputError& mistake : mistakes) checkMistake(mistake, lines);
  const std::unique_ptr<SceneParser> scene = read(path, lines);
  fuzz::demand((scene == nullptr) == !mistakes.empty(), "-check and reading agree");
  if (!scene) return 0;
  for (const std::string& warning : scene->getWarnings()) {
    fuzz::demand(fuzz::isPlainLine(warning), "a warning is one line that prints");
  }
  fuzz::comparePictures(*scene, fuzz::optionsFrom(data[size - 1]));
  return 0;
}
