// Outputs that fail: never status 0 with a bad or missing picture, the old file intact, no litter.
// And standard output as an output.
#include <unistd.h>

#include <cstdlib>

#include "check.h"
#include "run_program.h"
#include "sanitizers.h"

namespace {

namespace fs = std::filesystem;
using check::contentOf;
using check::quoted;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

struct Desk : check::ScratchFolder {
  Desk() { write("scene.txt", check::smallScene()); }
  check::ProgramRun run(const std::string& arguments, const std::string& before = "") const {
    return check::runProgram("-input scene.txt " + arguments, path(), before);
  }
  std::string content(const std::string& name) const { return contentOf(file(name)); }
};

/// Two pieces of at least 65536 bytes.
const std::string kPicture = "-threads 1 -size 200 150 ";

/// Runs the program with the `count`th call of a kind made to fail; false where there were fewer.
/// `calls` names the kind as strace knows it, `error` is what the call gives.
bool runInjected(const Desk& desk, const std::string& arguments, const std::string& calls,
                 const std::string& error, int count, check::ProgramRun& run) {
  const check::ScratchFolder logs;
  const std::string log = logs.file("log");
  run = desk.run(arguments,
                 "strace -f -qq -o " + quoted(log) + " -e trace=" + quoted(calls) + " -e inject=" +
                     quoted(calls + ":error=" + error + ":when=" + std::to_string(count)) + " ");
  return contains(contentOf(log), "(INJECTED)");
}

bool hasStrace() { return std::system("strace -o /dev/null true >/dev/null 2>&1") == 0; }

/// Makes each call of the kind fail in turn, and gives how many runs said that they failed.
int failEachCall(const std::string& calls, const std::string& error) {
  const Desk desk;
  CHECK_EQUAL(desk.run(kPicture + "-output whole.tga").status, 0);
  const std::string whole = desk.content("whole.tga");
  int failures = 0;
  for (int count = 1; count < 100; ++count) {
    desk.write("out.tga", "old");
    check::ProgramRun run;
    if (!runInjected(desk, kPicture + "-output out.tga", calls, error, count, run)) return failures;
    const std::string found = desk.content("out.tga");
    const std::string what = calls + " " + std::to_string(count) + ": status " +
                             std::to_string(run.status) + ", " + run.errors;
    failures += run.status != 0;
    check::report(run.status == 0 ? found == whole : !run.errors.empty(), __FILE__, __LINE__, what);
    check::report(found == "old" || found == whole, __FILE__, __LINE__, what);
    CHECK_EQUAL(desk.fileCount(), std::size_t(3));
  }
  CHECK(false);
  return failures;
}

}  // namespace

TEST("each write, fsync, rename and close that fails is either harmless or told") {
  if (!hasStrace()) SKIP("there is no strace that works here");
  // To learn what memory it may read it writes to a pipe, which must not fail.
  if (kHasSanitizer) SKIP("a sanitizer has writes of its own");
  CHECK(failEachCall("write", "ENOSPC") >= 2);
  CHECK(failEachCall("fsync", "EIO") == 2);  // of the file, and of its folder
  CHECK(failEachCall("/^rename", "EIO") == 1);
  CHECK(failEachCall("close", "EIO") >= 1);  // those of files that were only read do no harm
  CHECK(failEachCall("/^f?stat|^newfstat", "EIO") >= 1);
}

TEST("a write that the system cuts off short is not taken for a whole one") {
  if (!hasStrace()) SKIP("there is no strace that works here");
  const Desk desk;
  desk.write("out.tga", "old");
  // The second of two pieces, of 66018 and 24000 bytes: the call says that it wrote all, and wrote
  // nothing.
  const check::ProgramRun run =
      desk.run(kPicture + "-output out.tga",
               "strace -f -qq -o /dev/null -e trace=write -e inject=write:retval=24000:when=2 ");
  CHECK_EQUAL(run.status, 1);
  CHECK_EQUAL(desk.content("out.tga"), "old");
  CHECK_EQUAL(desk.fileCount(), std::size_t(2));
}

TEST("-output - writes the picture to standard output, and so does any other output") {
  const Desk desk;
  CHECK_EQUAL(desk.run("-output a -normals b -depth 4 5 c -render_samples d 2").status, 0);
  CHECK(desk.run("-output -").output == desk.content("a"));
  CHECK(desk.run("-normals -").output == desk.content("b"));
  CHECK(desk.run("-depth - 4 5").output == desk.content("c"));
  CHECK(desk.run("-depth 4 5 -").output == desk.content("c"));
  CHECK(desk.run("-render_samples - 2").output == desk.content("d"));
  const check::ProgramRun both = desk.run("-output - -normals e | cat");
  CHECK(both.output == desk.content("a"));
  CHECK_EQUAL(both.errors, "");
  CHECK(desk.content("e") == desk.content("b"));
  CHECK_EQUAL(desk.run("-output ./-").output, "");
  CHECK(desk.content("-") == desk.content("a"));
  CHECK(check::runProgram("-input - -output - < scene.txt", desk.path()).output ==
        desk.content("a"));
}

TEST("standard output takes one picture, and no lines of -stats besides") {
  const Desk desk;
  for (const char* clash :
       {"-output - -normals -", "-output - -depth 1 2 /dev/stdout", "-output - -stats",
        "-normals - -stats", "-output - -normals ./same.tga > same.tga",
        "-output /dev/stdout -stats", "-materials /dev/fd/1", "-heatmap /proc/self/fd/1",
        "-output /dev/stdout -preview", "-output ./same.tga -pixel 1 1 > same.tga",
        "-output /dev/stdout -stats | cat"}) {
    const check::ProgramRun run = desk.run(clash);
    check::report(run.status == 2 || contains(clash, "|"), __FILE__, __LINE__, clash);
    check::report(run.output.empty() && contains(run.errors, "expected"), __FILE__, __LINE__,
                  clash);
  }
  CHECK_EQUAL(desk.content("same.tga"), "");
  CHECK_EQUAL(desk.run("-output /dev/null -normals /dev/null -stats > /dev/null").status, 0);
  CHECK_EQUAL(desk.run("-output /dev/stdout -stats -check").status, 0);
  CHECK_EQUAL(desk.run("-output - -stats -check").status, 0);
}

TEST("a scene that comes on standard input is not replaced by a picture of it") {
  const Desk desk;
  const std::string scene = desk.content("scene.txt");
  fs::create_symlink("scene.txt", desk.file("link"));
  for (const char* wrong :
       {"-input - -output ./link < scene.txt", "-input - -depth 1 2 link < scene.txt",
        "-input /dev/stdin -normals link < scene.txt"}) {
    const check::ProgramRun run = check::runProgram(wrong, desk.path());
    check::report(run.status == 2 && contains(run.errors, "expected different files"), __FILE__,
                  __LINE__, wrong);
    CHECK_EQUAL(desk.content("scene.txt"), scene);
  }
}

TEST("a file that cannot be asked for its size never gives a part of another picture") {
  if (!hasStrace()) SKIP("there is no strace that works here");
  if (kHasSanitizer) SKIP("a sanitizer has calls of its own");
  const Desk desk;
  std::string scene = desk.content("scene.txt");
  scene.replace(scene.find("Sphere"), std::string::npos, "TriangleMesh { obj_file m.obj } }\n");
  desk.write("scene.txt", scene);
  desk.write("m.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
  const std::string part = "-threads 1 -tile 1 2 -output ";
  CHECK_EQUAL(desk.run(part + "whole.tga").status, 0);
  for (int count = 1; count < 100; ++count) {
    check::ProgramRun run;
    if (!runInjected(desk, part + "out.tga", "/^f?stat|^newfstat", "EIO", count, run)) return;
    if (run.status != 0) continue;
    check::report(desk.content("out.tga") == desk.content("whole.tga"), __FILE__, __LINE__,
                  std::to_string(count));
  }
  CHECK(false);
}

TEST("a pipe without a reader is a failed output with a message, and no signal") {
  const Desk desk;
  const std::string command =
      "cd " + quoted(desk.path()) + " && { " + quoted(check::programToTest()) +
      " -input scene.txt -size 300 300 -output - 2> said; echo $? > status; } | true";
  CHECK_EQUAL(std::system(command.c_str()), 0);
  CHECK_EQUAL(desk.content("status"), "1\n");
  CHECK_EQUAL(desk.content("said"), "raytracer: standard output: cannot be written: Broken pipe\n");
}

TEST("standard output that is closed, full or read-only is a failed output") {
  const Desk desk;
  CHECK_EQUAL(desk.run("-output - >&-").errors,
              "raytracer: standard output: cannot be written: Bad file descriptor\n");
  CHECK_EQUAL(desk.run("-output - >&-").status, 1);
  CHECK_EQUAL(desk.run("-output - 1</dev/null").status, 1);
  CHECK_EQUAL(desk.run("-stats >&-").status, 1);
  if (access("/dev/full", W_OK) != 0) return;
  const check::ProgramRun full = desk.run("-output - >/dev/full");
  CHECK_EQUAL(full.status, 1);
  CHECK_EQUAL(full.errors,
              "raytracer: standard output: cannot be written: No space left on device\n");
}

TEST("messages never end up in a picture where standard error is closed") {
  const Desk desk;
  std::string dark = check::smallScene();
  dark.replace(dark.find("Lights"), dark.find("Background") - dark.find("Lights"), "");
  desk.write("scene.txt", dark);
  CHECK(!desk.run("-output a -normals none/b").errors.empty());
  CHECK_EQUAL(desk.run("-output c -normals none/b <&- >&- 2>&-").status, 1);
  CHECK(desk.content("a") == desk.content("c"));
  CHECK_EQUAL(check::runProgram("-input - -output d <&-", desk.path()).status, 3);
}

TEST("messages never end up in a file where there is neither standard error nor /dev/null") {
  if (!hasStrace()) SKIP("there is no strace that works here");
  if (kHasSanitizer) SKIP("a sanitizer has calls of its own");
  const Desk desk;
  const std::string bare =
      "strace -f -qq -o log -P /dev/null -e trace=openat -e inject=openat:error=ENOENT "
      "sh -c 'exec \"$0\" \"$@\" 2>&-'";
  const std::string command = "-output a -normals none/b -checkpoint c";
  for (int run = 0; run < 2; ++run) CHECK_EQUAL(desk.run(command, bare).status, 1);
  CHECK(contains(desk.content("log"), "(INJECTED)"));
  CHECK_EQUAL(desk.run(command).errors,
              "raytracer: none/b: cannot be written: No such file or directory\n"
              "raytracer: c: taken up with 100 % done\n");
}

TEST("a small disk that is full leaves the old picture and no litter, without root's rights too") {
  const Desk desk;
  const std::string small =
      "unshare -m sh -c 'mkdir disk && mount -t tmpfs -o size=64k tmpfs disk && echo old > "
      "disk/out.tga && ";
  const std::string inside = geteuid() == 0 ? small : "unshare -r " + small.substr(8);
  const std::string test = "cd " + quoted(desk.path()) + " && " + inside + "true' 2>/dev/null";
  if (std::system(test.c_str()) != 0) SKIP("cannot mount a small disk");
  fs::remove(desk.file("disk"));
  // 200 x 150 pixels take 90018 bytes.
  const std::string program = check::programToTest();
  const std::string script = "cd " + quoted(desk.path()) + " && " + inside + "\"" + program +
                             "\" -input scene.txt -size 200 150 -output disk/out.tga 2> said; "
                             "echo $? > status; cat disk/out.tga > kept; ls disk > names'";
  CHECK_EQUAL(std::system(script.c_str()), 0);
  CHECK_EQUAL(desk.content("status"), "1\n");
  CHECK_EQUAL(desk.content("kept"), "old\n");
  CHECK_EQUAL(desk.content("names"), "out.tga\n");
  CHECK_EQUAL(desk.content("said"),
              "raytracer: disk/out.tga: cannot be written: No space left on device\n");
}
