// RunDisplay: what the user sees while the picture is traced: a line of progress, and the picture
// itself. Both change a few times a second, whatever the number of tiles.
#pragma once
#include <mutex>
#include <optional>

#include "cli/progress_line.h"
#include "cli/request.h"
#include "cli/stats.h"
#include "cli/terminal_picture.h"
#include "render/renderer.h"
#include "render/tile_hooks.h"

class RunDisplay : public TileListener {
 public:
  /// Where `preview`, shows one of the pictures in `targets`: the colours where they are wanted,
  /// else normals, depth, materials or samples; none where there are none. The images are not
  /// owned.
  RunDisplay(bool preview, RunRequest::Progress progress, const RenderTargets& targets);

  /// False where nobody would see anything.
  bool isWanted() const { return showsProgress_ || picture_; }
  void begins(double eyeRays) override;
  void tileIsDone(const PixelRectangle& area, double eyeRays) override;
  /// Ends the line of progress; once, when all is traced. Nothing happens where nothing began.
  void finish();
  /// The whole picture as it is to be printed on standard output; "" where it is not wanted.
  std::string lastPicture() const;

 private:
  void addToPicture(const PixelRectangle& area);
  std::string pictureInPlace();

  const bool showsProgress_;
  const Image* const image_;  // what is shown; null where nothing is
  const bool isPictureLive_;  // it is shown as it grows
  int zoom_ = 1;              // image pixels for each of a tile's
  std::optional<TerminalPicture> picture_;
  int linesDrawn_ = 0;
  ProgressLine line_;
  Stopwatch watch_;
  double allRays_ = 0, rays_ = 0, seconds_ = 0, nextTime_ = 0;
  std::mutex mutex_;  // guards all that changes while tiles are traced
};

/// A picture in coloured characters, as large as the window that standard output is.
std::string pictureText(const Image& image);
