// RunDisplay: the thread that finishes a tile when it is time redraws both.
#include "cli/run_display.h"

#include <unistd.h>

#include <cstdio>

#include "render/image_plane.h"

namespace {

/// Seconds between two updates: never more than ten in a second, the last one included.
constexpr double kPause = 0.125;

bool wantsProgress(RunRequest::Progress progress) {
  if (progress == RunRequest::Progress::automatic) return isatty(STDERR_FILENO) == 1;
  return progress == RunRequest::Progress::on;
}

const Image* shownOf(const RenderTargets& targets) {
  for (const Image* image : {targets.color, targets.normals, targets.depth, targets.materials})
    if (image) return image;
  return targets.samples;
}

}  // namespace

RunDisplay::RunDisplay(bool preview, RunRequest::Progress progress, const RenderTargets& targets)
    : showsProgress_(wantsProgress(progress)),
      image_(preview ? shownOf(targets) : nullptr),
      isPictureLive_(image_ && isatty(STDOUT_FILENO) == 1),
      line_(showsProgress_) {
  if (!image_) return;
  zoom_ = image_ == targets.samples ? targets.samplesZoom : 1;
  picture_.emplace(image_->Width(), image_->Height(), terminalSize(STDOUT_FILENO));
}

void RunDisplay::begins(double eyeRays) {
  allRays_ = eyeRays;
  watch_.restart();
  nextTime_ = kPause;
}

/// Each thread adds the pixels that it has just set itself: others may be about to change theirs.
void RunDisplay::tileIsDone(const PixelRectangle& area, double eyeRays) {
  const std::lock_guard<std::mutex> lock(mutex_);
  rays_ += eyeRays;
  if (isPictureLive_) addToPicture(area);
  seconds_ += watch_.restart();
  if (seconds_ < nextTime_) return;
  nextTime_ = seconds_ + kPause;
  if (isPictureLive_) {
    const std::string text = pictureInPlace();
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
  }
  if (rays_ < allRays_) line_.show(rays_, allRays_, seconds_);  // the last one comes by finish()
}

void RunDisplay::finish() {
  if (allRays_ == 0) return;
  seconds_ += watch_.restart();
  line_.finish(allRays_, seconds_);
}

std::string RunDisplay::lastPicture() const {
  if (!picture_) return "";
  // The line of progress, where it is shown on the same terminal, has been ended.
  const int above = linesDrawn_ + int(showsProgress_ && isatty(STDERR_FILENO) == 1);
  const std::string start =
      linesDrawn_ > 0 ? "\033[" + std::to_string(above) + "A\r\033[J" : std::string();
  return start + pictureText(*image_);
}

void RunDisplay::addToPicture(const PixelRectangle& area) {
  picture_->add(*image_, area.left * zoom_, area.bottom * zoom_, area.right * zoom_,
                area.top * zoom_);
}

/// Begins below the last one, in the line of progress, and ends there again.
std::string RunDisplay::pictureInPlace() {
  std::string start = "\r\033[K";
  if (linesDrawn_ > 0) start += "\033[" + std::to_string(linesDrawn_) + "A";
  linesDrawn_ = picture_->lines();
  return start + picture_->text();
}

std::string pictureText(const Image& image) {
  TerminalPicture picture(image.Width(), image.Height(), terminalSize(STDOUT_FILENO));
  picture.add(image, 0, 0, image.Width(), image.Height());
  return picture.text();
}
