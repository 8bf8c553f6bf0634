// Files that a command line names more than once, perhaps in different words.
#include "cli/file_names.h"

#include <filesystem>

namespace {

namespace fs = std::filesystem;

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

/// A file of a run and what names it, for messages.
struct Named {
  const char* argument;
  std::string file;
};

const char* argumentOf(OutputRequest::Kind kind) {
  switch (kind) {
    case OutputRequest::Kind::color:
      return "-output";
    case OutputRequest::Kind::depth:
      return "-depth";
    case OutputRequest::Kind::normals:
      return "-normals";
    case OutputRequest::Kind::samples:
      return "-render_samples";
    case OutputRequest::Kind::filter:
      return "-render_filter";
    case OutputRequest::Kind::materials:
      return "-materials";
    case OutputRequest::Kind::heatmap:
      return "-heatmap";
    default:
      return "-pixel_obj";
  }
}

/// The argument that prints on standard output, or "" where none does.
std::string printingArgument(const ResultRequest& results) {
  if (results.stats) return "-stats";
  if (results.pixel) return "-pixel";
  if (results.find(OutputRequest::Kind::heatmap)) return "-heatmap";
  if (results.find(OutputRequest::Kind::materials)) return "-materials";
  return results.preview ? "-preview" : "";
}

[[noreturn]] void refuse(const Named& a, const Named& b) {
  throw UsageError(std::string(a.argument) + " and " + b.argument +
                   ": expected different files, found '" + a.file + "' and '" + b.file + "'");
}

}  // namespace

bool isSameOutput(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  return (a == "-" && b == "-") || sameFile(outputPath(a), outputPath(b));
}

void checkMergedFiles(const MergeRequest& merge) {
  for (const std::string& part : merge.parts) {
    if (isSameOutput(part, merge.output)) refuse({"-merge: OUT", merge.output}, {"PART", part});
  }
}

void checkFiles(const RenderRequest& render, const std::string& checkpoint,
                const std::vector<std::string>& meshFiles) {
  const Named input = {"-input", render.picture.scene};
  std::vector<Named> outputs;
  for (const OutputRequest& output : render.results.outputs) {
    outputs.push_back({argumentOf(output.kind), output.file});
  }
  if (!checkpoint.empty()) outputs.push_back({"-checkpoint", checkpoint});
  const std::string printing = printingArgument(render.results);
  for (const Named& output : outputs) {
    if (isInput(input.file, output.file)) refuse(input, output);
    if (!printing.empty() && isSameOutput(output.file, "-")) {
      throw UsageError(printing + ": expected standard output for its lines, found an image there");
    }
    for (const Named* other = outputs.data(); other != &output; ++other) {
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
