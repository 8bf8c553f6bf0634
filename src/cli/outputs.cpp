// The files of a run: what each kind of output is, whether all names are of different files, and
// writing what has been rendered.
//
// A file may be named more than once in different words. Two names are one file where the system
// says so (it compares device and number), or, for files that are not there yet, where following
// all links leads both to one path.
//
// An output goes through three steps, each for all outputs of the run: can it be written
// (markUnwritable), which leaves the disk as it is; an image of its size (makeImages), which is
// one that the renderer fills where the table kKinds says so; the file (writeAll).
#include "cli/outputs.h"

#include <algorithm>
#include <filesystem>

#include "cli/program.h"
#include "image/output_file.h"
#include "render/film.h"

namespace {

namespace fs = std::filesystem;
using Kind = OutputRequest::Kind;

// "-" by the name of a device: what an output goes to and an input comes from.
std::string outputPath(const std::string& file) { return file == "-" ? "/dev/stdout" : file; }
std::string inputPath(const std::string& file) { return file == "-" ? "/dev/stdin" : file; }

/// True when both names lead to the same place, whether or not there is a file yet.
bool isSamePlace(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::is_character_file(a, error)) return false;
  return fs::equivalent(a, b, error) || outputTarget(a) == outputTarget(b);
}

/// The argument that prints lines on standard output, where no picture can go then; "" where none
/// does. Of several the first is as good as any for the message.
std::string printingArgument(const ResultRequest& results) {
  if (results.stats) return "-stats";
  if (results.pixel) return "-pixel";
  if (results.find(Kind::heatmap)) return "-heatmap";
  if (results.find(Kind::materials)) return "-materials";
  return results.preview ? "-preview" : "";
}

constexpr const char* kDifferentFiles = ": expected different files, found '";

/// Calls work(output) for each output that has a file and has not failed before. Complains of each
/// that fails now, for whatever reason, and marks it; returns how many did not. One that fails
/// costs none of the others. They come in the order of their kinds, so that their messages do too.
template <class Work>
std::size_t attemptEach(std::vector<Output>& outputs, const Work& work) {
  std::size_t done = 0;
  for (Output& output : outputs) {
    if (output.file.empty() || !output.isWritable) continue;
    output.isWritable = false;
    try {
      work(output);
      output.isWritable = true;
      ++done;
    } catch (const std::bad_alloc&) {
      complain(outputTitle(output.file) + ": not enough memory to write it");
    } catch (const std::exception& error) {
      complain(error.what());
    }
  }
  return done;
}

/// What the renderer fills for each kind of output, in the order of Kind; null where it does not.
struct KindRow {
  Image* RenderTargets::*image;
  FloatImage* RenderTargets::*exact;
};
constexpr KindRow kKinds[] = {
    {&RenderTargets::color, &RenderTargets::exactColor},
    {&RenderTargets::depth, &RenderTargets::exactDepth},
    {&RenderTargets::normals, &RenderTargets::exactNormals},
    {&RenderTargets::samples, nullptr},
    {nullptr, nullptr},  // filter
    {&RenderTargets::materials, nullptr},
    {nullptr, nullptr},  // heatmap
    {nullptr, nullptr},  // rays
};

const KindRow& rowOf(Kind kind) { return kKinds[std::size_t(kind)]; }

/// PFM alone keeps colours as they were computed, and only of pictures that have such.
bool wantsFloats(const Output& output) {
  return rowOf(output.kind).exact && output.format == PictureFormat::pfm;
}

/// In the form that its kind and the ending of its file ask for. Throws OutputError.
void write(const Output& output, int threads) {
  if (output.kind == Kind::rays) {
    return writeFile(output.file, output.text.data(), output.text.size());
  }
  if (wantsFloats(output)) return writePicture(output.exact, output.file);
  writePicture(output.image, output.file, threads, output.part, output.format);
}

}  // namespace

bool isSameOutput(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  return (a == "-" && b == "-") || isSamePlace(outputPath(a), outputPath(b));
}

void checkDifferent(const std::string& arguments, const std::string& a, const std::string& b) {
  refuseIf(isSameOutput(a, b), arguments, kDifferentFiles, a, "' and '", b, "'");
}

void checkFiles(const RenderRequest& render, const std::string& checkpoint,
                const std::vector<std::string>& inputFiles) {
  const std::string& scene = render.picture.scene;
  const std::string printing = printingArgument(render.results);
  std::vector<std::pair<std::string, std::string>> outputs;  // arguments and their files
  for (const OutputRequest& output : render.results.outputs) {
    outputs.emplace_back(output.argument, output.file);
  }
  if (!checkpoint.empty()) outputs.emplace_back("-checkpoint", checkpoint);
  // Each output against the scene, standard output where lines go there, the outputs before it, and
  // the files that the scene reads.
  for (const auto& [argument, file] : outputs) {
    refuseIf(isSamePlace(inputPath(scene), outputPath(file)), "-input and ", argument,
             kDifferentFiles, scene, "' and '", file, "'");
    refuseIf(!printing.empty() && isSameOutput(file, "-"), printing,
             ": expected standard output for its lines, found an image there");
    for (const auto& [other, otherFile] : outputs) {
      if (other == argument) break;
      checkDifferent(std::string(other).append(" and ").append(argument), otherFile, file);
    }
    for (const std::string& input : inputFiles) {
      refuseIf(isSameOutput(input, file), argument,
               ": expected a file that the scene does not read, found '", file,
               "', one of its meshes or pictures");
    }
  }
}

std::vector<Output> outputsOf(const RenderRequest& render) {
  const PictureRequest& picture = render.picture;
  std::vector<Output> outputs;
  for (const OutputRequest& output : render.results.outputs) {
    outputs.emplace_back(output, picture.isPart ? PictureFormat::tga : picture.course->format);
  }
  return outputs;
}

/// Nothing is written or created for that. A picture that is too large for its format is told now,
/// and not when hours of tracing are over.
std::size_t markUnwritable(std::vector<Output>& outputs, const PictureRequest& picture) {
  return attemptEach(outputs, [&picture](const Output& output) {
    const bool isWhole = output.kind == Kind::filter;
    if (output.kind != Kind::rays && !wantsFloats(output)) {
      checkPictureSize(output.file, output.format,
                       (isWhole ? picture.width : picture.area.width()) * output.zoom,
                       (isWhole ? picture.height : picture.area.height()) * output.zoom);
    }
    checkOutput(output.file);
  });
}

/// The window counts from the lower left corner, as the camera does.
RenderTargets makeImages(std::vector<Output>& outputs, const PictureRequest& picture) {
  const PixelRectangle& area = picture.area;
  RenderTargets targets;
  targets.hasSignedNormals = picture.course->hasSignedNormals;
  targets.window = {area.left, area.bottom, picture.width, picture.height};
  for (Output& output : outputs) {
    // The filter's picture has nothing to do with rays, and that of one pixel's rays is a text.
    if (output.kind == Kind::filter) {
      const Filter filter(picture.render.sampling);
      output.image = drawFilter(filter, picture.width, picture.height, output.zoom);
    } else if (output.kind != Kind::rays) {
      output.image = Image(area.width() * output.zoom, area.height() * output.zoom);
    }
    const KindRow& row = rowOf(output.kind);
    if (row.image) targets.*row.image = &output.image;
    if (wantsFloats(output)) {
      output.exact = FloatImage(area.width(), area.height());
      targets.*row.exact = &output.exact;
    }
    if (output.kind == Kind::samples) targets.samplesZoom = output.zoom;
    if (output.kind != Kind::depth) continue;
    targets.depthMin = output.depthMin;
    targets.depthMax = output.depthMax;
    if (picture.course->isNearBlack) std::swap(targets.depthMin, targets.depthMax);
  }
  return targets;
}

bool wantsRays(const std::vector<Output>& outputs) {
  // The heat map and the rays of a pixel are traced besides, by their own means.
  const auto isTraced = [](const Output& output) { return rowOf(output.kind).image; };
  return std::any_of(outputs.begin(), outputs.end(), isTraced);
}

std::size_t writeAll(std::vector<Output>& outputs, int threads) {
  return attemptEach(outputs, [threads](const Output& output) { write(output, threads); });
}
