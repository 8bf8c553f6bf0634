// What the program says on standard error: every byte, and each line whole.
#include "cli/messages.h"

#include <fcntl.h>
#include <unistd.h>

#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "check.h"
#include "run_program.h"

namespace {

/// What work() writes to standard error.
template <class Work>
std::string errorsOf(const Work& work) {
  const check::ScratchFolder folder;
  const std::string file = folder.file("errors");
  const int before = dup(STDERR_FILENO);
  const int target = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  CHECK(before >= 0 && target >= 0);
  dup2(target, STDERR_FILENO);
  work();
  dup2(before, STDERR_FILENO);
  close(target);
  close(before);
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

TEST("lines of several threads do not mix") {
  constexpr int kThreads = 4, kLines = 300;
  const std::string errors = errorsOf([] {
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i) {
      threads.emplace_back([i] {
        for (int line = 0; line < kLines; ++line) complain(std::string(200, char('a' + i)));
      });
    }
    for (std::thread& thread : threads) thread.join();
  });
  std::istringstream lines(errors);
  int good = 0;
  for (std::string line; std::getline(lines, line);) {
    good += line == "raytracer: " + std::string(200, line.back());
  }
  CHECK_EQUAL(good, kThreads * kLines);
}

TEST("where standard error is closed, messages are lost and the program goes on") {
  const check::ScratchFolder folder;
  folder.write("scene.txt", check::smallScene());
  CHECK_EQUAL(check::runProgram("-input scene.txt -output a 2>&-", folder.path()).status, 0);
  CHECK_EQUAL(check::runProgram("-unknown 2>&-", folder.path()).status, 2);
}
