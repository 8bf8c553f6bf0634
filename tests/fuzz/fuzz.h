// What the fuzz targets share: demands on what the program does with an input, and scratch files.
// A target is the function LLVMFuzzerTestOneInput; libFuzzer calls it with inputs that it makes up,
// replay.cpp with files. What it demands holds for every input whatsoever.
#pragma once
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

/// Does one input; returns 0. Ends the process where a demand is not met.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

/// Ends the process, saying `claim`, where it does not hold.
inline void demand(bool holds, const std::string& claim) {
  if (holds) return;
  std::fflush(stdout);
  std::fprintf(stderr, "not so: %s\n", claim.c_str());
  std::abort();
}

/// True when a message to the user is one line that prints.
inline bool isPlainLine(const std::string& message) {
  for (const char c : message) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return false;
  }
  return !message.empty();
}

/// A folder of this process alone, removed at its end unless that is a crash.
class Scratch {
 public:
  Scratch() {
    const auto path =
        std::filesystem::temp_directory_path() / ("raytracer_fuzz_" + std::to_string(getpid()));
    std::filesystem::create_directories(path);
    path_ = path.string();
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  /// Writes a file anew, in a folder that is made for it where there is none, and returns its path.
  std::string write(const std::string& name, const std::string& content) const {
    const std::string path = path_ + "/" + name;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

 private:
  std::string path_;
};

}  // namespace fuzz
