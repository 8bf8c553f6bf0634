// What OBJ files tell of corners: vt, vn, the references of faces to them, and smooth normals.
#include "geometry/triangle_mesh.h"
#include "random.h"
#include "scene/obj_reader.h"
#include "scene/scene_files.h"
#include "vectors.h"

namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
constexpr ObjDetails kAll = {true, true};

MeshGeometry read(const std::string& text, const ObjDetails& details = kAll) {
  MistakeLog log(MistakeLog::Mode::throwFirst);
  std::vector<std::string> warnings;
  return readObj(SourceText("m.obj", text), log, 0, warnings, details);
}

std::string mistake(const std::string& text, const ObjDetails& details = kAll) {
  try {
    read(text, details);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

/// "0 1 2, 0 2 -", where a corner that refers to nothing is "-".
std::string shown(const std::vector<MeshShading::Face>& faces) {
  std::string text;
  for (const MeshShading::Face& face : faces) {
    text += text.empty() ? "" : ",";
    for (const std::uint32_t k : face) {
      text += (text.empty() ? "" : " ") + (k == MeshShading::kNone ? "-" : std::to_string(k));
    }
  }
  return text;
}

/// The nearest hit of a ray along -z through (x, y).
Hit hitAt(const Object3D& object, double x, double y) {
  Hit hit;
  CHECK(object.intersect(Ray({x, y, 5}, {0, 0, -1}), hit, 0));
  return hit;
}

/// The scene of one mesh, read by `rules`.
std::unique_ptr<SceneParser> sceneOf(const std::string& mesh, const SceneRules& rules) {
  const std::string path = scenes::write("mesh.obj", mesh);
  const std::string file = scenes::write(
      "scene.txt", scenes::around("TriangleMesh { obj_file " + scenes::lastPart(path) + " }"));
  auto scene = std::make_unique<SceneParser>(file.c_str(), nullptr, rules);
  std::remove(path.c_str());
  std::remove(file.c_str());
  return scene;
}

}  // namespace

TEST("the corners of a face refer to coordinates and normals in every form") {
  const std::string text = kSquare +
                           "vt 0.5 0.25\nvt 1 0 7\nvt 2\nvn 1 2 3\nvn 0 0 1\n"
                           "f 1/3/1 2/1/2 3/2/2\nf 1/2 2//1 3\nf 1/-1/-2 2/-3/-1 3/-2/+1\n";
  const MeshShading shading = read(text).getShading();
  CHECK_EQUAL(shown(shading.coordinateFaces), "2 0 1, 1 - -, 2 0 1");
  CHECK_EQUAL(shown(shading.normalFaces), "0 1 1, - 0 -, 0 1 0");
  CHECK_EQUAL(shading.coordinates.size(), 3u);
  CHECK_EQUAL(shading.coordinates[0].x(), 0.5f);
  CHECK_EQUAL(shading.coordinates[0].y(), 0.25f);
  CHECK_EQUAL(shading.coordinates[2].y(), 0.0f);
  CHECK(shading.normals == (std::vector<Vec3f>{{1, 2, 3}, {0, 0, 1}}));
}

TEST("only what is wanted is kept, and nothing of a file that has none") {
  const std::string text = kSquare + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n";
  CHECK(read(text, {}).getShading().isEmpty());
  CHECK(read(text, {true, false}).getShading().normalFaces.empty());
  CHECK(read(text, {false, true}).getShading().coordinateFaces.empty());
  const MeshGeometry bare = read(kSquare + "f 1 2 3\n");
  const MeshShading& none = bare.getShading();
  CHECK(none.isEmpty() && none.coordinateFaces.empty() && none.normalFaces.empty());
}

TEST("faces of more corners are cut with all that their corners have, concave ones too") {
  // A doorway in a picture of 3 x 3: wherever it is hit, (u, v) is (x, y) / 3.
  std::string text;
  for (const char* const place : {"0 0", "3 0", "3 3", "2 3", "2 1", "1 1", "1 3", "0 3"}) {
    text += std::string("v ") + place + " 0\n";
  }
  for (int k = 7; k >= 0; --k) {  // in the opposite order
    const double x[] = {0, 3, 3, 2, 2, 1, 1, 0}, y[] = {0, 0, 3, 3, 1, 1, 3, 3};
    text += "vt " + std::to_string(x[k] / 3) + " " + std::to_string(y[k] / 3) + "\n";
    text += "vn " + std::to_string(x[k]) + " " + std::to_string(y[k]) + " 1\n";
  }
  for (int first = 0; first < 8; ++first) {
    std::string face = "f";
    for (int k = 0; k < 8; ++k) {
      const int corner = (first + k) % 8, other = 8 - corner;
      face += " " + std::to_string(corner + 1) + "/" + std::to_string(other) + "/" +
              std::to_string(other);
    }
    const MeshGeometry geometry = read(text + face + "\n");
    const TriangleMesh door(&geometry, nullptr);
    Random random(std::uint64_t(first + 1));
    for (int i = 0; i < 100; ++i) {
      const double x = random.uniform(0, 3), y = random.uniform(0, x > 1 && x < 2 ? 1 : 3);
      const Hit hit = hitAt(door, x, y);
      CHECK_NEAR(hit.getTextureCoordinates().x(), x / 3, 1e-6);
      CHECK_NEAR(hit.getTextureCoordinates().y(), y / 3, 1e-6);
      CHECK_NEAR_VECTOR(hit.getNormal(), normalize(Vec3d(x, y, 1)), 1e-6);
    }
  }
}

TEST("mistakes in what is wanted are told with their line, and no others") {
  const struct {
    std::string text;
    int line;
    std::string piece;
  } kMistakes[] = {
      {"vt\nf 1 2 3\n", 5, "expected one or two numbers for a texture coordinate, found 0"},
      {"vt 1 x\n", 5, "expected a number for a texture coordinate, found 'x'"},
      {"vn 1 2\n", 5, "expected three numbers for a normal, found 2"},
      {"vn 1 2 1e40\n", 5, "within float range for a normal"},
      {"vt 0 0\nf 1/2 2/1 3/1\n", 6,
       "texture index out of range: there is 1 texture coordinate, found '1/2'"},
      {"vt 0 0\nf 1/1 2/0 3/1\n", 6, "texture index 0: expected indices that count from 1"},
      {"vt 0 0\nf 1/1 2/-2 3/1\n", 6, "there is 1 texture coordinate before it, found '2/-2'"},
      {"f 1//1 2//1 3//2\nvn 0 0 1\n", 5, "normal index out of range: there is 1 normal, found"},
      {"f 1/--1 2 3\n", 5, "expected a texture index for a face, found '1/--1'"},
      {"f 1/99999999999 2 3\n", 5, "expected a texture index for a face"},
  };
  for (const auto& each : kMistakes) {
    const std::string found = mistake(kSquare + each.text);
    const bool isRight = found.rfind("m.obj:" + std::to_string(each.line) + ": ", 0) == 0 &&
                         scenes::contains(found, each.piece);
    check::report(isRight, __FILE__, __LINE__, found + " for:\n" + each.text);
    CHECK_EQUAL(mistake(kSquare + each.text, {}), "none");
  }
}

TEST("a scene's rules tell what meshes keep, and which stay flat") {
  // Two squares at right angles, which share the edge x = 1.
  const std::string mesh = kSquare +
                           "v 1 0 -1\nv 1 1 -1\nvt 0.5 0.75\nvn 1 0 0\n"
                           "f 1/1/1 2/1 3/1 4/1/1\nf 2 5 6 3\n";
  const auto hitBy = [&](const SceneRules& rules, double x) {
    return hitAt(*sceneOf(mesh, rules)->getGroup(), x, 0.5);
  };
  SceneRules rules;
  CHECK_EQUAL(hitBy(rules, 0.5).getNormal(), Vec3d(0, 0, 1));
  CHECK_EQUAL(hitBy(rules, 0.5).getTextureCoordinates().y(), 0.0);
  rules.keepsTextureCoordinates = true;
  CHECK_NEAR(hitBy(rules, 0.5).getTextureCoordinates().y(), 0.75, 1e-15);
  // On the edge, where two triangles of each square end, all kinds of mean are the same; at x = 0
  // there is one square alone.
  rules.meshNormals = MeshNormals::byArea;
  CHECK_NEAR_VECTOR(hitBy(rules, 0).getNormal(), Vec3d(0, 0, 1), 1e-7);
  CHECK(hitBy(rules, 0.75).getNormal().x() > 0.3);
  rules.mostFlatVertices = 6;
  CHECK_EQUAL(hitBy(rules, 0.75).getNormal(), Vec3d(0, 0, 1));
  rules.mostFlatVertices = 5;
  CHECK(hitBy(rules, 0.75).getNormal().x() > 0.3);
  rules.usesFileNormals = true;
  CHECK_NEAR_VECTOR(hitBy(rules, 0).getNormal(), Vec3d(1, 0, 0), 1e-7);
}
