// Rendering: parse, compile once, trace, write.
#include "cli/render_run.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/checkpoint.h"
#include "cli/fingerprint.h"
#include "cli/inspection.h"
#include "cli/messages.h"
#include "cli/out_of_memory.h"
#include "cli/part_arguments.h"
#include "cli/part_id.h"
#include "cli/picture_targets.h"
#include "cli/run_display.h"
#include "cli/scene_geometry.h"
#include "cli/scene_input.h"
#include "cli/stats.h"
#include "render/renderer.h"
#include "system/worker_threads.h"

namespace {

/// Under a limit only so many that their stacks, of 2 MB and more, leave room for the rest.
int threadCount(const Options& options) {
  constexpr int kMegabytesEach = 8;
  const int wanted =
      options.threads > 0 ? options.threads : std::min(hardwareThreads(), kMaxThreads);
  if (options.memoryLimit == 0) return wanted;
  return std::min(wanted, std::max(1, options.memoryLimit / kMegabytesEach));
}

/// What one thread counts, apart from the others' in memory.
struct alignas(128) ThreadCounts {
  RayCounts rays;
};

/// Renders, and enters in `stats` what the threads have counted.
void renderCounted(const SceneParser& scene, const SceneGeometry& geometry, const Options& options,
                   const RenderTargets& targets, Stats& stats) {
  std::vector<ThreadCounts> counts(std::size_t(stats.threads));
  std::vector<WorkerView> views;
  for (ThreadCounts& each : counts) {
    views.push_back({&geometry.object(), &each.rays});
  }
  render(scene, geometry.object(), options.render, stats.threads, targets, views);
  stats.pixels = double(renderedArea(options).pixelCount());
  stats.countsTests = options.gridPicture == Options::GridPicture::none;
  stats.tests = geometry.tallied();
  for (const ThreadCounts& each : counts) {
    stats.rays.add(each.rays);
  }
}

/// Builds what answers for the scene's objects, then traces; enters both in `stats`. At last
/// `inspectAll(geometry)` is called.
template <class InspectAll>
void renderAll(const SceneParser& scene, const Options& options, const RenderTargets& targets,
               Stats& stats, const InspectAll& inspectAll) {
  stats.threads = threadCount(options);
  Stopwatch watch;
  const SceneGeometry geometry(*scene.getGroup(), options, stats.threads);
  stats.simd = geometry.simd();
  stats.tree = geometry.description();
  stats.buildSeconds = watch.restart();
  if (options.stats) {
    renderCounted(scene, geometry, options, targets, stats);
  } else if (wantsRays(targets)) {
    render(scene, geometry.object(), options.render, stats.threads, targets);
  }
  stats.traceSeconds = watch.restart();
  inspectAll(geometry.object());
}

/// What is left to do when all is rendered.
struct Rendered {
  std::unique_ptr<Checkpoint> checkpoint;  ///< null where none is wanted
  std::string lastLines;                   ///< to be printed last
  int status = kDone;                      ///< kOutputFailed where the preview could not be shown
};

/// A checkpoint needs them all: its tiles hold the pixels of every picture, for the run that can
/// write them again.
void dropUnwritable(std::vector<Output>& outputs) {
  const auto isUnwritable = [](const Output& output) { return !output.isWritable; };
  outputs.erase(std::remove_if(outputs.begin(), outputs.end(), isUnwritable), outputs.end());
}

/// Tells the outputs, where they are parts, which picture they belong to.
void setPlaces(const SceneParser& scene, const Digest& sceneDigest, const Options& options,
               std::vector<Output>& outputs) {
  if (!options.part.isWanted()) return;
  const PixelRectangle area = renderedArea(options);
  for (Output& output : outputs) {
    const PartId id =
        partIdOf(output.kind, options, sceneDigest, scene.getMeshFiles(), threadCount(options));
    output.place = {area.left, options.height - area.top, textOf(id)};
  }
}

/// Gives every output its picture; where -stats or -preview wants rays and no output does, traces
/// all the same. Where a checkpoint is wanted, `scene` is what notes.digest is of, and the
/// checkpoint is returned.
Rendered renderOutputs(const SceneParser& scene, const ReadNotes& notes, const Options& options,
                       std::vector<Output>& outputs, Stats& stats) {
  const PixelRectangle area = renderedArea(options);
  const std::string size =
      std::to_string(area.width()) + " x " + std::to_string(area.height()) + " pixels";
  Image unwritten;
  std::optional<MaterialColors> materialColors;
  RenderTargets targets = withMemory("for images of " + size, [&] {
    makeImages(outputs, options);
    return targetsOf(options, outputs, unwritten);
  });
  if (targets.materials) targets.materialColors = &materialColors.emplace(scene);
  Rendered rendered;
  const bool isTraced = wantsRays(targets);
  if (isTraced && !options.checkpoint.empty()) {
    const Digest picture =
        pictureFingerprint(options, notes.digest, scene.getMeshFiles(), threadCount(options));
    rendered.checkpoint = openCheckpoint(options.checkpoint, picture, targets, options.quiet);
    targets.store = rendered.checkpoint.get();
  }
  RunDisplay display(options, targets);
  if (display.isWanted()) targets.listener = &display;
  const auto inspectAll = [&](const Object3D& geometry) {
    display.finish();
    rendered.status = print(display.lastPicture());
    const InspectedScene inspected = {scene, notes.places, geometry};
    drawHeatmap(inspected, options, stats.threads, outputs);
    rendered.lastLines = inspectPixel(inspected, options, outputs);
  };
  if (isTraced || wantsInspection(options)) {
    withMemory("to render " + size, [&] { renderAll(scene, options, targets, stats, inspectAll); });
  }
  if (rendered.checkpoint) rendered.checkpoint->stop();
  const Image* const untraced = isTraced ? nullptr : untracedPicture(outputs);
  if (options.preview && untraced) rendered.status = print(pictureText(*untraced));
  return rendered;
}

}  // namespace

std::vector<Output> renderPictures(const Options& options) {
  Stats stats;
  ReadNotes notes;
  SceneParser scene = readScene(options, notes);
  prepareScene(scene, options);
  std::vector<Output> outputs = wantedOutputs(options);
  const Rendered rendered = renderOutputs(scene, notes, options, outputs, stats);
  if (rendered.checkpoint) rendered.checkpoint->remove();
  return outputs;
}

int renderScene(const Options& options) {
  Stats stats;
  Stopwatch watch;
  ReadNotes notes;
  SceneParser scene = readScene(options, notes);
  checkFiles(options, scene.getMeshFiles());
  prepareScene(scene, options);
  stats.readSeconds = watch.restart();

  std::vector<Output> outputs = wantedOutputs(options);
  const std::size_t wanted = outputs.size();
  if (markUnwritable(outputs) == 0 && wanted > 0) return kOutputFailed;
  if (options.checkpoint.empty()) dropUnwritable(outputs);
  setPlaces(scene, notes.digest, options, outputs);
  const Rendered rendered = renderOutputs(scene, notes, options, outputs, stats);
  watch.restart();
  const std::size_t written = writeAll(outputs, threadCount(options));
  if (rendered.checkpoint && written == wanted) rendered.checkpoint->remove();
  stats.writeSeconds = watch.restart();
  const std::string statsText = options.stats ? stats.text() : "";
  const int printed = print(legendOf(scene, outputs) + statsText + rendered.lastLines);
  return written == wanted ? std::max(printed, rendered.status) : kOutputFailed;
}
