// Where hostile inputs are tried: bounded in time and memory, with what such a run must show.
#pragma once
#include <filesystem>
#include <string>

#include "check.h"
#include "run_program.h"
#include "sanitizers.h"

namespace hostile {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline const std::string kCamera =
    "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 40 }\n";

/// A folder with scene.txt, where the program is run with `megabytes` of memory at most, for 100
/// seconds at most: seconds are enough, but other programs may keep the machine busy.
struct Desk : check::ScratchFolder {
  Desk() { write("scene.txt", check::smallScene()); }

  check::ProgramRun run(const std::string& arguments, long megabytes = 400) const {
    const std::string memory =
        kHasSanitizer ? "" : "ulimit -v " + std::to_string(megabytes * 1024) + "; ";
    return check::runProgram("-quiet -threads 2 " + arguments, path(), memory + "timeout 100");
  }

  /// The scene is at fault, in one message with the place and what it is.
  void checkFault(const check::ProgramRun& run, const std::string& place,
                  const std::string& part) const {
    CHECK_EQUAL(run.status, 3);
    check::report(run.errors.rfind("raytracer: " + place + ": ", 0) == 0, __FILE__, __LINE__,
                  "'" + run.errors.substr(0, 500) + "' begins with '" + place + "'");
    check::report(contains(run.errors, part), __FILE__, __LINE__,
                  "'" + run.errors.substr(0, 500) + "' contains '" + part + "'");
    CHECK(run.errors.size() < 1000);
    CHECK(!std::filesystem::exists(file("out.tga")));
  }

  /// Both ways of asking the scene finish, and give the same picture.
  void checkPicture(const std::string& arguments) const {
    for (const char* accel : {"fast", "tree"}) {
      const auto run =
          this->run(arguments + " -accel " + accel + " -output " + accel + std::string(".tga"));
      CHECK_EQUAL(run.status, 0);
      CHECK_EQUAL(run.errors, "");
    }
    CHECK(!check::contentOf(file("fast.tga")).empty());
    CHECK(check::contentOf(file("fast.tga")) == check::contentOf(file("tree.tga")));
  }
};

}  // namespace hostile
