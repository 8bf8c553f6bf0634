// The run of the program: parse, compile, trace, write.
#include "cli/program.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>

#include "cli/checkpoint.h"
#include "cli/compare_run.h"
#include "cli/option_table.h"
#include "cli/outputs.h"
#include "cli/run_display.h"
#include "cli/sampling_arguments.h"
#include "cli/scene_geometry.h"
#include "cli/stats.h"
#include "render/renderer.h"
#include "scene/mistake_log.h"
#include "scene/scene_parser.h"
#include "scene/source_text.h"
#include "system/memory_limit.h"
#include "system/worker_threads.h"

namespace {

/// Enough to read the deepest scene (measured: below 1 MB, 4 MB with sanitizers), whatever limit
/// the user's shell sets for the first thread.
constexpr std::size_t kRunStack = 8 << 20;

class OutOfMemory : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns work(); where memory runs out, throws OutOfMemory, which says what it was needed for.
template <class Work>
auto withMemory(const std::string& purpose, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw OutOfMemory("not enough memory " + purpose);
  }
}

std::string displayName(const std::string& input) {
  return input == "-" ? "standard input" : input;
}

int checkScene(const Options& options) {
  std::vector<std::string> warnings;
  const std::vector<InputError> mistakes = withMemory("to read " + displayName(options.input), [&] {
    return SceneParser::check(options.input.c_str(), options.quiet ? nullptr : &warnings);
  });
  for (const std::string& warning : warnings) complain("warning: " + warning);
  for (const InputError& mistake : mistakes) complain(mistake.what());
  if (mistakes.size() >= MistakeLog::kCapacity) {
    complain(displayName(options.input) + ": reading ended with mistake number " +
             std::to_string(mistakes.size()));
  }
  if (!mistakes.empty()) return kSceneAtFault;
  return print(displayName(options.input) + ": no mistakes found\n");
}

/// Under a limit only so many that their stacks, of 2 MB and more, leave room for the rest.
int threadCount(const Options& options) {
  constexpr int kMegabytesEach = 8;
  const int wanted =
      options.threads > 0 ? options.threads : std::min(hardwareThreads(), kMaxThreads);
  if (options.memoryLimit == 0) return wanted;
  return std::min(wanted, std::max(1, options.memoryLimit / kMegabytesEach));
}

bool needsClosedMeshes(const RenderOptions& render) {
  return render.transparentShadows || render.nestedDielectrics || render.fresnel;
}

bool wantsRays(const RenderTargets& targets) {
  return targets.color || targets.depth || targets.normals || targets.samples;
}

FloatImage* exactOf(Output& output) { return output.exact.Width() > 0 ? &output.exact : nullptr; }

/// Where the pictures go that need rays; where -stats needs one, it is what `unwritten` holds.
RenderTargets targetsOf(const Options& options, std::vector<Output>& outputs, Image& unwritten) {
  RenderTargets targets;
  for (Output& output : outputs) {
    if (output.kind == Output::Kind::color) {
      targets.color = &output.image;
      targets.exactColor = exactOf(output);
    }
    if (output.kind == Output::Kind::depth) {
      targets.depth = &output.image;
      targets.exactDepth = exactOf(output);
    }
    if (output.kind == Output::Kind::normals) {
      targets.normals = &output.image;
      targets.exactNormals = exactOf(output);
    }
    if (output.kind == Output::Kind::samples) targets.samples = &output.image;
  }
  targets.depthMin = options.depthMin;
  targets.depthMax = options.depthMax;
  targets.samplesZoom = options.samplesZoom;
  if (!wantsRays(targets) && (options.stats || options.preview)) {
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

/// Reads the scene; gives the digest of its bytes where a checkpoint needs it.
SceneParser readScene(const Options& options, Digest& digest) {
  return withMemory("to read " + displayName(options.input), [&] {
    const SourceText text = SourceText::read(options.input);
    const std::string_view bytes = text.bytes();
    if (!options.checkpoint.empty()) digest = sha256(bytes.data(), bytes.size());
    return SceneParser(text);
  });
}

void prepareScene(SceneParser& scene, const Options& options) {
  printWarnings(scene, options);
  if (needsClosedMeshes(options.render)) {
    withMemory("to find closed meshes", [&] { scene.findClosedMeshes(); });
  }
}

/// Gives every output its picture; where -stats wants rays and no output does, traces all the same.
/// Where a checkpoint is wanted, `scene` is what `sceneDigest` is of, and the checkpoint is
/// returned.
std::unique_ptr<Checkpoint> renderOutputs(const SceneParser& scene, const Digest& sceneDigest,
                                          const Options& options, std::vector<Output>& outputs,
                                          Stats& stats) {
  const std::string size =
      std::to_string(options.width) + " x " + std::to_string(options.height) + " pixels";
  Image unwritten;
  RenderTargets targets = withMemory("for images of " + size, [&] {
    makeImages(outputs, options);
    return targetsOf(options, outputs, unwritten);
  });
  std::unique_ptr<Checkpoint> checkpoint;
  if (wantsRays(targets)) {
    checkpoint =
        openCheckpoint(options, sceneDigest, scene.getMeshFiles(), threadCount(options), targets);
    targets.keeper = checkpoint.get();
    RunDisplay display(options, targets);
    if (display.isWanted()) targets.listener = &display;
    withMemory("to render " + size, [&] { renderAll(scene, options, targets, stats); });
    display.finish();
    stats.shown = print(display.lastPicture());
  }
  if (checkpoint) checkpoint->stop();
  return checkpoint;
}

int renderScene(const Options& options) {
  Stats stats;
  Stopwatch watch;
  Digest sceneDigest = {};
  SceneParser scene = readScene(options, sceneDigest);
  checkFiles(options, scene.getMeshFiles());
  prepareScene(scene, options);
  stats.readSeconds = watch.restart();

  std::vector<Output> outputs = wantedOutputs(options);
  const std::size_t wanted = outputs.size();
  dropUnwritable(outputs);
  if (outputs.empty() && wanted > 0) return kOutputFailed;
  const auto checkpoint = renderOutputs(scene, sceneDigest, options, outputs, stats);
  watch.restart();
  const std::size_t written = writeAll(outputs);
  if (checkpoint && written == wanted) checkpoint->remove();
  stats.writeSeconds = watch.restart();
  const int printed = options.stats ? print(stats.text()) : kDone;
  return written == wanted ? std::max(printed, stats.shown) : kOutputFailed;
}

int runHere(const Options& options) {
  if (options.shortHelp) return print(shortHelp());
  if (options.help) return print(fullHelp());
  if (options.version) return print(versionText() + "\n");
  if (options.man) return print(manPage());
  if (options.completion) return print(completionScript());
  if (options.check) return checkScene(options);
  if (options.compare.isWanted()) return runComparison(options);
  checkFiles(options);
  return renderScene(options);
}

int runOnOwnStack(const Options& options) {
  int status = kDone;
  runOnThreads(1, kRunStack, [&](int) { status = runHere(options); });
  return status;
}

/// Names the limit where it is what ended the run.
int runWithin(int megabytes, const Options& options) {
  const std::string limit = "-memory_limit " + std::to_string(megabytes) + ": ";
  limitMemory(std::size_t(megabytes) << 20);
  try {
    return runOnOwnStack(options);
  } catch (const std::bad_alloc&) {
    throw std::runtime_error(limit + "not enough memory");
  } catch (const OutOfMemory& error) {
    throw std::runtime_error(limit + error.what());
  } catch (const std::system_error& error) {  // no room for a thread's stack
    throw std::runtime_error(limit + error.what());
  }
}

}  // namespace

std::vector<Output> renderPictures(const Options& options) {
  Stats stats;
  Digest sceneDigest = {};
  SceneParser scene = readScene(options, sceneDigest);
  prepareScene(scene, options);
  std::vector<Output> outputs = wantedOutputs(options);
  const auto checkpoint = renderOutputs(scene, sceneDigest, options, outputs, stats);
  if (checkpoint) checkpoint->remove();
  return outputs;
}

int runProgram(const Options& options) {
  return options.memoryLimit > 0 ? runWithin(options.memoryLimit, options) : runOnOwnStack(options);
}

int print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return kDone;
  complain("cannot write to standard output");
  return kOutputFailed;
}

void complain(std::string_view message) {
  std::fprintf(stderr, "raytracer: %.*s\n", int(message.size()), message.data());
}
