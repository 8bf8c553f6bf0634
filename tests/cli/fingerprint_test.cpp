// The fingerprint: another one for all that can change the picture, the same for all that cannot.
#include <set>
#include <sstream>

#include "check.h"
#include "cli/arguments.h"
#include "cli/part_file.h"
#include "run_program.h"

namespace {

RenderRequest parse(const std::string& words) {
  std::istringstream in("-input scene.txt -output a " + words);
  return parseRequest({std::istream_iterator<std::string>(in), {}}).render;
}

Digest of(const std::string& words, const std::vector<std::string>& meshes = {},
          const std::string& scene = "scene") {
  const RenderRequest render = parse(words);
  return pictureFingerprint(render, sha256(scene.data(), scene.size()), meshes, 2);
}

}  // namespace

TEST("what changes no pixel leaves the fingerprint") {
  const Digest plain = of("");
  for (const char* same :
       {"-threads 3", "-simd baseline", "-accel tree", "-quiet", "-stats", "-output b",
        "-input other.txt", "-checkpoint c", "-progress", "-preview", "-heatmap h", "-pixel 1 2"}) {
    CHECK(of(same) == plain);
  }
  CHECK(of("-depth 1 2 d") == of("-depth e 1 2"));
  CHECK(of("-depth 1 2 d") == of("-depth 1.0 2 d"));
  CHECK(of("-bounces 3 -bounces 5") == of("-bounces 5"));
  CHECK(of("-normals n") == of("--normal m"));
  CHECK(of("-materials n") == of("-materials m"));
  CHECK(of("-pixel 1 2 -pixel_obj n") == of("-pixel 1 2 -pixel_obj m"));
}

TEST("each argument that may change a pixel changes the fingerprint, and so does each word of it") {
  std::set<Digest> all;
  const char* const different[] = {"",
                                   "-bounces 3",
                                   "-bounces 4",
                                   "-weight 0.3",
                                   "-size 4 3",
                                   "-size 43 3",
                                   "-size 4 33",
                                   "-shade_back",
                                   "-no_shadows",
                                   "-transparent_shadows",
                                   "-shadows -no_shadows -shadows",
                                   "-epsilon adaptive",
                                   "-epsilon 0.1",
                                   "-random_samples 4",
                                   "-jittered_samples 4",
                                   "-jittered_samples 4 -tent_filter 1",
                                   "-depth 1 2 d",
                                   "-depth 1 3 d",
                                   "-depth 1.00000000000000022 3 d",
                                   "-normals n",
                                   "-normals n -depth 1 2 d",
                                   "-materials m",
                                   "-render_samples s 2",
                                   "-render_samples s 3"};
  for (const char* words : different) {
    check::report(all.insert(of(words)).second, __FILE__, __LINE__, words);
  }
}

TEST("an argument that is new is taken to change pixels until it is listed as one that does not") {
  const std::set<std::string> listed = {
      "input", "output",     "depth",       "normals",      "render_samples", "render_filter",
      "accel", "simd",       "threads",     "stats",        "quiet",          "check",
      "help",  "version",    "checkpoint",  "memory_limit", "progress",       "preview",
      "man",   "completion", "materials",   "heatmap",      "pixel",          "pixel_obj",
      "gui",   "gouraud",    "tessellation"};
  for (const ArgumentRow& row : argumentTable()) {
    CHECK_EQUAL(row.action->changesPixels, listed.count(row.name) == 0);
  }
}

TEST("every byte of the scene and of the meshes counts, and which mesh stands where") {
  const check::ScratchFolder folder;
  const std::string a = folder.write("a", "v 0 0 0\n"), b = folder.write("b", "v 0 0 1\n");
  const Digest first = of("", {a, b});
  CHECK(of("", {a, b}) == first);
  CHECK(of("", {b, a}) != first);
  CHECK(of("", {a}) != first);
  CHECK(of("", {a, a}) != of("", {a}));
  CHECK(of("", {a, b}, "scenf") != first);
  folder.write("b", "v 0 0 2\n");
  CHECK(of("", {a, b}) != first);
}

TEST("a file has the same digest on any number of threads, another one after any change") {
  const check::ScratchFolder folder;
  std::string bytes((3 << 20) + 17, 'x');  // three pieces and a rest
  const std::string name = folder.write("f", bytes);
  const Digest digest = fileDigest(name, 1);
  CHECK(fileDigest(name, 5) == digest);
  CHECK(fileDigest(folder.write("g", bytes), 2) == digest);
  for (std::size_t at : {std::size_t(0), std::size_t(1) << 20, bytes.size() - 1}) {
    bytes[at] = 'y';
    CHECK(fileDigest(folder.write("f", bytes), 2) != digest);
    bytes[at] = 'x';
  }
  CHECK(fileDigest(folder.write("f", bytes + "x"), 2) != digest);
  CHECK(fileDigest(folder.write("f", ""), 2) == fileDigest(folder.write("f", ""), 1));
  CHECK_THROWS(fileDigest(folder.file("none"), 1), std::runtime_error);
  CHECK_THROWS(fileDigest("/dev/null", 1), std::runtime_error);
}
