// The pictures of scenes/, as every build of the program on every machine must give them.
#include <cstdio>

#include "check.h"
#include "run_program.h"

namespace {

/// The exit status and all output of tests/golden.sh on the program of this build.
check::ProgramRun runGolden(const std::string& mode) {
  const check::ScratchFolder scratch;
  const std::string output = scratch.file("output");
  const std::string command = "RUNNER= sh " + check::quoted(check::testsFolder() + "/golden.sh") +
                              " " + mode + " " + check::quoted(check::programToTest()) + " >" +
                              check::quoted(output) + " 2>&1 </dev/null";
  const int result = std::system(command.c_str());
  return {WIFEXITED(result) ? WEXITSTATUS(result) : -1, check::contentOf(output), ""};
}

TEST("every scene and option set gives the bytes of tests/golden.txt") {
  const check::ProgramRun run = runGolden("check");
  if (run.status == 77) SKIP("no sha256sum here");
  CHECK_EQUAL(run.status, 0);
  if (run.status != 0) std::printf("%s", run.output.c_str());
}

TEST("tests/golden.sh takes no other mode for a comparison") {
  CHECK_EQUAL(runGolden("chekc").status, 2);
}

}  // namespace
