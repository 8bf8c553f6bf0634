// Fuzz target: the scene reader, and small pictures of the scenes that it takes.
// The last byte chooses the options; a scene that begins with # and a digit is of that course, in
// the order of their names. What follows a line "@@" is a mesh that the scene can call m.obj; a
// texture is called t.bmp, and a cube map sky. Demands: reading and checking agree on whether the
// scene is good; a mistake has a line of the file, but for a mesh that is no OBJ file; the tree,
// and every instruction set, give the bytes that the plain objects give.
#include <algorithm>
#include <iterator>
#include <memory>

#include "cli/course.h"
#include "fuzz.h"
#include "pictures.h"

namespace {

void checkMistake(const InputError& mistake, std::size_t lines) {
  fuzz::demand(fuzz::isPlainLine(mistake.what()), "a mistake is one line that prints");
  const std::string text = mistake.what();
  const bool isOfWholeFile = text.find("m.obj: expected an OBJ file, found what ") != text.npos;
  fuzz::demand(
      isOfWholeFile ? mistake.getLine() == 0 : mistake.getLine() >= 1 && mistake.getLine() <= lines,
      "a mistake has a line of the file: " + text);
}

std::size_t linesOf(const std::string& text) {
  std::size_t lines = 1;
  for (const char c : text) lines += c == '\n';
  return lines;
}

/// The scene, or nothing where the reader finds a mistake.
std::unique_ptr<SceneParser> read(const std::string& path, const SceneRules& rules,
                                  std::size_t lines) {
  try {
    return std::make_unique<SceneParser>(path.c_str(), nullptr, rules);
  } catch (const InputError& mistake) {
    checkMistake(mistake, lines);
    return nullptr;
  }
}

/// The digit behind the names of all courses is 2012 with bounces.
const Course& courseOf(const std::string& text) {
  constexpr std::size_t kCount = std::size(kCourseNames);
  const bool isGiven = text.size() > 1 && text[0] == '#' && text[1] >= '0' && text[1] <= '9';
  const std::size_t place = isGiven ? std::size_t(text[1] - '0') : 0;
  return place < kCount ? courseAt(place) : *courseAt(2).withBounces;
}

/// With the pictures that scenes may name.
class SceneFiles : public fuzz::Scratch {
 public:
  SceneFiles() {
    Image picture(2, 2);
    picture.setPixel(0, 0, Vec3f(1, 0.5f, 0));
    picture.setPixel(1, 1, Vec3f(0, 0.25f, 1));
    const auto encoded = [&](PictureFormat format) {
      const Bytes bytes = encodePicture(picture, format);
      return std::string(bytes.begin(), bytes.end());
    };
    write("t.bmp", encoded(PictureFormat::bmp));
    for (const char* side : {"left", "right", "up", "down", "front", "back"}) {
      write("sky/" + std::string(side) + ".png", encoded(PictureFormat::png));
    }
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const SceneFiles scratch;
  if (size == 0) return 0;
  const std::string all(data, data + size - 1);
  const std::size_t cut = all.find("\n@@\n");
  const std::string mesh = cut == std::string::npos ? "" : all.substr(cut + 4);
  scratch.write("m.obj", mesh);
  const std::string text = all.substr(0, cut);
  const std::string path = scratch.write("scene.txt", text);
  const std::size_t lines = std::max(linesOf(text), linesOf(mesh));

  const Course& course = courseOf(text);
  const std::vector<InputError> mistakes = SceneParser::check(path.c_str(), nullptr, course.scene);
  for (const InputError& mistake : mistakes) checkMistake(mistake, lines);
  const std::unique_ptr<SceneParser> scene = read(path, course.scene, lines);
  fuzz::demand((scene == nullptr) == !mistakes.empty(), "-check and reading agree");
  if (!scene) return 0;
  for (const std::string& warning : scene->getWarnings()) {
    fuzz::demand(fuzz::isPlainLine(warning), "a warning is one line that prints");
  }
  fuzz::comparePictures(*scene, fuzz::optionsFrom(data[size - 1], course.render));
  return 0;
}
