// Files that a command line names more than once, perhaps in different words.
#include <filesystem>

#include "cli/options.h"

namespace {

namespace fs = std::filesystem;

struct Named {
  const char* argument;
  const std::string& file;  // empty where the argument was not given
};

/// A name for what an output goes to.
std::string outputPath(const std::string& file) { return file == "-" ? "/dev/stdout" : file; }

/// Where a file of this name is or would be created, links followed.
fs::path placeOf(const std::string& name) {
  constexpr int kMostLinks = 40;  // as Linux allows
  std::error_code error;
  fs::path place = fs::absolute(name, error);
  for (int i = 0; i < kMostLinks && fs::is_symlink(place, error) && !fs::exists(place, error); ++i)
    place = place.parent_path() / fs::read_symlink(place, error);
  const fs::path canonical = fs::weakly_canonical(place, error);
  return error ? place : canonical;
}

/// True when both names lead to the same place, whether or not there is a file yet.
bool sameFile(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::is_character_file(a, error)) return false;
  return (fs::equivalent(a, b, error) && !error) || placeOf(a) == placeOf(b);
}

}  // namespace

void checkFiles(const Options& options, const std::vector<std::string>& meshFiles) {
  const Named input = {"-input", options.input};
  const Named outputs[] = {{"-output", options.output},
                           {"-depth", options.depthOutput},
                           {"-normals", options.normalsOutput},
                           {"-render_samples", options.samplesOutput},
                           {"-render_filter", options.filterOutput},
                           {"-checkpoint", options.checkpoint}};
  const auto isSame = [](const std::string& a, const std::string& b) {
    if (a.empty() || b.empty()) return false;
    return (a == "-" && b == "-") || sameFile(outputPath(a), outputPath(b));
  };
  const bool inputHasName = input.file != "-";
  const auto refuse = [](const Named& a, const Named& b) {
    throw UsageError(std::string(a.argument) + " and " + b.argument +
                     ": expected different files, found '" + a.file + "' and '" + b.file + "'");
  };
  for (const Named& output : outputs) {
    if (inputHasName && isSame(input.file, output.file)) refuse(input, output);
    for (const Named* other = outputs; other != &output; ++other) {
      if (isSame(other->file, output.file)) refuse(*other, output);
    }
    for (const std::string& mesh : meshFiles) {
      if (!isSame(mesh, output.file)) continue;
      throw UsageError(std::string(output.argument) +
                       ": expected a file that the scene does not read, found '" + output.file +
                       "', one of its meshes");
    }
  }
}
