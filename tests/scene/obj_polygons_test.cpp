// OBJ files as the world has them: faces of any number of corners, line ends of any kind, and files
// that are no meshes at all.
#include <cstdio>

#include "geometry/triangle_mesh.h"
#include "scene/obj_reader.h"
#include "scene/scene_files.h"

namespace {

/// The outline around a doorway.
const std::string kDoor =
    "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n";

/// Reads a mesh as a scene's, and what is said of it: a line for each mistake or warning.
struct Reading {
  std::string said;
  std::unique_ptr<SceneParser> scene;

  explicit Reading(const std::string& text) {
    const std::string path = scenes::write("mesh.obj", text);
    const std::string file = scenes::write(
        "scene.txt", scenes::around("TriangleMesh { obj_file " + scenes::lastPart(path) + " }"));
    std::vector<std::string> warnings;
    for (const InputError& mistake : SceneParser::check(file.c_str(), &warnings)) {
      said += std::string(mistake.what()) + "\n";
    }
    for (const std::string& warning : warnings) {
      if (!scenes::contains(warning, "is not used")) said += warning + "\n";
    }
    try {
      scene = std::make_unique<SceneParser>(file.c_str());
    } catch (const InputError&) {
    }
    std::remove(path.c_str());
    std::remove(file.c_str());
  }

  bool says(const std::string& words) const { return scenes::contains(said, words); }

  /// Whether a ray along -z through (x, y) hits.
  bool isHit(double x, double y) const {
    Hit hit;
    return scene->getGroup()->intersect(Ray({x, y, 5}, {0, 0, -1}), hit, 0);
  }
};

}  // namespace

TEST("a concave face covers its own area, whichever corner it begins at") {
  for (int first = 0; first < 8; ++first) {
    std::string face = "f";
    for (int k = 0; k < 8; ++k) face += " " + std::to_string((first + k) % 8 + 1);
    const Reading door(kDoor + face + "\n");
    CHECK_EQUAL(door.said, "");
    CHECK(!door.isHit(1.5, 2) && !door.isHit(1.1, 2.9));
    CHECK(door.isHit(1.5, 0.5) && door.isHit(0.5, 2.5) && door.isHit(2.5, 2.5));
  }
}

TEST("concave faces anywhere in a file are cut, in chunks of any size") {
  std::string text;
  for (int k = 0; k < 40; ++k) {
    text += kDoor + (k % 3 == 0 ? "f -8 -7 -6 -5\n" : "f -8 -7 -6 -5 -4 -3 -2 -1\n");
  }
  const std::string path = scenes::write("doors.obj", text);
  MistakeLog log(MistakeLog::Mode::throwFirst);
  std::vector<std::string> warnings;
  const MeshGeometry whole = readObj(SourceText(path, text), log, 0, warnings);
  for (const std::size_t bytes : {std::size_t(50), std::size_t(333), std::size_t(100000)}) {
    for (const int threads : {1, 3}) {
      MeshGeometry mesh;
      CHECK(readObjFile(path, {threads, bytes}, mesh));
      CHECK(mesh.getFaces() == whole.getFaces());
    }
  }
  std::remove(path.c_str());
}

TEST("what crosses itself stays a fan, and is named once with its line") {
  const Reading bow("v 0 0 0\nv 2 3 0\nv 2 0 0\nv 0 2 0\nf 1 2 3 4\n# \nf 1 2 3 4\n");
  CHECK(
      bow.says("has 2 faces that cannot be cut into triangles rightly, as the outline crosses "
               "itself, the first in line 5"));
  CHECK_EQUAL(bow.scene->getSpan(), 3.0);
}

TEST("faces of one or two corners are left out with one warning") {
  const Reading mesh(kDoor + "f 1 2\nf 1 2 3\nf 3\nf 2 1\n");
  CHECK(mesh.says("has 3 faces of less than three corners, left out, the first in line 9"));
  CHECK(mesh.isHit(2.5, 1));
  // An index that is wrong stays a mistake.
  CHECK(Reading(kDoor + "f 1 99\n").says("out of range"));
}

TEST("a file that is no OBJ file is a mistake that says what it seems to be") {
  const struct {
    std::string text, kind;
  } cases[] = {
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n", "Git LFS pointer"},
      {"<!DOCTYPE html>\n<html>\n", "HTML page"},
      {"\n  <html>v 1 2 3\n", "HTML page"},
      {std::string("\x1f\x8b\x08\x00\n", 5), "gzip file"},
      {std::string("\xff\xfev\0 \0", 6), "UTF-16"},
      {std::string("v\0 \0001\0 \0", 8), "UTF-16"},
      {std::string("\0\0\0\1abc", 7), "binary file"},
      {"ply\nformat ascii 1.0\n", "PLY file"},
      {"solid cube\n facet normal 0 0 1\n", "STL file"},
  };
  for (const auto& [text, kind] : cases) {
    const Reading file(text);
    CHECK(file.says("expected an OBJ file, found what looks like "));
    CHECK(file.says(kind));
    CHECK(!file.scene);
  }
  // Vertices without faces, and nothing at all, stay warnings.
  for (const std::string& text : {kDoor, std::string(), std::string("# nothing\n")}) {
    const Reading file(text);
    CHECK(file.says("has no faces"));
    CHECK(file.scene != nullptr);
  }
}

TEST("lines may end in CR alone") {
  std::string text = kDoor + "f 1 2 3 4 5 6 7 8\n";
  for (char& c : text) c = c == '\n' ? '\r' : c;
  const Reading door(text);
  CHECK_EQUAL(door.said, "");
  CHECK(door.isHit(0.5, 2.5) && !door.isHit(1.5, 2));
  CHECK(Reading(text + "f 1 2 77\r").says(":10: face index out of range"));
}

TEST("a face of 10,000 corners on one line takes less than a second") {
  std::string text, face = "f";
  for (int k = 0; k < 10000; ++k) {
    const bool isTop = k >= 5000;
    const int x = isTop ? 9999 - k : k;
    text += "v " + std::to_string(x) + " " + std::to_string((x % 2) + (isTop ? 1.5 : 0)) + " 0\n";
    face += " " + std::to_string(k + 1);
  }
  const Reading comb(text + face + "\n");
  CHECK_EQUAL(comb.said, "");
  CHECK(comb.isHit(100, 0.7) && !comb.isHit(101, 0.7) && comb.isHit(101, 1.2));
}

TEST("a mesh whose name has blanks stands in quotes, and without them the message says so") {
  const std::string path = scenes::write("a \"b\" c.obj", kDoor + "f 1 2 3\n");
  std::string name = scenes::lastPart(path), escaped;
  for (const char c : name) escaped += c == '"' ? std::string("\\\"") : std::string(1, c);
  const auto scene = scenes::parse(scenes::around("TriangleMesh { obj_file \"" + escaped + "\" }"));
  CHECK_EQUAL(scene->getSpan(), 3.0);
  CHECK_MISTAKE(scenes::around("TriangleMesh { obj_file Stanford Bunny.obj }"), 5, "in quotes");
  CHECK_MISTAKE(scenes::around("TriangleMesh { obj_file \"Stanford Bunny.obj }"), 5, "ends in");
  std::remove(path.c_str());
}

TEST("a scene in UTF-16 is said to be that") {
  std::string wide = "\xff\xfe";
  for (const char c : scenes::around("")) wide += std::string(1, c) + '\0';
  CHECK_MISTAKE(wide, 1, "UTF-16");
}
