// The program is ended from outside: by signals that ask, at once and without litter; by SIGKILL,
// which leaves the old picture or the new one.
#include <sys/stat.h>

#include <algorithm>

#include "check.h"
#include "patience.h"
#include "random.h"
#include "started_program.h"

namespace {

namespace fs = std::filesystem;
using check::contentOf;
using check::StartedProgram;

/// A glass ball around the eye, of which every ray gives two more: 2^bounces rays in one pixel.
std::string endlessScene() {
  return "PerspectiveCamera { center 0 0 0 direction 0 0 -1 up 0 1 0 angle 40 }\n"
         "Lights { numLights 1 DirectionalLight { direction -1 -1 -1 color 1 1 1 } }\n"
         "Materials { numMaterials 1 PhongMaterial { reflectiveColor 1 1 1\n"
         "  transparentColor 1 1 1 indexOfRefraction 1.1 } }\n"
         "Group { numObjects 2 MaterialIndex 0 Sphere { center 0 0 0 radius 1 }\n"
         "  Sphere { center 0 0 0 radius 2 } }\n";
}

/// A grid of `side` x `side` squares, two triangles each, that waves a little.
std::string largeMesh(int side) {
  std::string text;
  for (int j = 0; j <= side; ++j) {
    for (int i = 0; i <= side; ++i) {
      text += "v " + std::to_string(i) + " " + std::to_string(j) + " " +
              std::to_string((i * 7 + j * 5) % 11) + "\n";
    }
  }
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const int a = j * (side + 1) + i + 1, b = a + side + 1;
      text += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(b + 1) +
              " " + std::to_string(b) + "\n";
    }
  }
  return text;
}

std::string meshScene() {
  std::string scene = check::smallScene();
  scene.replace(scene.find("Sphere"), std::string::npos, "TriangleMesh { obj_file mesh.obj } }\n");
  return scene;
}

struct Desk : check::ScratchFolder {
  Desk() {
    write("scene.txt", check::smallScene());
    write("endless.txt", endlessScene());
    write("out.tga", "old");
    write("said", "");
    mkfifo(file("pipe").c_str(), 0600);
  }
};

constexpr double kAtOnce = 100 * kPatience;  // ms

/// Ends the program by SIGINT and SIGTERM, `delay` ms after its start. The machine may be busy: of
/// several tries the quickest counts, but each has to leave the folder as it was.
void checkEndsAtOnce(const Desk& desk, const std::string& arguments, double delay) {
  const std::size_t files = desk.fileCount();
  for (const int signal : {SIGINT, SIGTERM}) {
    double quickest = 1e9;
    for (int attempt = 0; attempt < 8 && quickest >= kAtOnce; ++attempt) {
      StartedProgram program(arguments, desk.path());
      check::sleepMilliseconds(delay);
      CHECK(program.isRunning());
      CHECK_EQUAL(program.end(signal), 128 + signal);
      quickest = std::min(quickest, program.milliseconds());
      CHECK_EQUAL(contentOf(desk.file("out.tga")), "old");
      fs::remove(desk.file("c"));  // a checkpoint, where there is one
      CHECK_EQUAL(desk.fileCount(), files);
    }
    CHECK(quickest < kAtOnce);
  }
  CHECK_EQUAL(contentOf(desk.file("said")), "");
}

}  // namespace

TEST("SIGINT and SIGTERM end the reading of a scene that does not come") {
  const Desk desk;
  checkEndsAtOnce(desk, "-input pipe -output out.tga", 100);
}

TEST("SIGINT and SIGTERM end a run inside one pixel of endless rays, with a checkpoint too") {
  const Desk desk;
  const std::string run =
      "-input endless.txt -size 1 1 -bounces 5000 -weight 0 -quiet -output out.tga ";
  checkEndsAtOnce(desk, run, 200);
  checkEndsAtOnce(desk, run + "-checkpoint c", 200);
  checkEndsAtOnce(desk, run + "-random_samples 3 -checkpoint c", 200);
}

TEST("SIGINT and SIGTERM end a run that waits for the reader of a pipe, or for it to read") {
  const Desk desk;
  const std::string run = "-input scene.txt -size 200 200 -output pipe";
  checkEndsAtOnce(desk, run, 300);
  checkEndsAtOnce(desk, run + " -checkpoint c", 300);
  // 120018 bytes are more than a pipe holds.
  const int reader = open(desk.file("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  checkEndsAtOnce(desk, run, 300);
  close(reader);
}

TEST("SIGINT and SIGTERM end a run whose messages nobody reads, in the middle of a line") {
  const Desk desk;
  fs::remove(desk.file("said"));
  mkfifo(desk.file("said").c_str(), 0600);
  for (const int signal : {SIGINT, SIGTERM}) {
    const int reader = open(desk.file("said").c_str(), O_RDWR | O_NONBLOCK);
    StartedProgram program(
        "-input scene.txt -size 2000 2000 -random_samples 100 -progress -output out.tga",
        desk.path());
    char begun = 0;
    while (read(reader, &begun, 1) != 1) check::sleepMilliseconds(10);  // a line is open now
    while (write(reader, &begun, 1) == 1) {
    }
    program.endWithin(1000, signal);
    CHECK_EQUAL(program.wait(), 128 + signal);
    CHECK_EQUAL(contentOf(desk.file("out.tga")), "old");
    close(reader);
  }
  CHECK_EQUAL(desk.fileCount(), std::size_t(5));
}

TEST("SIGTERM at any moment of a run leaves the old picture or the new one, and no litter") {
  const Desk desk;
  desk.write("scene.txt", meshScene());
  desk.write("mesh.obj", largeMesh(150));
  const std::string run = "-input scene.txt -size 300 300 -output out.tga";
  const auto start = std::chrono::steady_clock::now();
  CHECK_EQUAL(StartedProgram(run, desk.path()).wait(), 0);
  const double whole =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const std::string picture = contentOf(desk.file("out.tga"));
  const std::size_t files = desk.fileCount();
  Random random(11);
  int ended = 0;
  for (int round = 0; round < 40; ++round) {
    desk.write("out.tga", "old");
    StartedProgram program(run, desk.path());
    check::sleepMilliseconds(random.uniform(0, whole));
    const int status = program.end(SIGTERM);
    CHECK(status == 143 || status == 0);
    ended += status == 143;
    const std::string found = contentOf(desk.file("out.tga"));
    CHECK(found == picture || (found == "old" && status == 143));
    CHECK_EQUAL(desk.fileCount(), files);
  }
  CHECK(ended > 0);
}

TEST("SIGKILL at 100 random moments leaves the old picture or the whole new one") {
  const Desk desk;
  const std::string run = "-input scene.txt -size 160 160 -threads 1 -output out.tga";
  const auto start = std::chrono::steady_clock::now();
  CHECK_EQUAL(StartedProgram(run, desk.path()).wait(), 0);
  const double whole =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const std::string picture = contentOf(desk.file("out.tga"));
  Random random(12);
  int killed = 0;
  for (int round = 0; round < 100; ++round) {
    desk.write("out.tga", "old");
    StartedProgram program(run, desk.path());
    check::sleepMilliseconds(random.uniform(0, 1.1 * whole));
    killed += program.end(SIGKILL) == 137;
    const std::string found = contentOf(desk.file("out.tga"));
    CHECK(found == "old" || found == picture);
  }
  CHECK(killed > 0);
  for (const auto& entry : fs::directory_iterator(desk.path())) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("out.tga.tmp.", 0) == 0) fs::remove(entry.path());  // which SIGKILL may leave
  }
  CHECK_EQUAL(desk.fileCount(), std::size_t(5));
}

TEST("two runs that write the same name at once both leave a whole picture") {
  const Desk desk;
  const std::string runs[] = {"-input scene.txt -size 200 160 -output ",
                              "-input scene.txt -size 120 170 -no_shadows -output "};
  std::string whole[2];
  for (int i = 0; i < 2; ++i) {
    CHECK_EQUAL(StartedProgram(runs[i] + "out.tga", desk.path()).wait(), 0);
    whole[i] = contentOf(desk.file("out.tga"));
  }
  const std::size_t files = desk.fileCount();
  for (int round = 0; round < 15; ++round) {
    StartedProgram first(runs[round % 2] + "out.tga", desk.path());
    StartedProgram second(runs[1 - round % 2] + "out.tga", desk.path());
    CHECK_EQUAL(first.wait(), 0);
    CHECK_EQUAL(second.wait(), 0);
    const std::string found = contentOf(desk.file("out.tga"));
    CHECK(found == whole[0] || found == whole[1]);
    CHECK_EQUAL(desk.fileCount(), files);
  }
}
