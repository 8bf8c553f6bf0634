// -memory_limit: whatever memory is wanted for, a run that would take more ends with a message.
#include <sstream>

#include "check.h"
#include "run_program.h"
#include "sanitizers.h"

namespace {

bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}
bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void skipWithSanitizer() {
  if (kHasSanitizer) SKIP("a sanitizer takes more addresses than any limit allows");
}

/// A folder with a scene, and an image that a failed run must leave alone.
struct Desk : check::ScratchFolder {
  Desk() {
    write("scene.txt", check::smallScene());
    write("out.tga", "old");
  }

  check::ProgramRun run(int megabytes, const std::string& arguments) const {
    return check::runProgram(
        "-quiet -threads 2 -memory_limit " + std::to_string(megabytes) + " " + arguments, path());
  }

  /// The run ended for lack of memory, said so in one line, and left the `files` as they were.
  void checkEnded(const check::ProgramRun& run, int megabytes, std::size_t files) const {
    CHECK_EQUAL(run.status, 1);
    const std::string start = "raytracer: -memory_limit " + std::to_string(megabytes) + ": ";
    check::report(startsWith(run.errors, start), __FILE__, __LINE__,
                  "'" + run.errors + "' begins '" + start + "'");
    CHECK_EQUAL(run.errors.find('\n'), run.errors.size() - 1);
    CHECK_EQUAL(check::contentOf(file("out.tga")), "old");
    CHECK_EQUAL(fileCount(), files);
  }
};

/// A scene with a mesh of 2 * side * side triangles, hills of no special form.
void writeHills(const Desk& desk, int side) {
  std::ostringstream mesh;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      mesh << "v " << x << ' ' << (x * y) % 7 * 0.1 << ' ' << y << '\n';
    }
  }
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int a = y * (side + 1) + x + 1, b = a + side + 1;
      mesh << "f " << a << ' ' << b << ' ' << b + 1 << ' ' << a + 1 << '\n';
    }
  }
  desk.write("hills.obj", mesh.str());
  desk.write("hills.txt",
             "PerspectiveCamera { center 50 90 50 direction 0 -1 0 up 0 0 1 angle 60 }\n"
             "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 1 1 } }\n"
             "Group { numObjects 1 Material { } TriangleMesh { obj_file hills.obj } }\n");
}

}  // namespace

TEST("an image that -memory_limit does not hold ends the run with a message and no litter") {
  skipWithSanitizer();
  const Desk desk;
  // 4000 x 4000 pixels of 3 bytes are 46 MB; the stack of the run takes 8 MB more.
  const auto run = desk.run(40, "-input scene.txt -size 4000 4000 -output out.tga");
  desk.checkEnded(run, 40, 2);
  CHECK(contains(run.errors, "not enough memory for images of 4000 x 4000 pixels"));
}

TEST("a scene file that -memory_limit does not hold is no mistake in the scene") {
  skipWithSanitizer();
  const Desk desk;
  desk.write("large.txt", check::smallScene() + std::string(40 << 20, ' '));
  const auto run = desk.run(30, "-input large.txt -output out.tga");
  desk.checkEnded(run, 30, 3);
  CHECK(contains(run.errors, "not enough memory to read large.txt"));
  desk.checkEnded(desk.run(30, "-input large.txt -check"), 30, 3);
  desk.checkEnded(desk.run(30, "-input - -output out.tga <large.txt"), 30, 3);
}

TEST("a limit too small even for the first stack is said to be so") {
  skipWithSanitizer();
  const Desk desk;
  desk.checkEnded(desk.run(1, "-input scene.txt -output out.tga"), 1, 2);
}

TEST("whatever phase memory runs out in, there is a message; with enough the bytes are the same") {
  skipWithSanitizer();
  const Desk desk;
  writeHills(desk, 100);
  const std::string arguments = "-input hills.txt -size 200 200 -output ";
  CHECK_EQUAL(check::runProgram("-quiet " + arguments + "free.tga", desk.path()).status, 0);
  // The file is above half a megabyte, 20000 triangles and their tree take some megabytes, and so
  // do the stacks: the limits below 64 end in different phases, the last ones not at all.
  int ended = 0, readingEnded = 0, renderingEnded = 0, megabytes = 8;
  for (; megabytes <= 64; ++megabytes) {
    const auto run = desk.run(megabytes, arguments + "out.tga");
    if (run.status == 0) break;
    desk.checkEnded(run, megabytes, 5);
    ++ended;
    readingEnded += contains(run.errors, "to read hills.txt");
    renderingEnded += contains(run.errors, "to render") || contains(run.errors, "cannot start");
  }
  CHECK(ended >= 3 && readingEnded >= 1 && renderingEnded >= 1);
  CHECK(megabytes <= 64);
  CHECK(check::contentOf(desk.file("out.tga")) == check::contentOf(desk.file("free.tga")));
}

TEST("threads that -memory_limit has no room for are left out, and the image is the same") {
  skipWithSanitizer();
  const Desk desk;
  const std::string arguments = "-input scene.txt -size 500 500 -output ";
  CHECK_EQUAL(check::runProgram(arguments + "free.tga", desk.path()).status, 0);
  // 1000 stacks of 2 MB each would take 2 GB.
  const auto run = desk.run(100, "-threads 1000 -stats " + arguments + "out.tga");
  CHECK_EQUAL(run.status, 0);
  CHECK(contains(run.output, "threads: 12\n"));  // 100 / 8
  CHECK(check::contentOf(desk.file("out.tga")) == check::contentOf(desk.file("free.tga")));
}
