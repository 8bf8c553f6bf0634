// Rendering: parse, compile once, trace, write.
#include "cli/render_run.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/checkpoint.h"
#include "cli/file_names.h"
#include "cli/fingerprint.h"
#include "cli/inspection.h"
#include "cli/messages.h"
#include "cli/out_of_memory.h"
#include "cli/part_id.h"
#include "cli/picture_targets.h"
#include "cli/run_display.h"
#include "cli/scene_geometry.h"
#include "cli/scene_input.h"
#include "cli/stats.h"
#include "render/renderer.h"
#include "system/worker_threads.h"

namespace {

/// What one thread counts, apart from the others' in memory.
struct alignas(128) ThreadCounts {
  RayCounts rays;
  RayTestCounts tests;
  std::unique_ptr<const Object3D> geometry;
};

/// Renders, and enters in `stats` what the threads have counted.
void renderCounted(const SceneParser& scene, const SceneGeometry& geometry,
                   const PictureRequest& picture, const RenderTargets& targets, Stats& stats) {
  std::vector<ThreadCounts> counts(std::size_t(stats.threads));
  std::vector<WorkerView> views;
  for (ThreadCounts& each : counts) {
    each.geometry = geometry.counting(each.tests);
    views.push_back({each.geometry ? each.geometry.get() : &geometry.object(), &each.rays});
  }
  render(scene, geometry.object(), picture.render, stats.threads, targets, views);
  stats.pixels = double(picture.area.pixelCount());
  stats.countsTests = picture.acceleration.cellPicture == Acceleration::CellPicture::none;
  stats.tests = geometry.tallied();
  for (const ThreadCounts& each : counts) {
    stats.rays.add(each.rays);
    stats.tests.add(each.tests);
  }
}

/// Builds what answers for the scene's objects, then traces; enters both in `stats`. At last
/// `inspectAll(geometry)` is called.
template <class InspectAll>
void renderAll(const SceneParser& scene, const RenderRequest& request, const RenderTargets& targets,
               Stats& stats, const InspectAll& inspectAll) {
  const PictureRequest& picture = request.picture;
  Stopwatch watch;
  const SceneGeometry geometry(*scene.getGroup(), picture.acceleration, stats.threads,
                               request.results.stats);
  stats.simd = geometry.simd();
  stats.tree = geometry.description();
  stats.buildSeconds = watch.restart();
  if (request.results.stats) {
    renderCounted(scene, geometry, picture, targets, stats);
  } else if (wantsRays(targets)) {
    render(scene, geometry.object(), picture.render, stats.threads, targets);
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
void setPlaces(const SceneParser& scene, const Digest& sceneDigest, const RenderRequest& request,
               int threads, std::vector<Output>& outputs) {
  const PictureRequest& picture = request.picture;
  if (!picture.isPart) return;
  for (Output& output : outputs) {
    const PartId id = partIdOf(output, request, sceneDigest, scene.getMeshFiles(), threads);
    output.place = {picture.area.left, picture.height - picture.area.top, textOf(id)};
  }
}

/// Gives every output its picture; where -stats or -preview wants rays and no output does, traces
/// all the same. Where a checkpoint is wanted, `scene` is what notes.digest is of, and the
/// checkpoint is returned.
Rendered renderOutputs(const SceneParser& scene, const ReadNotes& notes,
                       const RenderRequest& request, const RunRequest& run,
                       std::vector<Output>& outputs, Stats& stats) {
  const PictureRequest& picture = request.picture;
  const bool preview = request.results.preview;
  const std::string size = std::to_string(picture.area.width()) + " x " +
                           std::to_string(picture.area.height()) + " pixels";
  Image unwritten;
  std::optional<MaterialColors> materialColors;
  RenderTargets targets = withMemory("for images of " + size, [&] {
    makeImages(outputs, picture);
    return targetsOf(request, outputs, unwritten);
  });
  if (targets.materials) targets.materialColors = &materialColors.emplace(scene);
  Rendered rendered;
  const bool isTraced = wantsRays(targets);
  if (isTraced && !run.checkpoint.empty()) {
    const Digest fingerprint = pictureFingerprint(request.results.outputs, request.given,
                                                  notes.digest, scene.getMeshFiles(), run.threads);
    rendered.checkpoint = openCheckpoint(run.checkpoint, fingerprint, targets, run.quiet);
    targets.store = rendered.checkpoint.get();
  }
  RunDisplay display(preview, run.progress, targets);
  if (display.isWanted()) targets.listener = &display;
  stats.threads = run.threads;
  const auto inspectAll = [&](const Object3D& geometry) {
    display.finish();
    rendered.status = print(display.lastPicture());
    const InspectedScene inspected = {scene, notes.places, geometry};
    drawHeatmap(inspected, picture, run, outputs);
    rendered.lastLines = inspectPixel(inspected, request, outputs);
  };
  if (isTraced || wantsInspection(request.results)) {
    withMemory("to render " + size, [&] { renderAll(scene, request, targets, stats, inspectAll); });
  }
  if (rendered.checkpoint) rendered.checkpoint->stop();
  const Image* const untraced = isTraced ? nullptr : untracedPicture(outputs);
  if (preview && untraced) rendered.status = print(pictureText(*untraced));
  return rendered;
}

}  // namespace

std::vector<Output> renderPictures(const RenderRequest& request, const RunRequest& run) {
  Stats stats;
  ReadNotes notes;
  SceneParser scene = readScene(request, run, notes);
  prepareScene(scene, request.picture, run.quiet);
  std::vector<Output> outputs = outputsOf(request.results);
  const Rendered rendered = renderOutputs(scene, notes, request, run, outputs, stats);
  if (rendered.checkpoint) rendered.checkpoint->remove();
  return outputs;
}

int renderScene(const RenderRequest& request, const RunRequest& run) {
  Stats stats;
  Stopwatch watch;
  ReadNotes notes;
  SceneParser scene = readScene(request, run, notes);
  checkFiles(request, run.checkpoint, scene.getMeshFiles());
  prepareScene(scene, request.picture, run.quiet);
  stats.readSeconds = watch.restart();

  std::vector<Output> outputs = outputsOf(request.results);
  const std::size_t wanted = outputs.size();
  if (markUnwritable(outputs) == 0 && wanted > 0) return kOutputFailed;
  if (run.checkpoint.empty()) dropUnwritable(outputs);
  setPlaces(scene, notes.digest, request, run.threads, outputs);
  const Rendered rendered = renderOutputs(scene, notes, request, run, outputs, stats);
  watch.restart();
  const std::size_t written = writeAll(outputs, run.threads);
  if (rendered.checkpoint && written == wanted) rendered.checkpoint->remove();
  stats.writeSeconds = watch.restart();
  const std::string statsText = request.results.stats ? stats.text() : "";
  const int printed = print(legendOf(scene, outputs) + statsText + rendered.lastLines);
  return written == wanted ? std::max(printed, rendered.status) : kOutputFailed;
}
