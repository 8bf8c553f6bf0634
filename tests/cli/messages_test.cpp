// What the program says on standard error: every byte, and each line whole.
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

#include "check.h"
#include "cli/program.h"
#include "image/output_file.h"
#include "run_program.h"

namespace {

/// Calls work() with `target` as standard error.
template <class Work>
void withErrorsTo(int target, const Work& work) {
  const int before = dup(STDERR_FILENO);
  CHECK(before >= 0 && target >= 0);
  dup2(target, STDERR_FILENO);
  work();
  dup2(before, STDERR_FILENO);
  close(before);
}

/// What work() writes to standard error.
template <class Work>
std::string errorsOf(const Work& work) {
  const check::ScratchFolder folder;
  const std::string file = folder.file("errors");
  const int target = open(file.c_str(), O_WRONLY | O_CREAT, 0600);
  withErrorsTo(target, work);
  close(target);
  return check::contentOf(file);
}

}  // namespace

TEST("a message is one line behind the program's name, and no byte of it is lost") {
  CHECK_EQUAL(errorsOf([] { complain("no room"); }), "raytracer: no room\n");
  CHECK_EQUAL(errorsOf([] { complain(""); }), "raytracer: \n");
  const std::string zeros("a\0b\0", 4);
  CHECK_EQUAL(errorsOf([&] { complain(zeros); }), "raytracer: " + zeros + "\n");
  const std::string percent = "100 %s %n";
  CHECK_EQUAL(errorsOf([&] { complain(percent); }), "raytracer: " + percent + "\n");
  const std::string large(300000, 'x');
  CHECK(errorsOf([&] { complain(large); }) == "raytracer: " + large + "\n");
}

TEST("a message is a single write, so that lines of several threads do not mix") {
  int ends[2];  // of a socket that keeps writes apart
  CHECK_EQUAL(socketpair(AF_UNIX, SOCK_DGRAM, 0, ends), 0);
  withErrorsTo(ends[0], [] {
    complain("one");
    complain("two");
  });
  for (const char* expected : {"raytracer: one\n", "raytracer: two\n"}) {
    char text[64] = {};
    const ssize_t size = recv(ends[1], text, sizeof text, MSG_DONTWAIT);
    CHECK_EQUAL(std::string(text, size > 0 ? std::size_t(size) : 0), expected);
  }
  close(ends[0]);
  close(ends[1]);
}

TEST("a message begins below a line that is being redrawn") {
  CHECK_EQUAL(errorsOf([] {
                setLineOpen(true);
                complain("one");
                complain("two");
              }),
              "\nraytracer: one\nraytracer: two\n");
}

TEST("where standard error is closed, messages are lost and the program goes on") {
  const check::ScratchFolder folder;
  folder.write("scene.txt", check::smallScene());
  CHECK_EQUAL(check::runProgram("-input scene.txt -output a 2>&-", folder.path()).status, 0);
  CHECK_EQUAL(check::runProgram("-unknown 2>&-", folder.path()).status, 2);
}
