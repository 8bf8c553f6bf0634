// OBJ meshes: statements, indices, mistakes with their lines, and where the files are found.
#include "scene/obj_reader.h"

#include <sys/stat.h>

#include <filesystem>
#include <sstream>

#include "geometry/triangle_mesh.h"
#include "scene/scene_files.h"

namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

MeshGeometry read(const std::string& text) {
  MistakeLog log(MistakeLog::Mode::throwFirst);
  std::vector<std::string> warnings;
  return readObj(SourceText("m.obj", text), log, 0, warnings);
}

/// The faces of `text`, as "0 1 2, 0 2 3".
std::string faces(const std::string& text) {
  std::ostringstream out;
  const MeshGeometry mesh = read(text);
  for (const MeshGeometry::Face& face : mesh.getFaces()) {
    out << (out.tellp() > 0 ? ", " : "") << face[0] << ' ' << face[1] << ' ' << face[2];
  }
  return out.str();
}

std::string mistake(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

void expectMistake(const std::string& text, int line, const std::string& piece, int testLine) {
  const std::string found = mistake(text);
  const bool isRight =
      found.rfind("m.obj:" + std::to_string(line) + ": ", 0) == 0 && scenes::contains(found, piece);
  check::report(isRight, __FILE__, testLine, found + " for:\n" + text);
}

/// `name` must hold no white space: meshes are looked up beside the scene, so a file's own name
/// will do wherever the tests run.
std::string mesh(const std::string& name) { return "TriangleMesh { obj_file " + name + " }"; }

}  // namespace

TEST("vertices and faces in every form are read") {
  CHECK_EQUAL(faces(kSquare + "f 1 2 3\nf 1/9 2/9 4/9\nf 2//7 3//7 4//7\nf 1/5/6 3/5/6 4/5/6"),
              "0 1 2, 0 1 3, 1 2 3, 0 2 3");
  CHECK_EQUAL(faces(kSquare + "f -4 -3/-1 -2//-1\n"), "0 1 2");
  CHECK_EQUAL(faces("f 1 2 3\n" + kSquare), "0 1 2");
  CHECK_EQUAL(faces("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\nf -3 -2 -1"), "0 1 2, 1 2 3");
}

TEST("a face of more corners becomes a fan around its first") {
  CHECK_EQUAL(faces(kSquare + "v -1 0.5 0\nf 2 3 4 5 1\n"), "1 2 3, 1 3 4, 1 4 0");
}

TEST("vertex numbers are the nearest floats, and further numbers do not matter") {
  const MeshGeometry mesh =
      read("\xEF\xBB\xBFv 0.1 -2e-3 +.5 1.0\nv 1 2 3 0.5 0.5 0.5 # red\n\tv\t1e-60 16777217 5.\n");
  CHECK_EQUAL(mesh.getVertices().size(), 3u);
  CHECK(mesh.getVertices()[0] == Vec3f(0.1f, -2e-3f, 0.5f));
  CHECK(mesh.getVertices()[1] == Vec3f(1, 2, 3));
  CHECK(mesh.getVertices()[2] == Vec3f(0, 16777216, 5));
}

TEST("other statements, comments and CRLF are passed over, and lines continue behind a backslash") {
  CHECK_EQUAL(
      faces(
          "# f 9 9 9 \\\r\nf 1 1 1\nmtllib a b\r\nvn 1 2\r\nvt 3\r\nvp x\r\nfoo \\\r\nf 9 9 9\r\n" +
          kSquare + "usemtl x\r\nf 1 \\\r\n 2 \\\n3\r\n\r\n  f 1\\\n2 4 # f\r\nfo 1\nf 1 3 4 \\"),
      "0 0 0, 0 1 2, 0 1 3, 0 2 3");
}

TEST("mistakes in a mesh name its line and the word") {
  expectMistake(kSquare + "f 1 2 0\n", 5, "'0'", __LINE__);
  expectMistake(kSquare + "\n\nf 1 2 5\n", 7, "'5'", __LINE__);
  expectMistake(kSquare + "f 1 2 1000000000\n", 5, "'1000000000'", __LINE__);
  expectMistake(kSquare + "f 1 2 18446744073709551617\n", 5, "'18446744073709551617'", __LINE__);
  expectMistake(kSquare + "f -5 2 3\n", 5, "'-5'", __LINE__);
  expectMistake("v 0 0 0\nf -2 1 1\nv 0 0 0\n", 2, "'-2'", __LINE__);
  expectMistake(kSquare + "f\n", 5, "found 0", __LINE__);
  expectMistake(kSquare + "f 1.5 2 3\n", 5, "'1.5'", __LINE__);
  expectMistake(kSquare + "f 1 b 3\n", 5, "'b'", __LINE__);
  expectMistake(kSquare + "f 1 /2 3\n", 5, "'/2'", __LINE__);
  expectMistake(kSquare + "f 1 2 3/1/1/1\n", 5, "'3/1/1/1'", __LINE__);
  expectMistake(kSquare + "f 1 2 \\\n x\n", 6, "'x'", __LINE__);
  expectMistake("v 0 0\n", 1, "found 2", __LINE__);
  expectMistake("\nv", 2, "found 0", __LINE__);
  expectMistake("v 0 0 zero\n", 1, "'zero'", __LINE__);
  expectMistake("v 0 nan 0\n", 1, "'nan'", __LINE__);
  expectMistake("v 0 0 1e39\n", 1, "'1e39'", __LINE__);
}

TEST("all mistakes of a mesh are collected") {
  MistakeLog log(MistakeLog::Mode::collect);
  std::vector<std::string> warnings;
  readObj(SourceText("m.obj", kSquare + "f\nf 0 1 2\nv 1\nf 1 2 5\nf 1 2 6\n"), log, 7, warnings);
  std::string lines;
  for (const InputError& found : log.inOrder()) lines += std::to_string(found.getLine()) + " ";
  CHECK_EQUAL(lines, "5 6 7 9 ");
}

TEST("every prefix of a mesh is read or refused cleanly") {
  const std::string text = kSquare + "f 1/1/1 2//2 \\\r\n -2/3 4\r\n# end\nv 1 2 3 4";
  int good = 0;
  for (std::size_t size = 0; size <= text.size(); ++size) {
    good += mistake(text.substr(0, size)) == "none";
  }
  CHECK(good > 10 && good < int(text.size()));
}

TEST("a mesh is found beside the scene, and by its name alone; the same file is read once") {
  const std::string name =
      scenes::lastPart(scenes::write("mesh.obj", kSquare + "f 1 2 3\nf 1 3 4"));
  const auto scene = scenes::parse(scenes::around(
      mesh(name) + mesh("./" + name) + mesh("gone\\away\\" + name) + mesh("C:/gone/" + name), 4));
  CHECK_EQUAL(scene->getSpan(), 1.0);
  const auto* group = dynamic_cast<const Group*>(scene->getGroup()->getObjects()[0]);
  CHECK_EQUAL(group->getGroupSize(), 4);
  const auto* first = dynamic_cast<const TriangleMesh*>(group->getObjects()[0]);
  CHECK_EQUAL(first->getGeometry().faceCount(), 2u);
  for (const Object3D* object : group->getObjects()) {
    CHECK(&dynamic_cast<const TriangleMesh*>(object)->getGeometry() == &first->getGeometry());
  }
}

TEST("a mesh is found in the current folder, behind the one beside the scene") {
  const std::string name = scenes::lastPart(scenes::write("here.obj", kSquare + "f 1 2 3"));
  const std::filesystem::path before = std::filesystem::current_path();
  const std::filesystem::path folder = check::temporaryFolder();
  std::filesystem::create_directories(folder / "inner");
  const std::string scenePath = (folder / "inner" / ("s" + name + ".txt")).string();
  std::ofstream(scenePath) << scenes::around(mesh(name));
  std::filesystem::current_path(folder);
  CHECK(SceneParser::check(scenePath.c_str()).empty());
  std::filesystem::current_path(before);
  CHECK_EQUAL(SceneParser::check(scenePath.c_str()).size(), 1u);
  // A mesh with a mistake beside the scene is taken before the good one in the current folder.
  std::ofstream((folder / "inner" / name).string()) << "f 1 2 3\n";
  std::filesystem::current_path(folder);
  CHECK_EQUAL(SceneParser::check(scenePath.c_str()).size(), 1u);
  std::filesystem::current_path(before);
}

TEST("a mesh that cannot be read is a mistake of the scene's line that names it") {
  CHECK_MISTAKE(scenes::around("\n" + mesh("no/such.obj")), 6, "'no/such.obj'");
  CHECK_MISTAKE(scenes::around(mesh("no/such.obj")), 5, "No such file");
  CHECK_MISTAKE(scenes::around(mesh(".")), 5, "folder");
  CHECK_MISTAKE(scenes::around(mesh(std::string(100'000, 'x'))), 5, "xxx...'");
  CHECK_MISTAKE(scenes::around(mesh(std::string("a\0b", 3))), 5, "'a\\x00b'");
  CHECK_MISTAKE(scenes::around("TriangleMesh { obj_file }"), 5, "'}'");
  CHECK_MISTAKE(scenes::around("TriangleMesh { }"), 5, "obj_file");
}

TEST("a mistake inside a mesh names the mesh, once however often it is used") {
  const std::string path = scenes::write("bad.obj", "\nf 1 2 3\n");
  const std::string scene =
      scenes::around(mesh(scenes::lastPart(path)) + mesh(scenes::lastPart(path)), 2);
  CHECK_EQUAL(scenes::mistakesIn(scene).find("2: face index out of range"), 0u);
  const std::string scenePath = scenes::write("scene.txt", scene);
  const std::vector<InputError> mistakes = SceneParser::check(scenePath.c_str());
  CHECK_EQUAL(mistakes.size(), 1u);
  for (const InputError& found : mistakes) CHECK_EQUAL(found.getFile(), path);
}

TEST("an endless device is no mesh, and a mesh may be a pipe") {
  CHECK_MISTAKE(scenes::around(mesh("/dev/zero")), 5, "/dev/zero");
  CHECK_MISTAKE(scenes::around(mesh("/dev/null") + "x"), 5, "'x'");
}

TEST("meshes without faces, and faces without area, are warned of once") {
  const std::string empty = scenes::lastPart(scenes::write("empty.obj", ""));
  const std::string flat =
      scenes::lastPart(scenes::write("flat.obj", kSquare + "f 1 2 3\nf 1 1 2\nf 2 2 3\n"));
  const auto scene =
      scenes::parse(scenes::around(mesh(empty) + "\n" + mesh(flat) + mesh(flat) + mesh(empty), 4));
  CHECK_EQUAL(scene->getWarnings().size(), 3u);  // the first is of a material that is not used
  CHECK(scenes::contains(scene->getWarnings()[1], ":5: the mesh"));
  CHECK(scenes::contains(scene->getWarnings()[1], "no faces"));
  CHECK(scenes::contains(scene->getWarnings()[2], ":6: the mesh"));
  CHECK(scenes::contains(scene->getWarnings()[2], "2 triangles without area"));
}

TEST("a warning names the whole file of a mesh, blanks in it too") {
  const std::string quoted = '"' + scenes::lastPart(scenes::write("no faces.obj", "")) + '"';
  const auto scene = scenes::parse(scenes::around(mesh(quoted), 1));
  CHECK(scenes::contains(scene->getWarnings().at(1), "the mesh '" + quoted + "' has no faces"));
}

TEST("only meshes of transparent material are asked whether they are closed") {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const std::string clear = scenes::lastPart(scenes::write("clear.obj", text)),
                    solid = scenes::lastPart(scenes::write("solid.obj", text));
  const auto scene = scenes::parse(scenes::around(
      "Material { transparentColor 0 0 .1 }" + mesh(clear) + "MaterialIndex 1" + "\n" + mesh(solid),
      2));
  const auto* group = dynamic_cast<const Group*>(scene->getGroup()->getObjects()[0]);
  const auto isClosed = [&](std::size_t i) {
    return dynamic_cast<const TriangleMesh*>(group->getObjects()[i])->getGeometry().isClosed();
  };
  CHECK(!isClosed(0) && !isClosed(1));
  scene->findSolids();
  CHECK(isClosed(0) && !isClosed(1));
}
