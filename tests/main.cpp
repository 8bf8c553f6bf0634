// Runs the registered tests: all of them, or those of one file (`unit_tests sphere_test`).
// Exit status 0 when all passed, 1 when any failed, 77 when all were skipped.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <vector>

#include "check.h"

namespace {

struct TestCase {
  std::string unit;  // file name without folder and ending
  const char* name;
  void (*function)();
};

std::vector<TestCase>& tests() {
  static std::vector<TestCase> list;
  return list;
}

int checksInTest = 0, failuresInTest = 0;

enum class Outcome { passed, failed, skipped };

Outcome run(const TestCase& test) {
  checksInTest = failuresInTest = 0;
  try {
    test.function();
  } catch (const check::Skipped& skipped) {
    std::printf("skipped: %s (%s)\n", test.name, skipped.reason.c_str());
    return Outcome::skipped;
  } catch (const std::exception& error) {
    check::report(false, test.unit.c_str(), 0,
                  std::string("unexpected exception: ") + error.what());
  }
  if (checksInTest == 0) check::report(false, test.unit.c_str(), 0, "the test checked nothing");
  std::printf("%s: %s\n", failuresInTest == 0 ? "ok" : "FAILED", test.name);
  return failuresInTest == 0 ? Outcome::passed : Outcome::failed;
}

}  // namespace

namespace check {

Registration::Registration(const char* file, const char* name, void (*function)()) {
  tests().push_back({std::filesystem::path(file).stem().string(), name, function});
}

void report(bool ok, const char* file, int line, const std::string& text) {
  ++checksInTest;
  if (ok) return;
  ++failuresInTest;
  std::printf("%s:%d: failed: %s\n", file, line, text.c_str());
}

std::string temporaryFolder() {
  const std::string folder = TEST_OUTPUT_FOLDER;
  std::filesystem::create_directories(folder);
  return folder;
}
std::string testsFolder() { return TEST_SOURCE_FOLDER; }
std::string programToTest() { return RAYTRACER_PROGRAM; }
std::string referenceFolder() {
  const char* given = std::getenv("RAYTRACER_REFERENCE");
  return given ? given : testsFolder() + "/../../shared/reference";
}

}  // namespace check

int main(int argc, char** argv) {
  int passed = 0, failed = 0, skipped = 0;
  for (const TestCase& test : tests()) {
    if (argc > 1 && test.unit != argv[1]) continue;
    const Outcome outcome = run(test);
    (outcome == Outcome::passed ? passed : outcome == Outcome::failed ? failed : skipped)++;
  }
  std::printf("%d passed, %d failed, %d skipped\n", passed, failed, skipped);
  if (failed > 0 || passed + skipped == 0) return 1;
  return passed == 0 ? 77 : 0;
}
