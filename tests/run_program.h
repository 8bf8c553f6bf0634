// Runs the real program, as a user's shell would, and keeps what it said.
#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "check.h"

namespace check {

struct ProgramRun {
  int status;          ///< exit status; 128 + the signal's number where one ended the program
  std::string output;  ///< what it wrote to standard output
  std::string errors;  ///< what it wrote to standard error
};

/// The whole file, "" where there is none.
inline std::string contentOf(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void writeFile(const std::string& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

/// `word` as one word of a shell command.
inline std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// A new empty folder for one test, removed with everything in it at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    static int count = 0;
    path_ =
        temporaryFolder() + "/scratch_" + std::to_string(getpid()) + "_" + std::to_string(count++);
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& content) const {
    writeFile(file(name), content);
    return file(name);
  }
  std::size_t fileCount() const {
    const std::filesystem::directory_iterator files(path_);
    return std::size_t(std::distance(begin(files), end(files)));
  }

 private:
  std::string path_;
};

/// Runs `raytracer` with `arguments` (a piece of shell command: redirections work, and quoted()
/// protects names) in `folder`, or in the current one. `before` comes before the program's name,
/// e.g. "ulimit -f 1;".
inline ProgramRun runProgram(const std::string& arguments, const std::string& folder = ".",
                             const std::string& before = "") {
  const ScratchFolder scratch;
  const std::string output = scratch.file("stdout"), errors = scratch.file("stderr");
  const std::string command = "cd " + quoted(folder) + " && { " + before + " " +
                              quoted(check::programToTest()) + " " + arguments + "; } >" +
                              quoted(output) + " 2>" + quoted(errors) + " </dev/null";
  const int result = std::system(command.c_str());
  const int status = WIFEXITED(result) ? WEXITSTATUS(result) : 128 + WTERMSIG(result);
  return {status, contentOf(output), contentOf(errors)};
}

/// A small scene: a red sphere seen straight on.
inline std::string smallScene() {
  return "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 40 }\n"
         "Lights { numLights 1 DirectionalLight { direction -1 -1 -1 color 1 1 1 } }\n"
         "Background { color 0.2 0.2 0.2 ambientLight 0.1 0.1 0.1 }\n"
         "Materials { numMaterials 1 PhongMaterial { diffuseColor 1 0 0 } }\n"
         "Group { numObjects 1 MaterialIndex 0 Sphere { center 0 0 0 radius 1 } }\n";
}

}  // namespace check
