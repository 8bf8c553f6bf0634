// Fuzz target: the scene reader, and small pictures of the scenes that it takes.
// The last byte chooses the options. What follows a line "@@" is a mesh that the scene can call
// m.obj. Demands: reading and checking agree on whether the scene is good; a mistake has a line of
// the file; the tree, and every instruction set, give the bytes that the plain objects give.
#include <optional>

#include "accel/compiled_scene.h"
#include "fuzz.h"
#include "image/tga.h"
#include "render/renderer.h"
#include "scene/scene_parser.h"

namespace {

constexpr int kWidth = 8, kHeight = 6;

RenderOptions optionsFrom(unsigned choice) {
  RenderOptions options;
  options.transparentShadows = (choice & 1) != 0;
  options.shadeBack = (choice & 2) != 0;
  options.maxBounces = int(choice >> 2 & 3);
  options.shadows = (choice & 16) == 0;
  if ((choice & 32) != 0) options.epsilon.kind = Epsilon::Kind::fixed;
  if ((choice & 64) != 0) options.epsilon.kind = Epsilon::Kind::adaptive;
  if ((choice & 128) != 0) options.minWeight = 0;
  return options;
}

/// The colour, depth and normal images, one after the other.
Bytes pictures(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options) {
  Image color(kWidth, kHeight), depth(kWidth, kHeight), normals(kWidth, kHeight);
  render(scene, geometry, options, 1, {&color, &depth, &normals, 0, 10});
  Bytes all;
  for (const Image* image : {&color, &depth, &normals}) {
    const Bytes bytes = encodeTga(*image);
    all.insert(all.end(), bytes.begin(), bytes.end());
  }
  return all;
}

void comparePictures(const SceneParser& scene, const RenderOptions& options) {
  const Bytes plain = pictures(scene, *scene.getGroup(), options);
  for (const SimdLevel level : {SimdLevel::baseline, SimdLevel::avx2, SimdLevel::avx512}) {
    if (availableSimd(level) != level) continue;
    const CompiledScene compiled(*scene.getGroup(), 1, level);
    fuzz::demand(pictures(scene, compiled, options) == plain,
                 std::string("the picture by ") + nameOf(level) + " is that of the plain objects");
  }
}

void checkMistake(const InputError& mistake, std::size_t lines) {
  fuzz::demand(fuzz::isPlainLine(mistake.what()), "a mistake is one line that prints");
  fuzz::demand(mistake.getLine() >= 1 && mistake.getLine() <= lines,
               std::string("a mistake has a line of the file: ") + mistake.what());
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
  const RenderOptions options = optionsFrom(data[size - 1]);
  if (options.transparentShadows) scene->findClosedMeshes();
  comparePictures(*scene, options);
  return 0;
}
