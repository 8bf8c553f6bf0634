// Files that a command line names more than once, perhaps in different words.
#include "cli/file_names.h"

#include <filesystem>

#include "cli/options.h"

namespace {

namespace fs = std::filesystem;

struct Named {
  const char* argument;
  const std::string& file;  // empty where the argument was not given
};

/// Names for what an output goes to and an input comes from.
std::string outputPath(const std::string& file) { return file == "-" ? "/dev/stdout" : file; }
std::string inputPath(const std::string& file) { return file == "-" ? "/dev/stdin" : file; }

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

bool isInput(const std::string& input, const std::string& output) {
  return !input.empty() && !output.empty() && sameFile(inputPath(input), outputPath(output));
}

/// The argument that prints on standard output, or "" where none does.
std::string printingArgument(const Options& options) {
  if (options.stats) return "-stats";
  if (options.tracesPixel) return "-pixel";
  if (!options.heatmapOutput.empty()) return "-heatmap";
  if (!options.materialsOutput.empty()) return "-materials";
  return options.preview ? "-preview" : "";
}

}  // namespace

bool isSameOutput(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  return (a == "-" && b == "-") || sameFile(outputPath(a), outputPath(b));
}

void checkFiles(const Options& options, const std::vector<std::string>& meshFiles) {
  const Named input = {"-input", options.input};
  const Named outputs[] = {{"-output", options.output},
                           {"-depth", options.depthOutput},
                           {"-normals", options.normalsOutput},
                           {"-render_samples", options.samplesOutput},
                           {"-render_filter", options.filterOutput},
                           {"-materials", options.materialsOutput},
                           {"-heatmap", options.heatmapOutput},
                           {"-pixel_obj", options.pixelObjOutput},
                           {"-checkpoint", options.checkpoint}};
  const auto refuse = [](const Named& a, const Named& b) {
    throw UsageError(std::string(a.argument) + " and " + b.argument +
                     ": expected different files, found '" + a.file + "' and '" + b.file + "'");
  };
  for (const std::string& part : options.merge.parts) {
    if (isSameOutput(part, options.merge.output))
      refuse({"-merge: OUT", options.merge.output}, {"PART", part});
  }
  const std::string printing = printingArgument(options);
  for (const Named& output : outputs) {
    if (isInput(input.file, output.file)) refuse(input, output);
    if (!printing.empty() && isSameOutput(output.file, "-")) {
      throw UsageError(printing + ": expected standard output for its lines, found an image there");
    }
    for (const Named* other = outputs; other != &output; ++other) {
      if (isSameOutput(other->file, output.file)) refuse(*other, output);
    }
    for (const std::string& mesh : meshFiles) {
      if (!isSameOutput(mesh, output.file)) continue;
      throw UsageError(std::string(output.argument) +
                       ": expected a file that the scene does not read, found '" + output.file +
                       "', one of its meshes");
    }
  }
}
