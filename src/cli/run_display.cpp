// The line of progress and the picture on a terminal.
//
// The thread that finishes a tile when it is time redraws both. The line is a text behind a
// carriage return, with blanks for what the last one had too much. The picture is drawn over the
// last one: the cursor goes up as many lines as that had. Each cell of it is the mean of its pixels
// so far, by the escape sequences of ECMA-48 with 24-bit colours.
#include "cli/run_display.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "image/output_file.h"
#include "scene/number_reader.h"

namespace {

/// Seconds between two updates: never more than ten in a second, the last one included.
constexpr std::chrono::milliseconds kPause(125);

constexpr const char* kUpperHalf = "\xe2\x96\x80";  // U+2580
constexpr int kFreeLines = 2;
constexpr int kMostColumns = 1000;

/// The whole number above 0 that the variable holds, or else `otherwise`.
int fromEnvironment(const char* name, int otherwise) {
  const char* const word = std::getenv(name);
  int value = 0;
  return word && readInt(word, value) && value > 0 ? value : otherwise;
}

/// The size of the window that standard output is; where it is none, what COLUMNS and LINES say;
/// 80 x 24 where they do not.
TerminalSize terminalSize() {
  winsize size = {};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
    return {size.ws_col, size.ws_row};
  }
  return {fromEnvironment("COLUMNS", 80), fromEnvironment("LINES", 24)};
}

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// In the unit that leaves two or three digits.
std::string duration(double seconds) {
  if (seconds < 10) return number("%.1f s", seconds);
  if (seconds < 100) return number("%.0f s", seconds);
  if (seconds < 6000) return number("%.0f min", seconds / 60);
  return number("%.1f h", seconds / 3600);
}

std::string rate(double perSecond) {
  if (perSecond < 1e3) return number("%.0f", perSecond);
  return perSecond < 1e6 ? number("%.1f k", perSecond / 1e3) : number("%.2f M", perSecond / 1e6);
}

/// The cursor goes up so many lines.
std::string linesUp(int lines) {
  return lines > 0 ? "\033[" + std::to_string(lines) + "A" : std::string();
}

}  // namespace

/// A character is about twice as high as wide, so that a cell, half of one, is a square.
TerminalPicture::TerminalPicture(int width, int height, const TerminalSize& terminal)
    : width_(width), height_(height) {
  const int mostColumns = std::clamp(terminal.columns, 1, kMostColumns);
  const int mostRows = 2 * std::clamp(terminal.lines - kFreeLines, 1, kMostColumns);
  const double smaller = std::min({1.0, mostColumns / double(width), mostRows / double(height)});
  columns_ = std::clamp(int(std::lround(width * smaller)), 1, std::min(width, mostColumns));
  rows_ = std::clamp(int(std::lround(height * smaller)), 1, std::min(height, mostRows));
  cells_.resize(std::size_t(columns_) * std::size_t(rows_));
}

/// In 64 bits, as pixels times cells may pass 2^31.
void TerminalPicture::add(const Image& image, const PixelRectangle& area) {
  for (int j = area.bottom; j < area.top; ++j) {
    const auto row = std::size_t((height_ - 1 - j) * std::int64_t(rows_) / height_);
    for (int i = area.left; i < area.right; ++i) {
      const auto column = std::size_t(i * std::int64_t(columns_) / width_);
      Cell& cell = cells_[row * std::size_t(columns_) + column];
      const Rgb8 pixel = image.getPixel(i, j);
      cell.sum += Vec3d(pixel.r, pixel.g, pixel.b);
      ++cell.pixels;
    }
  }
}

/// The sequence for the colour of a cell: `kind` is 38 for what is drawn, 48 for what is behind it.
/// Nothing below the last row.
std::string TerminalPicture::colorCode(int kind, int column, int row) const {
  if (row == rows_) return "";
  const Cell& cell = cells_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)];
  std::string text = "\033[" + std::to_string(kind) + ";2";
  for (int component = 0; component < 3; ++component) {
    const double mean = cell.sum[component] / std::max(cell.pixels, 1);
    text += ";" + std::to_string(std::lround(mean));
  }
  return text + "m";
}

/// A colour is named only where it is another than the last one.
std::string TerminalPicture::text() const {
  std::string text;
  for (int row = 0; row < rows_; row += 2) {  // two rows of cells in a line
    std::string last[2];
    for (int column = 0; column < columns_; ++column) {
      for (const int lower : {0, 1}) {
        const std::string color = colorCode(lower ? 48 : 38, column, row + lower);
        if (color != last[lower]) text += color;
        last[lower] = color;
      }
      text += kUpperHalf;
    }
    text += "\033[0m\n";
  }
  return text;
}

std::string pictureText(const Image& image) {
  TerminalPicture picture(image.Width(), image.Height(), terminalSize());
  picture.add(image, {0, 0, image.Width(), image.Height()});
  return picture.text();
}

std::string progressText(double rays, double allRays, double seconds) {
  constexpr double kLeast = 1e-6;
  // 100 % is said only when all is done.
  const double done = std::min(rays / allRays, 1.0);
  std::string text = number("%3.0f %%, ", done < 1 ? std::min(100 * done, 99.0) : 100) +
                     rate(rays / std::max(seconds, kLeast)) + " eye rays/s, ";
  if (done >= 1) return text + duration(seconds);
  return text + (done > 0 ? duration(seconds / done * (1 - done)) : "some time") + " left";
}

RunDisplay::RunDisplay(std::optional<bool> progress, const Image* preview, int zoom)
    : showsProgress_(progress.value_or(isatty(STDERR_FILENO) == 1)), image_(preview), zoom_(zoom) {
  if (image_ && isatty(STDOUT_FILENO) == 1) {
    picture_.emplace(image_->Width(), image_->Height(), terminalSize());
  }
}

RunDisplay::~RunDisplay() {
  if (!isLineOpen()) return;  // a message may have ended it
  std::fputc('\n', stderr);
  setLineOpen(false);
}

void RunDisplay::begins(double eyeRays) {
  allRays_ = eyeRays;
  start_ = Clock::now();
  nextTime_ = start_ + kPause;
}

/// Each thread adds the pixels that it has just set itself: others may be about to change theirs.
void RunDisplay::tileIsDone(const PixelRectangle& area, double eyeRays) {
  const std::lock_guard<std::mutex> lock(mutex_);
  rays_ += eyeRays;
  if (picture_) {
    picture_->add(*image_,
                  {area.left * zoom_, area.bottom * zoom_, area.right * zoom_, area.top * zoom_});
  }
  const Clock::time_point now = Clock::now();
  if (now < nextTime_) return;
  nextTime_ = now + kPause;
  if (picture_) drawPicture();
  if (rays_ < allRays_) drawProgress();  // the last one comes by finish()
}

/// Begins below the last one, in the line of progress, and ends there again.
void RunDisplay::drawPicture() {
  const std::string text = "\r\033[K" + linesUp(linesDrawn_) + picture_->text();
  linesDrawn_ = picture_->lines();
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

void RunDisplay::drawProgress() {
  if (!showsProgress_) return;
  const std::chrono::duration<double> passed = Clock::now() - start_;
  std::string text = progressText(rays_, allRays_, passed.count());
  const std::size_t length = text.size();
  text.resize(std::max(length, lengthDrawn_), ' ');
  lengthDrawn_ = length;
  setLineOpen(true);
  std::fprintf(stderr, "\rraytracer: %s", text.c_str());
  std::fflush(stderr);
}

/// The last line tells the time that all took.
void RunDisplay::finish() {
  if (allRays_ == 0 || !showsProgress_) return;
  rays_ = allRays_;
  drawProgress();
  std::fputc('\n', stderr);
  setLineOpen(false);
}

std::string RunDisplay::lastPicture() const {
  if (!image_) return "";
  if (linesDrawn_ == 0) return pictureText(*image_);
  // The line of progress, where it is shown on the same terminal, has been ended.
  const int above = linesDrawn_ + int(showsProgress_ && isatty(STDERR_FILENO) == 1);
  return linesUp(above) + "\r\033[J" + pictureText(*image_);
}
