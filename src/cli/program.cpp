// The run of the program: parse, compile, trace, write.
#include "cli/program.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <new>

#include "cli/option_table.h"
#include "cli/outputs.h"
#include "cli/sampling_arguments.h"
#include "cli/scene_geometry.h"
#include "cli/stats.h"
#include "render/renderer.h"
#include "scene/scene_parser.h"
#include "system/worker_threads.h"

namespace {

/// Enough to read the deepest scene (measured: below 1 MB, 4 MB with sanitizers), whatever limit
/// the user's shell sets for the first thread.
constexpr std::size_t kRunStack = 8 << 20;

/// Returns work(); where memory runs out, throws an error that says what it was needed for.
template <class Work>
auto withMemory(const std::string& purpose, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw std::runtime_error("not enough memory " + purpose);
  }
}

std::string displayName(const std::string& input) {
  return input == "-" ? "standard input" : input;
}

int print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return kDone;
  complain("cannot write to standard output");
  return kOutputFailed;
}

int checkScene(const Options& options) {
  std::vector<std::string> warnings;
  const std::vector<InputError> mistakes = withMemory("to read " + displayName(options.input), [&] {
    return SceneParser::check(options.input.c_str(), options.quiet ? nullptr : &warnings);
  });
  for (const std::string& warning : warnings) complain("warning: " + warning);
  for (const InputError& mistake : mistakes) complain(mistake.what());
  if (!mistakes.empty()) return kSceneAtFault;
  return print(displayName(options.input) + ": no mistakes found\n");
}

int threadCount(const Options& options) {
  return options.threads > 0 ? options.threads : std::min(hardwareThreads(), kMaxThreads);
}

bool needsClosedMeshes(const RenderOptions& render) {
  return render.transparentShadows || render.nestedDielectrics || render.fresnel;
}

bool wantsRays(const RenderTargets& targets) {
  return targets.color || targets.depth || targets.normals || targets.samples;
}

/// Where the pictures go that need rays; where -stats needs one, it is what `unwritten` holds.
RenderTargets targetsOf(const Options& options, std::vector<Output>& outputs, Image& unwritten) {
  RenderTargets targets;
  for (Output& output : outputs) {
    if (output.kind == Output::Kind::color) targets.color = &output.image;
    if (output.kind == Output::Kind::depth) targets.depth = &output.image;
    if (output.kind == Output::Kind::normals) targets.normals = &output.image;
    if (output.kind == Output::Kind::samples) targets.samples = &output.image;
  }
  targets.depthMin = options.depthMin;
  targets.depthMax = options.depthMax;
  targets.samplesZoom = options.samplesZoom;
  if (!wantsRays(targets) && options.stats) {
    unwritten = Image(options.width, options.height);
    targets.color = &unwritten;
  }
  return targets;
}

/// What one thread counts, apart from the others' in memory.
struct alignas(128) ThreadCounts {
  RayCounts rays;
  RayTestCounts tests;
  std::unique_ptr<const Object3D> geometry;
};

/// Renders, and enters in `stats` what the threads have counted.
void renderCounted(const SceneParser& scene, const SceneGeometry& geometry, const Options& options,
                   const RenderTargets& targets, Stats& stats) {
  std::vector<ThreadCounts> counts(std::size_t(stats.threads));
  std::vector<WorkerView> views;
  for (ThreadCounts& each : counts) {
    each.geometry = geometry.counting(each.tests);
    stats.countsTests = each.geometry != nullptr;
    views.push_back({each.geometry ? each.geometry.get() : &geometry.object(), &each.rays});
  }
  render(scene, geometry.object(), options.render, stats.threads, targets, views);
  stats.pixels = double(options.width) * options.height;
  for (const ThreadCounts& each : counts) {
    stats.rays.add(each.rays);
    stats.tests.add(each.tests);
  }
}

/// Builds what answers for the scene's objects, then traces; enters both in `stats`.
void renderAll(const SceneParser& scene, const Options& options, const RenderTargets& targets,
               Stats& stats) {
  stats.threads = threadCount(options);
  Stopwatch watch;
  const SceneGeometry geometry(*scene.getGroup(), options, stats.threads);
  stats.simd = geometry.simd();
  stats.tree = geometry.description();
  stats.buildSeconds = watch.restart();
  if (options.stats) {
    renderCounted(scene, geometry, options, targets, stats);
  } else {
    render(scene, geometry.object(), options.render, stats.threads, targets);
  }
  stats.traceSeconds = watch.restart();
}

void warnOfSimd(const Options& options) {
  const SimdLevel available = availableSimd(options.simd);
  if (options.simd == SimdLevel::automatic || available == options.simd) return;
  complain(std::string("warning: -simd ") + nameOf(options.simd) +
           ": this processor does not have it; " + nameOf(available) + " is used");
}

void printWarnings(const SceneParser& scene, const Options& options) {
  if (options.quiet) return;
  for (const std::string& warning : scene.getWarnings()) complain("warning: " + warning);
  warnOfSimd(options);
  const std::string rounding = roundingWarning(options);
  if (!rounding.empty()) complain("warning: " + rounding);
}

int renderScene(const Options& options) {
  Stats stats;
  Stopwatch watch;
  SceneParser scene = withMemory("to read " + displayName(options.input),
                                 [&] { return SceneParser(options.input.c_str()); });
  checkFiles(options, scene.getMeshFiles());
  printWarnings(scene, options);
  if (needsClosedMeshes(options.render)) {
    withMemory("to find closed meshes", [&] { scene.findClosedMeshes(); });
  }
  stats.readSeconds = watch.restart();

  std::vector<Output> outputs = wantedOutputs(options);
  const std::size_t wanted = outputs.size();
  dropUnwritable(outputs);
  if (outputs.empty() && wanted > 0) return kOutputFailed;
  const std::string size =
      std::to_string(options.width) + " x " + std::to_string(options.height) + " pixels";
  Image unwritten;
  const RenderTargets targets = withMemory("for images of " + size, [&] {
    makeImages(outputs, options);
    return targetsOf(options, outputs, unwritten);
  });
  if (wantsRays(targets)) {
    withMemory("to render " + size, [&] { renderAll(scene, options, targets, stats); });
  }
  watch.restart();
  const std::size_t written = writeAll(outputs);
  stats.writeSeconds = watch.restart();
  const int printed = options.stats ? print(stats.text()) : kDone;
  return written == wanted ? printed : kOutputFailed;
}

int runHere(const Options& options) {
  if (options.shortHelp) return print(shortHelp());
  if (options.help) return print(fullHelp());
  if (options.version) return print(versionText() + "\n");
  if (options.man) return print(manPage());
  if (options.completion) return print(completionScript());
  if (options.check) return checkScene(options);
  checkFiles(options);
  return renderScene(options);
}

}  // namespace

int runProgram(const Options& options) {
  int status = kDone;
  runOnThreads(1, kRunStack, [&](int) { status = runHere(options); });
  return status;
}

void complain(const std::string& message) {
  const std::string line = "raytracer: " + message + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}
