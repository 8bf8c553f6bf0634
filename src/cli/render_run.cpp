// Rendering a scene: parse, compile once, trace, write.
//
// The outputs get their images before anything is traced, so that memory is short at the start or
// not at all. The renderer fills most of them in one pass over the picture, each eye ray being cast
// once; the heat map and the rays of one pixel are traced besides, after it.
#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "cli/checkpoint.h"
#include "cli/inspection.h"
#include "cli/part_file.h"
#include "cli/program.h"
#include "cli/run_display.h"
#include "cli/runs.h"
#include "cli/scene_setup.h"
#include "render/false_colors.h"

namespace {

using Clock = std::chrono::steady_clock;
using Kind = OutputRequest::Kind;

/// What -preview shows: the first of these pictures that is there, or null.
const Output* previewOf(std::vector<Output>& outputs) {
  for (const Kind kind : {Kind::color, Kind::normals, Kind::depth, Kind::materials, Kind::samples,
                          Kind::heatmap, Kind::filter}) {
    if (const Output* const found = findOutput(outputs, kind)) return found;
  }
  return nullptr;
}

/// One run, and what its steps hand on.
class RenderRun {
 public:
  /// Parses the scene, to which the request is adapted. `run` is not owned.
  RenderRun(const RenderRequest& request, const RunRequest& run)
      : request_(request),
        run_(run),
        scene_(readScene(request_, run, notes_)),
        outputs_(outputsOf(request_)) {
    const SceneParser::PictureSize& size = scene_.getPictureSize();
    if (size.width > 0) request_ = adapted(request_, *request_.picture.course, size);
  }

  const SceneParser& scene() const { return scene_; }

  /// Says what is to be said of the scene, and prepares it for being rendered.
  void prepare() {
    prepareScene(scene_, request_.picture, run_.quiet);
    stats_.readSeconds = secondsPassed();
  }

  /// Finds out which outputs can be written, complaining of the others; false where none can that
  /// is wanted.
  bool prepareOutputs() {
    if (markUnwritable(outputs_, request_.picture) == 0 && !outputs_.empty()) return false;
    // A checkpoint needs them all: its tiles hold the pixels of every picture, for the run that can
    // write them again.
    if (run_.checkpoint.empty()) {
      const auto isLost = [](const Output& output) { return !output.isWritable; };
      outputs_.erase(std::remove_if(outputs_.begin(), outputs_.end(), isLost), outputs_.end());
    }
    if (!request_.picture.isPart) return true;
    for (Output& output : outputs_) {  // each tells which picture it belongs to
      output.part =
          tgaPartOf(output, request_, notes_.digest, scene_.getInputFiles(), run_.threads);
    }
    return true;
  }

  /// Compiles the scene and gives every output its image; where -stats or -preview wants rays and
  /// no output does, traces all the same.
  void trace() {
    const PictureRequest& picture = request_.picture;
    const ResultRequest& results = request_.results;
    const std::string size = sizeText(picture.area.width(), picture.area.height()) + " pixels";
    if (!wantsRays(outputs_) && (results.stats || (results.preview && !previewOf(outputs_)))) {
      outputs_.emplace_back(OutputRequest());  // colours, which are not written
    }
    RenderTargets targets =
        withMemory("for images of " + size, [&] { return makeImages(outputs_, picture); });
    const bool isTraced = wantsRays(outputs_);
    if (isTraced && !run_.checkpoint.empty()) openCheckpoint(targets);
    const Output* const shown = results.preview ? previewOf(outputs_) : nullptr;
    RunDisplay display(run_.progress, shown && isTraced ? &shown->image : nullptr,
                       shown ? shown->zoom : 1);
    targets.listener = &display;
    if (isTraced || results.pixel || results.find(Kind::heatmap)) {
      withMemory("to render " + size, [&] { traceRays(targets, isTraced, display); });
    }
    if (shown && !isTraced) status_ = print(pictureText(shown->image));
  }

  /// Writes the outputs, prints what was found out, and returns the exit status.
  int write() {
    secondsPassed();
    // A checkpoint is kept until everything that it stands for has been written.
    const bool areAllWritten = writeAll(outputs_, run_.threads) == request_.results.outputs.size();
    if (checkpoint_ && areAllWritten) checkpoint_->remove();
    stats_.writeSeconds = secondsPassed();
    std::string text;
    for (const Output& output : outputs_) {
      if (output.kind != Kind::rays) text += output.text;
    }
    if (request_.results.stats) {
      text += stats_.text(request_.picture, run_.threads, scene_.getPictureBytes());
    }
    const int printed = print(text + lastLines_);
    return areAllWritten ? std::max(printed, status_) : kOutputFailed;
  }

  /// To be had when all is traced; the checkpoint has then done its service.
  std::vector<Output> takeOutputs() {
    if (checkpoint_) checkpoint_->remove();
    return std::move(outputs_);
  }

 private:
  /// Since the last call, or the start of the run.
  double secondsPassed() {
    const Clock::time_point begin = std::exchange(lastTime_, Clock::now());
    return std::chrono::duration<double>(lastTime_ - begin).count();
  }

  void openCheckpoint(RenderTargets& targets) {
    const Digest fingerprint =
        pictureFingerprint(request_, notes_.digest, scene_.getInputFiles(), run_.threads);
    checkpoint_ = std::make_unique<Checkpoint>(run_.checkpoint, fingerprint, targets);
    if (!run_.quiet) checkpoint_->tell();
    targets.store = checkpoint_.get();
  }

  /// Those of the targets, where `isTraced`; and once more those of what is told besides, the heat
  /// map and the pixel.
  void traceRays(const RenderTargets& targets, bool isTraced, RunDisplay& display) {
    const PictureRequest& picture = request_.picture;
    const bool counts = request_.results.stats;
    secondsPassed();
    const SceneGeometry geometry(*scene_.getGroup(), picture.acceleration, picture.course->cells,
                                 run_.threads, counts);
    stats_.simd = geometry.simd();
    stats_.tree = geometry.description();
    stats_.buildSeconds = secondsPassed();
    const RayTracer tracer(scene_, geometry.object(), picture.render);
    if (isTraced) render(tracer, run_.threads, targets, counts ? &stats_.rays : nullptr);
    stats_.traceSeconds = secondsPassed();
    stats_.tests = geometry.tallied();
    display.finish();
    status_ = print(display.lastPicture());
    if (Output* const materials = findOutput(outputs_, Kind::materials)) {
      materials->text = materialLegend(scene_, materials->image);
    }
    drawHeatmap(tracer, run_, outputs_);
    lastLines_ = inspectPixel(tracer, notes_.places, request_, outputs_);
  }

  RenderRequest request_;
  const RunRequest& run_;
  Clock::time_point lastTime_ = Clock::now();
  Stats stats_;
  ReadNotes notes_;
  SceneParser scene_;
  std::vector<Output> outputs_;
  std::unique_ptr<Checkpoint> checkpoint_;
  std::string lastLines_;  // to be printed last
  int status_ = kDone;     // kOutputFailed where the preview could not be shown
};

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
  checkFiles(request, run.checkpoint, rendering.scene().getInputFiles());
  rendering.prepare();
  if (!rendering.prepareOutputs()) return kOutputFailed;
  rendering.trace();
  return rendering.write();
}
