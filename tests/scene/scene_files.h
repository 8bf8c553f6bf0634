// Scene and mesh files for tests: written to the temporary folder, read back as scenes or mistakes.
#pragma once
#include <unistd.h>

#include <fstream>
#include <memory>
#include <string>

#include "check.h"
#include "scene/scene_parser.h"

namespace scenes {

/// A camera, a light and two materials on lines 1 to 3, so that what follows starts on line 4.
inline const std::string kStart =
    "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 30 }\n"
    "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 1 1 } }\n"
    "Materials { numMaterials 2 PhongMaterial { } Material { diffuseColor 1 0 0 } }\n";

/// The same with a Group around `objects`, which start on line 5.
inline std::string around(const std::string& objects, int count = 1) {
  return kStart + "Group { numObjects " + std::to_string(count) + " MaterialIndex 0\n" + objects +
         "\n}\n";
}

/// Writes a file of this process alone and returns its path.
inline std::string write(const std::string& name, const std::string& text) {
  const std::string path = check::temporaryFolder() + "/" + std::to_string(getpid()) + "_" + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}
/// What of a path stands behind its last slash.
inline std::string lastPart(const std::string& path) { return path.substr(path.rfind('/') + 1); }

inline std::unique_ptr<SceneParser> parse(const std::string& text) {
  const std::string path = write("scene.txt", text);
  auto scene = std::make_unique<SceneParser>(path.c_str());
  std::remove(path.c_str());
  return scene;
}

/// What the constructor says of `text`: "LINE: message" with the file's name left out, or "none".
inline std::string mistakeIn(const std::string& text) {
  const std::string path = write("scene.txt", text);
  std::string result = "none";
  try {
    const SceneParser scene(path.c_str());
  } catch (const InputError& mistake) {
    result = std::string(mistake.what()).substr(mistake.getFile().size() + 1);
  }
  std::remove(path.c_str());
  return result;
}

/// All that check() says, in the same form, one a line.
inline std::string mistakesIn(const std::string& text) {
  const std::string path = write("scene.txt", text);
  std::string result;
  for (const InputError& mistake : SceneParser::check(path.c_str())) {
    result += std::string(mistake.what()).substr(mistake.getFile().size() + 1) + "\n";
  }
  std::remove(path.c_str());
  return result;
}

inline bool contains(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

/// Checks that the mistake in `text` stands on `line` and that its message holds `piece`.
inline void expectMistake(const std::string& text, int line, const std::string& piece,
                          const char* file, int testLine) {
  const std::string mistake = mistakeIn(text);
  const bool isRight =
      mistake.rfind(std::to_string(line) + ": ", 0) == 0 && contains(mistake, piece);
  check::report(isRight, file, testLine,
                "expected line " + std::to_string(line) + " and \"" + piece + "\", found \"" +
                    mistake + "\" for:\n" + text.substr(0, 2000));
}

}  // namespace scenes

#define CHECK_MISTAKE(text, line, piece) \
  scenes::expectMistake((text), (line), (piece), __FILE__, __LINE__)
