// A folder in which tests run the program as a user would.
#pragma once
#include <string>

#include "run_program.h"

namespace check {

inline bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}
inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A folder with scene.txt, where the program is run.
struct Desk : ScratchFolder {
  Desk() { write("scene.txt", smallScene()); }

  ProgramRun run(const std::string& arguments, const std::string& before = "") const {
    return runProgram(arguments, path(), before);
  }
};

}  // namespace check
