// Reading OBJ files in chunks by many threads gives what reading them as one text does.
#include <cstdio>
#include <sstream>

#include "random.h"
#include "scene/obj_reader.h"
#include "scene/scene_files.h"
#include "system/files.h"

namespace {

std::string shown(const MeshGeometry& mesh) {
  std::ostringstream out;
  const Vec3d& origin = mesh.getOrigin();
  out << std::hexfloat << origin.x() << ' ' << origin.y() << ' ' << origin.z() << '\n';
  for (const Vec3f& v : mesh.getVertices()) {
    out << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  }
  for (const MeshGeometry::Face& face : mesh.getFaces()) {
    out << face[0] << ' ' << face[1] << ' ' << face[2] << '\n';
  }
  return out.str();
}

/// The mesh that the text is as a whole, or "mistake".
std::string asOne(const std::string& text, std::vector<std::string>& warnings) {
  MistakeLog log(MistakeLog::Mode::throwFirst);
  try {
    return shown(readObj(SourceText("m.obj", text), log, 0, warnings));
  } catch (const InputError&) {
    return "mistake";
  }
}

std::string inChunks(const std::string& path, int threads, std::size_t chunkBytes) {
  MeshGeometry mesh;
  return readObjFile(path, {threads, chunkBytes}, mesh) ? shown(mesh) : "mistake";
}

/// Checks `text` with chunks of many sizes; true where it is a mesh. One that is to be warned of is
/// not read in chunks.
bool checkChunks(const std::string& text) {
  const std::string path = scenes::write("chunks.obj", text);
  std::vector<std::string> warnings;
  const std::string whole = asOne(text, warnings);
  const std::string expected = warnings.empty() ? whole : "mistake";
  for (const int threads : {1, 3}) {
    for (const std::size_t chunkBytes : {1u, 2u, 5u, 16u, 61u, 100'000u}) {
      const std::string found = inChunks(path, threads, chunkBytes);
      if (found == expected) continue;
      check::report(false, __FILE__, __LINE__,
                    std::to_string(chunkBytes) + " bytes, " + std::to_string(threads) +
                        " threads: found\n" + found + "expected\n" + expected + "for\n" + text);
    }
  }
  std::remove(path.c_str());
  return whole != "mistake";
}

/// Statements of every kind, most of them good, with line ends and continuations everywhere.
std::string randomMesh(Random& random, int rareness) {
  static const char* const kGood[] = {"v 0 1 2",         "v .5 -1e-3 7",
                                      "f 1 2 3",         "f -1 -2 -3",
                                      "f -1 -2 -3 1 -4", "f 1/2/3 2//1 3/1 4",
                                      "f 4 3\\\n 2",     "v 1 \\\r\n2 3",
                                      "# c \\",          "vn 1 2 3",
                                      "g x \\",          "f -3/1 -2 -1",
                                      " \tv 3 2 1",      "",
                                      "o # f 1"};
  static const char* const kPlain[] = {"v 1.5 -22.25 333.125",
                                       "v 0.123456789 -7. +.5",
                                       "v 1234567.5 12345678 0.12345678901234567890",
                                       "v 1e3 2.5E-1 -0",
                                       "v 0.1 16777217 0.3 0.7 0.9",
                                       "v\t1 2 3",
                                       "v  1.5  2.5  3.5 ",
                                       "f 1 2 3 ",
                                       "f  4 2 1",
                                       "f 1/12345678/1 2/1/12345678 3",
                                       "f 1/ 2// 3/1/",
                                       "f 0000001 00000002 3",
                                       "f 4//4 3//3 2//2",
                                       "f 1 2 3 4 1 2",
                                       "f 1 +2 3",
                                       "f 1 2 3 # 4"};
  static const char* const kBad[] = {
      "f 1 2",      "f 0 1 2",       "f 99 1 2",         "f -99 1 2",
      "v 1 2",      "v x y",         "f 1 2/a 3",        "\\",
      "\\ x",       "f 1 2 3/1/1/1", "f 1 2 4294967298", "f 1 2 30000000",
      "v 1 2 3x",   "f 1 2 3.",      "v 1 2 1e",         "f 1 2 3/1/1x",
      "v 1e99 1 2", "f 1 2 3 0",     "f 1 0 2",          "f 2 1 0"};
  std::string text = random.index(4) == 0 ? "\xEF\xBB\xBF" : "";
  text += "v 1 2 3\nv 4 5 6\nv 7 8 9\nv 1 1 1\n";
  const int count = random.index(30);
  for (int i = 0; i < count; ++i) {
    const bool isBad = random.index(rareness) == 0;
    const bool isPlain = random.index(2) == 0;
    text += isBad     ? kBad[random.index(20)]
            : isPlain ? kPlain[random.index(16)]
                      : kGood[random.index(15)];
    text += random.index(5) == 0 ? "\r\n" : i + 1 == count && random.index(2) == 0 ? "" : "\n";
  }
  // Plain statements are read at a stretch where much text stands behind them, never in chunks of
  // a few bytes.
  return random.index(4) == 0 ? text : text + "\n# " + std::string(150, '1') + "\n";
}

}  // namespace

TEST("random meshes come out the same in chunks of any size and by any number of threads") {
  Random random(31);
  int good = 0, bad = 0;
  for (int i = 0; i < 600; ++i) {
    (checkChunks(randomMesh(random, i % 2 == 0 ? 1'000'000 : 10)) ? good : bad)++;
  }
  CHECK(good > 300);
  CHECK(bad > 150);
}

TEST("random bytes come out the same in chunks of any size and by any number of threads") {
  Random random(32);
  const std::string letters = "vf\n\n\r\\# 123-/.";
  int good = 0;
  for (int i = 0; i < 600; ++i) {
    std::string text;
    for (int size = random.index(40); size > 0; --size) {
      text += letters[std::size_t(random.index(int(letters.size())))];
    }
    good += checkChunks(text);
  }
  CHECK(good > 40);
}

TEST("indices that count backwards reach over chunks, and no further than the start") {
  // Ten vertices and faces by turns: face i counts back to vertices i - 2, i - 1 and i.
  std::string text = "v 0 0 0\nv 0 0 1\n", expected;
  for (int i = 2; i < 10; ++i) text += "v 0 0 " + std::to_string(i) + "\nf -3 -2 -1\n";
  for (int i = 2; i < 10; ++i) {
    expected +=
        std::to_string(i - 2) + ' ' + std::to_string(i - 1) + ' ' + std::to_string(i) + '\n';
  }
  const std::string path = scenes::write("chunks.obj", text);
  const std::string found = inChunks(path, 2, 20);
  CHECK(found.size() > expected.size());
  CHECK_EQUAL(found.substr(found.size() - expected.size()), expected);
  CHECK(checkChunks("v 1 2 3\nv 1 2 3\nf -2 -1 -1\n"));
  CHECK(!checkChunks("v 1 2 3\nv 1 2 3\nf -3 -1 -1\n"));
}

TEST("a statement longer than many chunks is read, and so is a file of continuations alone") {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  for (int i = 0; i < 3000; ++i) text += i % 3 == 0 ? " 1 \\\n" : " -1 2";
  CHECK(checkChunks(text + "\n"));
  std::string continued;
  for (int i = 0; i < 5000; ++i) continued += "\\\n";
  CHECK(checkChunks(continued));
}

TEST("what is no regular file is left to the reader of whole texts") {
  MeshGeometry mesh;
  CHECK(!readObjFile("/dev/null", {}, mesh));
  CHECK(!readObjFile(check::temporaryFolder(), {}, mesh));
  CHECK(!readObjFile(check::temporaryFolder() + "/no such file", {}, mesh));
}

TEST("chunks are whole statements, and together the file") {
  const std::string text = "a\nbb \\\n c\n\nddd \\\r\ne\nlast";
  const std::string path = scenes::write("chunks.txt", text);
  for (std::size_t chunkBytes = 1; chunkBytes < 40; ++chunkBytes) {
    const OpenFile file(path);
    std::vector<char> buffer;
    std::string all;
    const std::size_t count = text.size() / chunkBytes + 1;
    for (std::size_t number = 0; number < count; ++number) {
      const auto chunk = readStatements(file, number, chunkBytes, buffer);
      CHECK(chunk.has_value());
      if (!chunk || chunk->empty()) continue;
      // It is what begins in that stretch of the file, not before and not behind.
      CHECK(all.size() >= number * chunkBytes);
      CHECK(all.size() < (number + 1) * chunkBytes);
      all += *chunk;
      CHECK(all.size() == text.size() ||
            scenes::contains("a\n, c\n,\n\n,\ne\n", all.substr(all.size() - 2)));
    }
    CHECK(readStatements(file, count, chunkBytes, buffer)->empty());
    CHECK_EQUAL(all, text);
  }
  std::remove(path.c_str());
}
