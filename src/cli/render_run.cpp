// Rendering a scene: parse, compile once, trace, write.
//
// The outputs get their images before anything is traced, so that memory is short at the start or
// not at all. The renderer fills most of them in one pass over the picture, each eye ray being cast
// once; the heat map and the rays of one pixel are traced besides, after it.
#include "cli/render_run.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "cli/checkpoint.h"
#include "cli/fingerprint.h"
#include "cli/inspection.h"
#include "cli/part_file.h"
#include "cli/program.h"
#include "cli/run_display.h"
#include "cli/scene_geometry.h"
#include "cli/scene_input.h"

namespace {

/// Renders, and enters in `stats` what was counted.
void renderCounted(const SceneParser& scene, const SceneGeometry& geometry,
                   const PictureRequest& picture, const RenderTargets& targets, Stats& stats) {
  render(scene, geometry.object(), picture.render, stats.threads, targets, &stats.rays);
  stats.pixels = double(picture.area.pixelCount());
  stats.countsTests = picture.acceleration.cellPicture == Acceleration::CellPicture::none;
  stats.tests = geometry.tallied();
}

/// The picture that -preview shows where the renderer has filled none; null where there is none.
const Image* untracedPicture(std::vector<Output>& outputs) {
  const Output* shown = findOutput(outputs, OutputRequest::Kind::heatmap);
  if (!shown) shown = findOutput(outputs, OutputRequest::Kind::filter);
  return shown ? &shown->image : nullptr;
}

/// One run, and what its steps hand on.
class RenderRun {
 public:
  /// Parses the scene. The requests are not owned.
  RenderRun(const RenderRequest& request, const RunRequest& run)
      : request_(request),
        run_(run),
        scene_(readScene(request, run, notes_)),
        outputs_(outputsOf(request.results)) {}

  const SceneParser& scene() const { return scene_; }
  /// To be had when all is traced; the checkpoint has then done its service.
  std::vector<Output> takeOutputs();

  /// Says what is to be said of the scene, and prepares it for being rendered.
  void prepare();
  /// Finds out which outputs can be written, complaining of the others; false where none can that
  /// is wanted.
  bool prepareOutputs();
  /// Compiles the scene and gives every output its image; where -stats or -preview wants rays and
  /// no output does, traces all the same.
  void trace();
  /// Writes the outputs, prints what was found out, and returns the exit status.
  int write();

 private:
  void setPlaces();
  void openCheckpointFor(RenderTargets& targets);
  void traceRays(const RenderTargets& targets, RunDisplay& display);

  const RenderRequest& request_;
  const RunRequest& run_;
  Stopwatch watch_;
  Stats stats_;
  ReadNotes notes_;
  SceneParser scene_;
  std::vector<Output> outputs_;
  std::optional<MaterialColors> materialColors_;
  std::unique_ptr<Checkpoint> checkpoint_;
  std::string lastLines_;  // to be printed last
  int status_ = kDone;     // kOutputFailed where the preview could not be shown
};

void RenderRun::prepare() {
  prepareScene(scene_, request_.picture, run_.quiet);
  stats_.readSeconds = watch_.restart();
}

bool RenderRun::prepareOutputs() {
  if (markUnwritable(outputs_) == 0 && !outputs_.empty()) return false;
  // A checkpoint needs them all: its tiles hold the pixels of every picture, for the run that can
  // write them again.
  if (run_.checkpoint.empty()) {
    const auto isLost = [](const Output& output) { return !output.isWritable; };
    outputs_.erase(std::remove_if(outputs_.begin(), outputs_.end(), isLost), outputs_.end());
  }
  setPlaces();
  return true;
}

/// Tells the outputs, where they are parts, which picture they belong to.
void RenderRun::setPlaces() {
  const PictureRequest& picture = request_.picture;
  if (!picture.isPart) return;
  for (Output& output : outputs_) {
    const PartId id =
        partIdOf(output, request_, notes_.digest, scene_.getMeshFiles(), run_.threads);
    output.place = {picture.area.left, picture.height - picture.area.top, textOf(id)};
  }
}

void RenderRun::openCheckpointFor(RenderTargets& targets) {
  const Digest fingerprint = pictureFingerprint(request_.results, request_.given, notes_.digest,
                                                scene_.getMeshFiles(), run_.threads);
  checkpoint_ = openCheckpoint(run_.checkpoint, fingerprint, targets, run_.quiet);
  targets.store = checkpoint_.get();
}

void RenderRun::trace() {
  const PictureRequest& picture = request_.picture;
  const std::string size = std::to_string(picture.area.width()) + " x " +
                           std::to_string(picture.area.height()) + " pixels";
  Image unwritten;
  RenderTargets targets = withMemory("for images of " + size, [&] {
    makeImages(outputs_, picture);
    return targetsOf(request_, outputs_, unwritten);
  });
  if (targets.materials) targets.materialColors = &materialColors_.emplace(scene_);
  const bool isTraced = wantsRays(targets);
  if (isTraced && !run_.checkpoint.empty()) openCheckpointFor(targets);
  RunDisplay display(request_.results.preview, run_.progress, targets);
  if (display.isWanted()) targets.listener = &display;
  if (isTraced || wantsInspection(request_.results)) {
    withMemory("to render " + size, [&] { traceRays(targets, display); });
  }
  if (checkpoint_) checkpoint_->stop();
  const Image* const untraced = isTraced ? nullptr : untracedPicture(outputs_);
  if (request_.results.preview && untraced) status_ = print(pictureText(*untraced));
}

void RenderRun::traceRays(const RenderTargets& targets, RunDisplay& display) {
  const PictureRequest& picture = request_.picture;
  stats_.threads = run_.threads;
  watch_.restart();
  const SceneGeometry geometry(*scene_.getGroup(), picture.acceleration, run_.threads,
                               request_.results.stats);
  stats_.simd = geometry.simd();
  stats_.tree = geometry.description();
  stats_.buildSeconds = watch_.restart();
  if (request_.results.stats) {
    renderCounted(scene_, geometry, picture, targets, stats_);
  } else if (wantsRays(targets)) {
    render(scene_, geometry.object(), picture.render, run_.threads, targets);
  }
  stats_.traceSeconds = watch_.restart();
  display.finish();
  status_ = print(display.lastPicture());
  const InspectedScene inspected = {scene_, notes_.places, geometry.object()};
  drawHeatmap(inspected, picture, run_, outputs_);
  lastLines_ = inspectPixel(inspected, request_, outputs_);
}

int RenderRun::write() {
  watch_.restart();
  const bool areAllWritten = writeAll(outputs_, run_.threads) == request_.results.outputs.size();
  if (checkpoint_ && areAllWritten) checkpoint_->remove();
  stats_.writeSeconds = watch_.restart();
  const std::string statsText = request_.results.stats ? stats_.text() : "";
  const int printed = print(legendOf(scene_, outputs_) + statsText + lastLines_);
  return areAllWritten ? std::max(printed, status_) : kOutputFailed;
}

std::vector<Output> RenderRun::takeOutputs() {
  if (checkpoint_) checkpoint_->remove();
  return std::move(outputs_);
}

}  // namespace

std::vector<Output> renderPictures(const RenderRequest& request, const RunRequest& run) {
  RenderRun rendering(request, run);
  rendering.prepare();
  rendering.trace();
  return rendering.takeOutputs();
}

int renderScene(const RenderRequest& request, const RunRequest& run) {
  checkFiles(request, run.checkpoint);
  RenderRun rendering(request, run);
  checkFiles(request, run.checkpoint, rendering.scene().getMeshFiles());
  rendering.prepare();
  if (!rendering.prepareOutputs()) return kOutputFailed;
  rendering.trace();
  return rendering.write();
}
