// What the user sees while the picture is traced: a line of progress, and the picture itself in
// coloured characters. Both change a few times a second, whatever the number of tiles.
#pragma once
#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "render/image_plane.h"
#include "render/renderer.h"

/// Columns and lines of a terminal.
struct TerminalSize {
  int columns, lines;
};

/// A picture in coloured characters, each of which shows two cells one above the other: the upper
/// half block U+2580 in the colour of the upper one, before that of the lower one.
class TerminalPicture {
 public:
  /// For a picture of so many pixels, made smaller (never larger) as far as it does not fit into
  /// the terminal, two lines of which are left free.
  TerminalPicture(int width, int height, const TerminalSize& terminal);

  int lines() const { return (rows_ + 1) / 2; }

  /// Adds the pixels of `area` of the picture, each of them once.
  void add(const Image& image, const PixelRectangle& area);
  /// The whole of it, with a line break behind each line: each cell the mean of its pixels so far.
  std::string text() const;

 private:
  /// The sum of a cell's pixels, and how many they are.
  struct Cell {
    Vec3d sum;
    int pixels = 0;
  };
  std::string colorCode(int kind, int column, int row) const;

  int width_, height_, columns_, rows_;
  std::vector<Cell> cells_;  // row by row from the top
};

/// A picture in coloured characters, as large as the window that standard output is.
std::string pictureText(const Image& image);

/// "42 %, 1.5 M eye rays/s, 12 s left", or, where all is done, the time it took. (Public for its
/// test.)
std::string progressText(double rays, double allRays, double seconds);

class RunDisplay : public TileListener {
 public:
  /// Tells of the progress as RunRequest::progress says. Shows `preview`, unless it is null, which
  /// is not owned: a picture of `zoom` pixels each way for each that tiles have.
  explicit RunDisplay(std::optional<bool> progress, const Image* preview = nullptr, int zoom = 1);
  /// Ends the line of progress where one is open.
  ~RunDisplay() override;
  RunDisplay(const RunDisplay&) = delete;
  RunDisplay& operator=(const RunDisplay&) = delete;

  void begins(double eyeRays) override;
  void tileIsDone(const PixelRectangle& area, double eyeRays) override;
  /// Ends the line of progress; once, when all is traced. Nothing happens where nothing began.
  void finish();
  /// The whole picture as it is to be printed on standard output; "" where it is not wanted.
  std::string lastPicture() const;

 private:
  using Clock = std::chrono::steady_clock;

  void drawPicture();
  void drawProgress();

  const bool showsProgress_;
  const Image* const image_;                // what is shown; null where nothing is
  const int zoom_;                          // image pixels for each of a tile's
  std::optional<TerminalPicture> picture_;  // where it is shown as it grows
  int linesDrawn_ = 0;                      // of the picture
  std::size_t lengthDrawn_ = 0;             // of the line of progress
  Clock::time_point start_, nextTime_;      // of the tracing, and when the next update is due
  double allRays_ = 0, rays_ = 0;
  std::mutex mutex_;  // guards all that changes while tiles are traced
};
