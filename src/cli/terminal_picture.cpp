// TerminalPicture: means of pixels, and the escape sequences of ECMA-48 with 24-bit colours.
#include "cli/terminal_picture.h"

#include <sys/ioctl.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "scene/number_reader.h"

namespace {

constexpr const char* kUpperHalf = "\xe2\x96\x80";  // U+2580
constexpr int kFreeLines = 2;
constexpr int kMostColumns = 1000;

int fromEnvironment(const char* name, int otherwise) {
  const char* const word = std::getenv(name);
  int value = 0;
  return word && readInt(word, value) && value > 0 ? value : otherwise;
}

}  // namespace

TerminalSize terminalSize(int terminal) {
  winsize size = {};
  if (ioctl(terminal, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
    return {size.ws_col, size.ws_row};
  }
  return {fromEnvironment("COLUMNS", 80), fromEnvironment("LINES", 24)};
}

TerminalPicture::TerminalPicture(int width, int height, const TerminalSize& terminal)
    : width_(width), height_(height) {
  const int mostColumns = std::clamp(terminal.columns, 1, kMostColumns);
  const int mostRows = 2 * std::clamp(terminal.lines - kFreeLines, 1, kMostColumns);
  const double smaller = std::min({1.0, mostColumns / double(width), mostRows / double(height)});
  columns_ = std::clamp(int(std::lround(width * smaller)), 1, std::min(width, mostColumns));
  rows_ = std::clamp(int(std::lround(height * smaller)), 1, std::min(height, mostRows));
  cells_.resize(std::size_t(columns_) * std::size_t(rows_));
}

void TerminalPicture::add(const Image& image, int left, int bottom, int right, int top) {
  for (int j = bottom; j < top; ++j) {
    const auto row = std::size_t((height_ - 1 - j) * std::int64_t(rows_) / height_);
    for (int i = left; i < right; ++i) {
      const auto column = std::size_t(i * std::int64_t(columns_) / width_);
      Cell& cell = cells_[row * std::size_t(columns_) + column];
      const Rgb8 pixel = image.getPixel(i, j);
      cell.red += pixel.r;
      cell.green += pixel.g;
      cell.blue += pixel.b;
      cell.pixels += 1;
    }
  }
}

std::string TerminalPicture::color(int kind, const Cell& cell) {
  const auto mean = [&](double sum) {
    return std::to_string(cell.pixels > 0 ? std::lround(sum / cell.pixels) : 0);
  };
  return "\033[" + std::to_string(kind) + ";2;" + mean(cell.red) + ";" + mean(cell.green) + ";" +
         mean(cell.blue) + "m";
}

std::string TerminalPicture::text() const {
  std::string text;
  for (int row = 0; row < rows_; row += 2) {
    std::string lastUpper, lastLower;
    for (int column = 0; column < columns_; ++column) {
      const std::size_t at = std::size_t(row) * std::size_t(columns_) + std::size_t(column);
      const std::string upper = color(38, cells_[at]);
      const bool hasLower = row + 1 < rows_;
      const std::string lower = hasLower ? color(48, cells_[at + std::size_t(columns_)]) : "";
      if (upper != lastUpper) text += upper;
      if (lower != lastLower) text += lower;
      text += kUpperHalf;
      lastUpper = upper;
      lastLower = lower;
    }
    text += "\033[0m\n";
  }
  return text;
}
