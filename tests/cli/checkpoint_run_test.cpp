// -checkpoint: runs that are ended, and taken up by the same command.
#include "check.h"
#include "sanitizers.h"
#include "started_program.h"

namespace {

namespace fs = std::filesystem;
using check::contentOf;
using check::StartedProgram;

constexpr std::size_t kHeader = 96;  // of a checkpoint without tiles

struct Desk : check::ScratchFolder {
  Desk() {
    write("said", "");
    std::string scene = check::smallScene();
    scene.replace(scene.find("numObjects 1"), 12, "numObjects 2");
    scene.replace(scene.rfind('}'), 1, "TriangleMesh { obj_file mesh.obj } }");
    write("scene.txt", scene);
    write("mesh.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
  }
  check::ProgramRun run(const std::string& arguments, const std::string& before = "") const {
    return check::runProgram("-input scene.txt " + arguments, path(), before);
  }
  bool exists(const std::string& name) const { return fs::exists(file(name)); }
  std::string content(const std::string& name) const { return contentOf(file(name)); }
  std::size_t size(const std::string& name) const { return content(name).size(); }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Long enough (some seconds at least) to be ended in between; small enough not to be a burden.
const std::string kLong = "-size 80 60 -random_samples 6000 -normals n -depth 2 6 d.pfm -output ";

/// Starts the long run, and ends it by the signal when it has saved so many bytes of tiles.
/// False where the run was through before.
bool endAfter(const Desk& desk, std::size_t bytes, int signal) {
  StartedProgram program("-input scene.txt " + kLong + "a.pfm -checkpoint c", desk.path());
  while (program.isRunning()) {
    if (desk.exists("c") && desk.size("c") >= kHeader + bytes) {
      const int status = program.end(signal);
      CHECK(status == 128 + signal || status == 0);
      return status != 0;
    }
    check::sleepMilliseconds(20);
  }
  return false;
}

/// Ends the run by `signal`; every time the file has to hold more than before, or at least as much
/// as it was seen to hold, unless the run has come to its pictures before the signal did.
void checkTakenUp(int signal) {
  const Desk desk;
  CHECK_EQUAL(desk.run(kLong + "whole.pfm").status, 0);
  const std::string depth = desk.content("d.pfm"), normals = desk.content("n");
  fs::remove(desk.file("d.pfm"));
  fs::remove(desk.file("n"));
  std::size_t saved = 0;
  bool isThrough = false;  // a quick machine may be, before the third end
  for (int ends = 0; ends < 3; ++ends) {
    isThrough = !endAfter(desk, saved + 1, signal) || desk.exists("a.pfm") ||
                desk.exists("d.pfm") || desk.exists("n");
    if (isThrough) break;
    CHECK(desk.size("c") > kHeader + saved);
    saved = desk.size("c") - kHeader;
  }
  CHECK(saved > 0);
  const check::ProgramRun last = desk.run(kLong + "b.pfm -checkpoint c -threads 3 -accel tree");
  CHECK_EQUAL(last.status, 0);
  CHECK(isThrough || contains(last.errors, "raytracer: c: taken up with "));
  CHECK(desk.content("b.pfm") == desk.content("whole.pfm"));
  CHECK(desk.content("d.pfm") == depth);
  CHECK(desk.content("n") == normals);
  CHECK(!desk.exists("c"));
}

}  // namespace

TEST("a run ended by SIGTERM is taken up, and ends with the bytes of one that was not") {
  checkTakenUp(SIGTERM);
}

TEST("a run ended by SIGKILL is taken up, and ends with the bytes of one that was not") {
  checkTakenUp(SIGKILL);
}

TEST("SIGTERM, a moment after the start, loses nothing that was finished") {
  const Desk desk;
  // 16 x 16 pixels of 100 samples each take some milliseconds: a tile is there long before the end.
  StartedProgram program(
      "-input scene.txt -size 2000 2000 -random_samples 100 -threads 1 -output a -checkpoint c",
      desk.path());
  const std::size_t record = 12 + 3 * 16 * 16 + 32;
  while (program.isRunning() && desk.size("c") < kHeader + record) check::sleepMilliseconds(1);
  const std::size_t seen = desk.size("c");
  CHECK_EQUAL(program.end(SIGTERM), 143);
  CHECK(desk.size("c") >= seen && seen >= kHeader + record);
}

TEST("a checkpoint of other inputs or options is refused, whole or not, and stays as it is") {
  const Desk desk;
  CHECK(endAfter(desk, 1, SIGTERM));
  const std::string kept = desk.content("c"), command = kLong + "a.pfm -checkpoint c ";
  const check::ProgramRun bytes = desk.run(kLong + "a.tga -checkpoint c");  // for tiles of floats
  CHECK(bytes.status == 2 && desk.content("c") == kept && !desk.exists("a.tga"));
  const auto refused = [&](const std::string& more) {
    const check::ProgramRun run = desk.run(command + more);
    return run.status == 2 && contains(run.errors, "was made from another scene") &&
           desk.content("c") == kept && !desk.exists("a.pfm");
  };
  CHECK(refused("-bounces 4"));
  CHECK(refused("-size 60 80"));
  CHECK(refused("-depth 2 7 d.pfm"));
  const std::string mesh = desk.content("mesh.obj"), scene = desk.content("scene.txt");
  desk.write("mesh.obj", mesh + "#");
  CHECK(refused(""));
  desk.write("mesh.obj", mesh);
  desk.write("scene.txt", scene + "#");
  CHECK(refused(""));
  desk.write("scene.txt", scene);
  CHECK_EQUAL(check::runProgram("-input - " + command + "-quiet < scene.txt", desk.path()).status,
              0);
  CHECK(!desk.exists("c"));
}

TEST("an output that cannot be written now loses nothing that the checkpoint holds of it") {
  const Desk desk;
  CHECK(endAfter(desk, 1, SIGKILL));
  const std::size_t saved = desk.size("c");
  fs::create_directory(desk.file("n"));
  {
    StartedProgram program("-input scene.txt " + kLong + "a.pfm -checkpoint c", desk.path());
    while (program.isRunning() && !contains(desk.content("said"), "taken up")) {
      check::sleepMilliseconds(5);
    }
    program.end(SIGTERM);
  }
  CHECK(contains(desk.content("said"), "raytracer: n: cannot be written: Is a directory\n"));
  CHECK(desk.size("c") >= saved);
  CHECK_EQUAL(desk.run(kLong + "a.pfm -checkpoint c").status, 1);
  CHECK(desk.exists("a.pfm") && desk.exists("d.pfm"));
  fs::remove(desk.file("n"));
  const check::ProgramRun last = desk.run(kLong + "a.pfm -checkpoint c");
  CHECK_EQUAL(last.status, 0);
  CHECK_EQUAL(last.errors, "raytracer: c: taken up with 100 % done\n");
  CHECK(desk.exists("n") && !desk.exists("c"));
}

TEST("a file that is no checkpoint is not touched") {
  const Desk desk;
  const std::string notes = "my notes\n";
  desk.write("notes", notes);
  CHECK_EQUAL(desk.run("-output a -checkpoint notes").status, 2);
  CHECK_EQUAL(desk.content("notes"), notes);
  for (const char* wrong : {"scene.txt", "mesh.obj", "a", "/dev/null", "."}) {
    CHECK(desk.run(std::string("-output a -checkpoint ") + wrong).status != 0);
  }
  CHECK_EQUAL(desk.run("-output a -checkpoint none/c").status, 1);
  CHECK(!desk.exists("a"));
}

TEST("the checkpoint stays where an output fails, and a disk that is full costs no picture") {
  const Desk desk;
  if (access("/dev/full", W_OK) != 0) SKIP("there is no /dev/full");
  CHECK_EQUAL(desk.run("-output a -checkpoint c").status, 0);
  CHECK(!desk.exists("c"));
  CHECK_EQUAL(desk.run("-output - -checkpoint c > /dev/full").status, 1);
  CHECK(desk.exists("c"));
  const check::ProgramRun again = desk.run("-output b -checkpoint c");
  CHECK_EQUAL(again.status, 0);
  CHECK_EQUAL(again.errors, "raytracer: c: taken up with 100 % done\n");
  CHECK(desk.content("a") == desk.content("b"));
  CHECK(!desk.exists("c"));
  // A limit of 512 or 1024 bytes: a picture of 12 x 12 pixels has 450, their three tiles 1296.
  const std::string small = "-size 12 12 -normals n -depth 2 6 d -output ";
  CHECK_EQUAL(desk.run(small + "e").status, 0);
  const check::ProgramRun some = desk.run(small + "f -checkpoint c", "ulimit -f 1;");
  CHECK_EQUAL(some.status, 0);
  CHECK_EQUAL(some.errors, "raytracer: warning: c: cannot be written: File too large\n");
  CHECK(desk.content("f") == desk.content("e"));
  if (kHasSanitizer) return;  // it writes a file of its own before main
  CHECK_EQUAL(desk.run(small + "g -checkpoint c", "ulimit -f 0;").status, 1);
  CHECK(!desk.exists("g"));
}

TEST("messages never end up in the checkpoint where standard error is closed") {
  const Desk desk;
  const std::string command = "-output a -normals none/b -checkpoint c";
  for (int run = 0; run < 2; ++run) CHECK_EQUAL(desk.run(command + " 2>&-").status, 1);
  CHECK_EQUAL(desk.run(command).errors,
              "raytracer: none/b: cannot be written: No such file or directory\n"
              "raytracer: c: taken up with 100 % done\n");
}
