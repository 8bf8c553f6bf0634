// TerminalPicture: a picture in coloured characters, each of which shows two cells one above the
// other: the upper half block U+2580 in the colour of the upper one, before that of the lower one.
#pragma once
#include <string>
#include <vector>

#include "image/image.h"

/// Columns and lines of a terminal.
struct TerminalSize {
  int columns, lines;
};

/// The size of the window that file descriptor `terminal` is; where it is none, what COLUMNS and
/// LINES say; 80 x 24 where they do not.
TerminalSize terminalSize(int terminal);

class TerminalPicture {
 public:
  /// For a picture of so many pixels, made smaller (never larger) as far as it does not fit into
  /// the terminal, two lines of which are left free.
  TerminalPicture(int width, int height, const TerminalSize& terminal);

  int lines() const { return (rows_ + 1) / 2; }

  /// Adds the pixels left <= i < right, bottom <= j < top of the picture, each of them once.
  void add(const Image& image, int left, int bottom, int right, int top);
  /// The whole of it, with a line break behind each line: each cell the mean of its pixels so far.
  std::string text() const;

 private:
  struct Cell {
    double red = 0, green = 0, blue = 0, pixels = 0;
  };
  /// The sequence for 24-bit colour: `kind` is 38 for what is drawn, 48 for what is behind it.
  static std::string color(int kind, const Cell& cell);

  int width_, height_, columns_, rows_;
  std::vector<Cell> cells_;  // row by row from the top
};
